# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Builds of the plugin, and of the runner, for MeshLab releases other than this machine's. Needs common.sh, build.sh,
# meshlab_source.sh, host_root.sh.

host_build_dir() { printf '%s/hosts/%s\n' "$II_BUILD" "$1"; }

# build_for_host RELEASE: plugin and runner in $(host_build_dir RELEASE). The release's library is that of its root.
build_for_host() {
  local release=$1 folder library
  folder=$(host_build_dir "$release")
  library=$(echo "$(host_root_dir "$release")"/usr/lib/*/meshlab/libmeshlab-common.so)
  configure_build_once "$folder" "$(meshlab_source_dir "$release")" -DII_BUILD_TESTS=OFF -DII_BUILD_BENCHMARKS=OFF \
    "-DMESHLAB_COMMON_LIBRARY=$library"
  build "$folder" filter_feature_adapted_ii meshlab_script_runner
}

# build_for_pymeshlab: the plugin for PyMeshLab 2025.7, whose meshes are of double precision.
build_for_pymeshlab() {
  local folder
  folder=$(host_build_dir 2025.07-double)
  configure_build_once "$folder" "$(meshlab_source_dir 2025.07)" -DII_BUILD_TESTS=OFF -DII_BUILD_BENCHMARKS=OFF \
    -DMESHLAB_SCALAR=double
  build "$folder" filter_feature_adapted_ii
}
