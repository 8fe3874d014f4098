# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Later MeshLab releases on a machine whose own MeshLab is another: the packages of another Debian suite, unpacked into a
# folder, whose programs run with that folder's own libraries, and builds of the plugin and the runner for them. No root
# rights, no chroot. Needs common.sh, build.sh, debian_archive.sh, meshlab_source.sh.

host_root_dir() { printf '%s/root-%s\n' "$II_CACHE" "$1"; }

# make_host_root RELEASE: the root is in $(host_root_dir RELEASE) afterwards.
make_host_root() {
  local release=$1
  [[ $release != 2020.09 && -n ${MESHLAB_SUITE[$release]:-} ]] || die "roots are made for 2022.02 and 2025.07, not for $release."
  make_once "$(host_root_dir "$release")" unpack_host_root "$release"
}

unpack_host_root() {
  local release=$1 folder=$2 suite=${MESHLAB_SUITE[$1]} apt=$2/apt archive recommended version
  note "fetching MeshLab $release and its libraries from Debian's $suite (about 100 MB)"
  mkdir "$apt"
  open_debian_archive "$apt" deb "$suite"
  version=$(private_apt "$apt" apt-cache madison meshlab | awk '{print $3}' | grep "^${release%%.*}\." | sort -V | tail -n 1)
  [[ -n $version ]] || die "Debian's $suite has no MeshLab ${release%%.*} any more."
  # Where a recommended library is missing, MeshLab reports plugins that do not load and skips the user's own.
  recommended=$(private_apt "$apt" apt-cache depends meshlab | sed -n 's/^  Recommends: \(lib.*\)/\1/p' | grep -v -- -gles)
  # shellcheck disable=SC2086  # one word a package
  private_apt "$apt" apt-get -y --no-install-recommends --download-only install "meshlab=$version" $recommended \
    libgl1-mesa-dri fonts-dejavu-core >"$apt/install.log" 2>&1 ||
    die "cannot fetch MeshLab $version: $(grep -m 1 '^E:' "$apt/install.log")"
  for archive in "$apt"/cache/archives/*.deb; do dpkg-deb -x "$archive" "$folder"; done
  rm -rf -- "$apt" "$folder"/usr/share/{doc,man,locale}
  mkdir -p "$folder/etc/fonts"
  # Started by the loader, MeshLab takes the loader's folder for its own, and looks for its plugins there.
  ln -s meshlab/plugins "$(dirname -- "$(echo "$folder"/usr/lib/*/meshlab)")/plugins"
}

# run_in_host_root RELEASE PROGRAM ARGUMENTS...: PROGRAM is a path, or a name in the root's usr/bin. Replaces this shell.
run_in_host_root() {
  local release=$1 program=$2 root libraries loader
  shift 2
  root=$(host_root_dir "$release")
  libraries=$(dirname -- "$(echo "$root"/usr/lib/*/meshlab)")
  loader=$(echo "$root"/usr/lib*/ld-linux*.so.*)
  [[ $program == */* ]] || program=$root/usr/bin/$program
  write_fonts_conf "$root"
  export QT_PLUGIN_PATH=$libraries/qt5/plugins LIBGL_DRIVERS_PATH=$libraries/dri FONTCONFIG_FILE=$root/etc/fonts/host.conf
  export QT_XKB_CONFIG_ROOT=$root/usr/share/X11/xkb XDG_DATA_DIRS=$root/usr/share
  exec "$loader" --inhibit-cache --library-path "$libraries:$libraries/meshlab" "$program" "$@"
}

# The root's own fonts, by the place where it stands now; the machine may have none.
write_fonts_conf() {
  local file=$1/etc/fonts/host.conf
  if [[ -f $file ]] && grep -qF "<dir>$1/" "$file"; then return; fi
  printf '<?xml version="1.0"?>\n<fontconfig><dir>%s/usr/share/fonts</dir><cachedir prefix="xdg">fontconfig</cachedir></fontconfig>\n' \
    "$1" >"$file.$$"
  mv "$file.$$" "$file"
}

host_build_dir() { printf '%s/hosts/%s\n' "$II_BUILD" "$1"; }

# build_for_release RELEASE: its root, and plugin and runner in $(host_build_dir RELEASE), linked to the root's library.
build_for_release() {
  local release=$1 folder library
  fetch_meshlab_source "$release"
  make_host_root "$release"
  folder=$(host_build_dir "$release")
  library=$(echo "$(host_root_dir "$release")"/usr/lib/*/meshlab/libmeshlab-common.so)
  configure_once release "$folder" "-DMESHLAB_SOURCE_DIR=$(meshlab_source_dir "$release")" -DII_BUILD_TESTS=OFF \
    -DII_BUILD_BENCHMARKS=OFF "-DMESHLAB_COMMON_LIBRARY=$library"
  build "$folder" filter_feature_adapted_ii meshlab_script_runner write_filter_script
}

# build_for_pymeshlab: the plugin for PyMeshLab 2025.7, whose meshes are of double precision.
build_for_pymeshlab() {
  local folder
  fetch_meshlab_source 2025.07
  folder=$(host_build_dir 2025.07-double)
  configure_once release "$folder" "-DMESHLAB_SOURCE_DIR=$(meshlab_source_dir 2025.07)" -DII_BUILD_TESTS=OFF \
    -DII_BUILD_BENCHMARKS=OFF -DMESHLAB_SCALAR=double
  build "$folder" filter_feature_adapted_ii
}
