# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# MeshLab 2020.09 of this machine with the project's plugin, in a prefix of its own. Needs common.sh, packages.sh,
# build.sh, meshlab_source.sh.

MESHLAB_2020_09=$II_BUILD/meshlab-2020.09

# build_for_meshlab_2020_09 TARGET...: these, the plugin and the writer of scripts in II_BUILD, and the prefix.
build_for_meshlab_2020_09() {
  require_packages "${PACKAGES_BUILD[@]}" "${PACKAGES_MESHLAB[@]}"
  fetch_meshlab_source 2020.09
  configure_once release "$II_BUILD" "-DMESHLAB_SOURCE_DIR=$(meshlab_source_dir 2020.09)" -DII_BUILD_TESTS=OFF -DII_BUILD_BENCHMARKS=OFF
  build "$II_BUILD" filter_feature_adapted_ii write_filter_script "$@"
  make_meshlab_2020_09
}

# make_meshlab_2020_09: $MESHLAB_2020_09/bin/meshlab and meshlabserver load the machine's plugins and the project's.
make_meshlab_2020_09() {
  local server=/usr/bin/meshlabserver
  [[ -x $server ]] ||
    die "there is no meshlabserver here: only MeshLab up to 2020.09 has it (Debian 12, Ubuntu 22.04)."
  if [[ ! -x $MESHLAB_2020_09/bin/meshlabserver || $server -nt $MESHLAB_2020_09/bin/meshlabserver ||
    ! $MESHLAB_2020_09/plugin.so -ef $II_BUILD/$PLUGIN ]]; then
    locked "$II_BUILD" fill_meshlab_2020_09
  fi
}

# The programs look for plugins from where they stand, so they are copied and the libraries linked; /usr is not touched.
fill_meshlab_2020_09() {
  local installed private
  installed=$(dirname -- "$(dpkg -L meshlab | grep '/libmeshlab-common.so$')")
  private=$MESHLAB_2020_09/${installed#/usr/}
  rm -rf -- "$MESHLAB_2020_09"
  mkdir -p "$MESHLAB_2020_09/bin" "$private/plugins"
  ln -s "$installed"/*.so "$private/"
  ln -s "$installed"/plugins/* "$II_BUILD/$PLUGIN" "$private/plugins/"
  ln -s "$II_BUILD/$PLUGIN" "$MESHLAB_2020_09/plugin.so"
  cp /usr/bin/meshlab "$MESHLAB_2020_09/bin/"
  cp /usr/bin/meshlabserver "$MESHLAB_2020_09/bin/" # last, because it is what shows that the prefix is complete
}
