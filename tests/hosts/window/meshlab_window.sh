# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# MeshLab's window on a virtual screen, driven as a person would. Needs all.sh.

# wait_until SECONDS WHAT COMMAND...: until COMMAND succeeds; WHAT is for the sentence when it never does.
wait_until() {
  local tries=$(($1 * 5)) what=$2
  shift 2
  until "$@"; do
    ((tries-- > 0)) || fail_with_picture "waited in vain for $what"
    sleep 0.2
  done
}

fail_with_picture() {
  scrot -o "$output/failure.png" || true
  die "$*; the screen is in $output/failure.png, MeshLab's messages in $log"
}

logged() { grep -qF -- "$1" "$log"; }

# start_meshlab RELEASE MESH: MeshLab's own settings and plugins come from a home folder of this run alone.
start_meshlab() {
  local release=$1 mesh=$2 home=$work/home-$1
  log=$work/$release.log
  : >"$log"
  mkdir -p "$home" "$work/runtime"
  chmod 700 "$work/runtime"
  if [[ $release == 2020.09 ]]; then
    HOME=$home XDG_RUNTIME_DIR=$work/runtime "$MESHLAB_2020_09/bin/meshlab" "$mesh" >"$log" 2>&1 &
  else
    install_user_plugin "$release" "$home"
    HOME=$home XDG_RUNTIME_DIR=$work/runtime "$II_ROOT/scripts/hosts/run_in_host" "$release" meshlab "$mesh" >"$log" 2>&1 &
  fi
  meshlab_pid=$!
  wait_until 60 "the mesh to be opened" logged "All files opened"
  wait_until 20 "the main window" find_main_window
  xdotool windowsize --sync "$main_window" 1480 1250 windowmove "$main_window" 5 25
  sleep 1
}

# Where MeshLab puts what Help > Plugin Info > Load Plugins is given.
install_user_plugin() {
  local folder=$2/.local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/$1
  mkdir -p "$folder"
  cp "$(host_build_dir "$1")/$PLUGIN" "$folder/"
}

stop_meshlab() {
  kill "$meshlab_pid" 2>/dev/null || true
  wait "$meshlab_pid" 2>/dev/null || true
}

find_main_window() {
  main_window=$(xdotool search --onlyvisible --name '^MeshLab 20' 2>/dev/null | head -n 1)
  [[ -n $main_window ]]
}

# find_dialog TITLE: the window of that name that is not the main one.
find_dialog() {
  dialog=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | grep -vx "$main_window" | head -n 1)
  [[ -n $dialog ]]
}

# choose ACTION: by MeshLab's search field, which Ctrl+F opens.
choose() {
  xdotool windowactivate --sync "$main_window"
  sleep 0.4
  xdotool key ctrl+f
  sleep 0.6
  xdotool type --delay 15 "$1"
  sleep 0.8
  if [[ -n ${2:-} ]]; then picture "$2"; fi
  xdotool key Down
  sleep 0.2
  xdotool key Return
}

picture() { scrot -o "$output/$1.png"; }

# window_picture WINDOW NAME: that window alone, with its frame.
window_picture() {
  xdotool windowactivate --sync "$1"
  sleep 0.4
  scrot -o -u -b "$output/$2.png"
}
