#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: window_test.sh [MESH]
#
# Uses the plugin in MeshLab's window as a person would, in each release that scripts/test has prepared: opens a mesh (by
# default the project's sample), finds the filter by Ctrl+F, applies it, shows the directions, and leaves pictures of each
# step in screenshots in the build's folder. It fails where MeshLab's log does not say what it should. Exit status 77: not
# run, with the reason.
set -euo pipefail
here=$(dirname -- "${BASH_SOURCE[0]}")
source "$here/../../../scripts/lib/all.sh"
source "$here/meshlab_window.sh"

FILTER_NAME='Compute Curvature by Integral Invariants per Vertex'

# press_button QUARTERS: of the dialog's last row of buttons, the one at so many quarters of the width: Close at 1, Apply at
# 3. By the mouse, because Return does not reach them in 2020.09.
press_button() {
  local WIDTH HEIGHT
  eval "$(xdotool getwindowgeometry --shell "$dialog" | grep -E '^(WIDTH|HEIGHT)=[0-9]+$')"
  xdotool mousemove --window "$dialog" $((WIDTH * $1 / 4)) $((HEIGHT - 22)) click 1
}

# Without scrolling, on a screen of 1920 x 1080: the dialog's buttons are in its last row.
dialog_fits() {
  local WIDTH HEIGHT
  eval "$(xdotool getwindowgeometry --shell "$dialog" | grep -E '^(WIDTH|HEIGHT)=[0-9]+$')"
  note "the dialog is $WIDTH x $HEIGHT pixels"
  ((HEIGHT <= 1080)) || fail_with_picture "the dialog is $HEIGHT pixels high: its buttons are below the screen"
}

dialog_is_closed() { ! find_dialog "$FILTER_NAME"; }

show_release() {
  local release=$1
  note "MeshLab $release"
  start_meshlab "$release" "$mesh"
  choose "$FILTER_NAME" "$release-1-search"
  wait_until 20 "the filter's dialog" find_dialog "$FILTER_NAME"
  sleep 1
  dialog_fits
  window_picture "$dialog" "$release-2-dialog"
  press_button 3
  wait_until 120 "the filter to be applied" logged "Applied filter"
  logged "Curvature by integral invariants" || fail_with_picture "the filter's summary is not in the log"
  press_button 1
  wait_until 20 "the dialog to close" dialog_is_closed
  sleep 1
  picture "$release-3-result"
  # The search ranks by the words of the explanation, and "Show Curvature" is in that of the filter too.
  choose "draw vertex/face curvature"
  wait_until 20 "the directions to be shown" logged "Show Curvature"
  sleep 1
  picture "$release-4-directions"
  kill -0 "$meshlab_pid" || fail_with_picture "MeshLab $release has ended"
  stop_meshlab
}

releases=()
if [[ -x $MESHLAB_2020_09/bin/meshlab ]]; then releases+=(2020.09); fi
if [[ -x $(host_build_dir 2025.07)/runner/meshlab_script_runner ]]; then releases+=(2025.07); fi
if [[ ${#releases[@]} == 0 ]]; then
  echo "not run: there is no MeshLab; scripts/test makes it"
  exit 77
fi
output=$II_BUILD/screenshots
mkdir -p "$output"
new_work_folder work
mesh=$(realpath -- "${1:-$work/sample.ply}")
if [[ $# == 0 ]]; then
  "$II_BUILD/samples/sample_mesh" "$mesh" 0.04 >/dev/null # coarser than usual, so that single directions can be seen
fi
start_screen
openbox >/dev/null 2>&1 &
for release in "${releases[@]}"; do
  rm -f "$output/$release"-*.png
  show_release "$release"
  for picture in 1-search 2-dialog 3-result 4-directions; do [[ -s $output/$release-$picture.png ]]; done
done
note "pictures are in $output"
