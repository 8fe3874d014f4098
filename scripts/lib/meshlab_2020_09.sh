# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# MeshLab 2020.09 of this machine with the project's plugin, in a prefix of its own. Needs common.sh.

# make_meshlab_2020_09 PREFIX PLUGIN.so: PREFIX/bin/meshlab and meshlabserver load the machine's plugins and PLUGIN.so.
# The programs look for plugins from where they stand, so they are copied and the libraries linked; /usr is not touched.
make_meshlab_2020_09() {
  local prefix=$1 plugin=$2 server=/usr/bin/meshlabserver installed private
  [[ -x $server ]] ||
    die "there is no meshlabserver here: only MeshLab up to 2020.09 has it (Debian 12, Ubuntu 22.04)."
  if [[ -x $prefix/bin/meshlabserver && ! $server -nt $prefix/bin/meshlabserver ]]; then return; fi
  installed=$(dirname -- "$(dpkg -L meshlab | grep '/libmeshlab-common.so$')")
  private=$prefix/${installed#/usr/}
  rm -rf -- "$prefix"
  mkdir -p "$prefix/bin" "$private/plugins"
  ln -s "$installed"/*.so "$private/"
  ln -s "$installed"/plugins/* "$plugin" "$private/plugins/"
  cp /usr/bin/meshlab "$prefix/bin/"
  cp "$server" "$prefix/bin/" # last, because it is what shows that the prefix is complete
}
