# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Builds with CMake. Needs common.sh.

II_BUILD=$(realpath -m -- "${II_BUILD:-$II_ROOT/build/release}")

# configure_build FOLDER MESHLAB_SOURCE_DIR CMAKE_ARGUMENT...: configures.
# configure_build_once: the same, unless the folder was configured with these MeshLab sources before, however else.
configure_build() {
  local folder=$1 sources=$2 launcher=()
  shift 2
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  mkdir -p "$folder"
  cmake -G Ninja -S "$II_ROOT" -B "$folder" -DCMAKE_BUILD_TYPE=Release "-DMESHLAB_SOURCE_DIR=$sources" \
    "${launcher[@]}" "$@" >"$folder/configure.log" 2>&1 ||
    die "cmake cannot configure the build; see $folder/configure.log: $(grep -m 1 -A 3 'CMake Error' "$folder/configure.log")"
}

configure_build_once() {
  if [[ ! -f $1/build.ninja ]] || ! grep -qxF "MESHLAB_SOURCE_DIR:PATH=$2" "$1/CMakeCache.txt"; then
    configure_build "$@"
  fi
}

# build FOLDER TARGET...: shows only what goes wrong, and one line where there was something to do.
build() {
  local folder=$1
  shift
  if ninja -C "$folder" -n "$@" | grep -q 'no work to do'; then return; fi
  note "building $*"
  ninja -C "$folder" "$@" >"$folder/build.log" 2>&1 ||
    die "the build failed; see $folder/build.log: $(grep -m 1 'error:' "$folder/build.log" || tail -n 2 "$folder/build.log")"
}
