# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# shellcheck disable=SC2034  # the programs are used by the scripts
# Builds with CMake. Needs common.sh.

PLUGIN=filter_feature_adapted_ii/libfilter_feature_adapted_ii.so # in the folder of a build
WRITER=$II_BUILD/filter_feature_adapted_ii/write_filter_script
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi

# configure PRESET FOLDER ARGUMENT...: configures by that preset of CMakePresets.json.
configure() {
  local preset=$1 folder=$2 fresh=()
  shift 2
  if made_elsewhere "$folder"; then
    [[ $folder == "$II_ROOT"/* ]] ||
      die "the folder $folder is the build of another checkout. Name another folder in the environment variable II_BUILD."
    note "the build in $folder was made at another place; it is made anew"
    fresh=(--fresh)
  fi
  locked "$folder" cmake -S "$II_ROOT" --preset "$preset" -B "$folder" "${fresh[@]}" "$@" ||
    die "cmake cannot configure the build; see $folder/log: $(grep -m 1 -A 3 'CMake Error' "$folder/log")"
}

# configure_once: the same, where the folder was not configured before; for another MeshLab than the first ARGUMENT names,
# by this argument alone.
configure_once() {
  if [[ ! -f $2/build.ninja ]] || made_elsewhere "$2"; then
    configure "$@"
  elif ! grep -qxF -- "${3#-D}" <(sed 's/:[A-Z]*=/=/' "$2/CMakeCache.txt"); then
    configure "${@:1:3}"
  fi
}

# made_elsewhere FOLDER: whether it was configured for a project, or as a folder, at another place.
made_elsewhere() {
  local cache=$1/CMakeCache.txt
  [[ -f $cache ]] && { ! [[ $(sed -n 's/^CMAKE_HOME_DIRECTORY:.*=//p' "$cache") -ef $II_ROOT ]] ||
    ! [[ $(sed -n 's/^CMAKE_CACHEFILE_DIR:.*=//p' "$cache") -ef $1 ]]; }
}

# build FOLDER TARGET...: shows only what goes wrong, and one line where there was something to do.
build() {
  local folder=$1
  shift
  if ninja -C "$folder" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return; fi
  note "building $*"
  locked "$folder" ninja -C "$folder" "$@" ||
    die "the build failed; see $folder/log: $(grep -m 1 'error:' "$folder/log" || tail -n 2 "$folder/log")"
}

# locked FOLDER COMMAND...: runs it, its output in FOLDER/log, while no other script does the same in that folder.
locked() {
  local folder=$1 foreign
  shift
  mkdir -p -- "$folder" 2>/dev/null || true
  foreign=$(find "$folder" -maxdepth 1 ! -writable -print -quit 2>&1)
  [[ -z $foreign ]] || die "the build folder $folder cannot be written: it is read-only or another user's. Name a folder of" \
    "your own in the environment variable II_BUILD (and in II_CACHE one for what is fetched)."
  {
    flock -n 9 || { note "another run is building in $folder; waiting for it" && run_job flock 9; }
    run_job "$@" >"$folder/log" 2>&1 9>&-
  } 9>>"$folder/.lock"
}

# build_preset CONFIGURE_PRESET BUILD_PRESET: both of CMakePresets.json, in the folder that they name.
build_preset() {
  local folder=$II_ROOT/build/$1
  cd "$II_ROOT"
  configure "$1" "$folder"
  note "building $2"
  locked "$folder" cmake --build --preset "$2" || die "the build failed; see $folder/log: $(grep -m 1 'error:' "$folder/log" || tail -n 2 "$folder/log")"
}
