# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# One run of the filter by the real meshlabserver, and the picture of its result. Needs common.sh, screen.sh, build.sh and
# hosts/meshlab_2020_09.sh.

IDLE_SECONDS=10 # of a reader, after which it is taken to wait for a click
REFUSED=255 # meshlabserver's exit status where a filter or a reader did

# run_filter MESH OUT [--filter NAME] [PARAMETER=VALUE ...]: absolute paths; without a name the filter that measures
# curvature. OUT is what the filter writes to its export_file, whose kind it tells by the end of the name. Prints the
# filter's summary on stdout and leaves the script that was run in $work/filter.mlx.
run_filter() {
  local mesh=$1 named=$1 output=$2 status=0
  shift 2
  new_work_folder work "$(dirname -- "$output")" # beside the output, so that it appears complete or not at all
  export=$work/export.${output##*.}
  write_script "$@"
  if [[ ${mesh,,} == *.obj ]]; then # MeshLab 2020.09 aborts on all that name their first vertex
    /usr/bin/python3 "$II_ROOT/scripts/lib/obj_to_ply.py" "$mesh" "$work/mesh.ply" 2>"$work/refusal" || die "$(tail -n 1 "$work/refusal")"
    mesh=$work/mesh.ply
  fi
  start_screen
  run_meshlabserver "$mesh" || status=$?
  if ((status != 0)) || [[ ! -s $export ]]; then die "$(failure_reason "$named" "$status")"; fi
  filter_log
  if [[ ${named,,} == *.ply && ${1:-} != --filter ]]; then keep_properties "$named"; fi # of others the mesh may be a layer of lines
  mv -f -T -- "$export" "$output" || die "cannot write $output."
}

# keep_properties MESH.ply: the export becomes that file with the results added.
keep_properties() {
  local reason
  reason=$(/usr/bin/python3 "$II_ROOT/scripts/lib/keep_properties.py" "$1" "$work/export.ply" "$work/kept.ply" 2>"$work/refusal") ||
    die "cannot write $output: $(tail -n 1 "$work/refusal")"
  if [[ -n $reason ]]; then note "of $1 there is in $output what MeshLab reads: $reason"; fi
  mv -f -T -- "$work/kept.ply" "$work/export.ply"
}

write_script() {
  local parameter
  for parameter in "$@"; do
    [[ $parameter != export_file=* ]] || die "the output is named by the second argument, not by export_file."
  done
  "$WRITER" "$@" "export_file=$export" >"$work/filter.mlx" 2>"$work/refusal" ||
    die "$(sed 's/^write_filter_script: //' "$work/refusal")"
}

# meshlabserver prints the filter's log among its own words on stdout; Qt's messages have it line by line. The language is
# nobody's: where the decimal mark is a comma, MeshLab would read 0.5 as 0.
run_meshlabserver() {
  local mesh=$1 server
  LC_ALL=C.UTF-8 QT_ASSUME_STDERR_HAS_CONSOLE=1 QT_LOGGING_RULES='*.debug=true' \
    stdbuf -o0 "$MESHLAB_2020_09/bin/meshlabserver" -i "$mesh" -s "$work/filter.mlx" >"$work/log" 2>"$work/messages" &
  server=$!
  end_where_a_window_waits "$server" &
  if [[ -t 2 ]]; then
    show_progress "$server"
  fi
  wait "$server" 2>/dev/null
}

mesh_is_loaded() { grep -q ' loaded has ' "$work/log"; }

# A reader that finds fault with a file may say so in a window, and waits for a click that nobody can make here.
end_where_a_window_waits() {
  local server=$1 idle=0 ticks before=
  while ((idle < IDLE_SECONDS)); do
    sleep 1
    ticks=$(cut -d ' ' -f 3,14,15 "/proc/$server/stat" 2>/dev/null) || return 0
    if mesh_is_loaded; then return; fi
    if [[ $ticks == "$before" ]]; then ((++idle)); else idle=0; fi
    before=$ticks
  done
  touch "$work/window"
  kill "$server"
}

filter_log() { sed -n '/^LOG: [0-9]* Exported: /d; s/^LOG: [0-9]* //p' "$work/messages"; }

# failure_reason MESH STATUS: in words; where they may not be enough, MeshLab's own are kept beside the output.
failure_reason() {
  local mesh=$1 status=$2 log=${output%.*}.log
  if [[ -e $work/window ]] || grep -q 'not possible to import mesh' "$work/log"; then
    echo "MeshLab cannot read the mesh $mesh. Is it damaged, or of another format than its name says? $READABLE"
    return
  elif ((status == REFUSED)) && [[ -n $(filter_log) ]]; then
    echo "the filter refused: $(filter_log | tail -n 1)"
    return
  fi
  cat -- "$work/log" "$work/messages" >"$log"
  if ! mesh_is_loaded; then
    echo "MeshLab's reader crashed (signal $((status - 128))) on the mesh $mesh. It is damaged or unusual: save it as PLY with another program. [log: $log]"
  else
    echo "MeshLab ended with status $status while the filter ran; the system ends programs where memory is short. [log: $log]"
  fi
}
READABLE="Formats that can be read: PLY, STL, OFF, OBJ, 3DS, DAE, CTM, X3D, WRL."

# show_progress SERVER: while it runs, the newest report of progress in its log, on one line of the terminal.
show_progress() {
  local line
  while IFS= read -r line; do
    if [[ $line =~ ^(.*):\ ([0-9]+)%$ ]]; then printf '\r\033[K%3d %%  %s' "${BASH_REMATCH[2]}" "${BASH_REMATCH[1]}" >&2; fi
  done < <(tail -f -s 0.1 -n +1 --pid="$1" "$work/log")
  printf '\r\033[K' >&2
}

# draw_picture OUT.ply OUT.png [OPTION ...]: of the quality that the last filter script asked for.
draw_picture() {
  local choice name
  choice=$(script_value quality)
  name=$(sed -n "s/.* name=\"quality\" .* enum_val$choice=\"\([^\"]*\)\".*/\1/p" "$work/filter.mlx")
  # shellcheck disable=SC2086  # options of the user's, one word each
  run_job "$II_ROOT/scripts/lib/pictures.py" "$1" "$work/picture.png" --quality-is "$name" \
    --percentile "$(script_value color_percentile)" "${@:3}" ${II_RENDER_OPTIONS:-} && mv -f -T -- "$work/picture.png" "$2" ||
    die "wrote $1, but not its picture."
}

script_value() { sed -n "s/.* name=\"$1\" value=\"\([^\"]*\)\".*/\1/p" "$work/filter.mlx"; }
