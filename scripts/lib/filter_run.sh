# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# One run of the filter by the real meshlabserver, and the picture of its result. Needs common.sh, build.sh.

# run_filter MESH OUT.ply [PARAMETER=VALUE ...]: absolute paths. Prints the filter's summary on stdout and leaves the
# script that was run in $II_BUILD/filter.mlx.
run_filter() {
  local mesh=$1 output=$2 folder status=0
  shift 2
  # Beside the output, so that it appears complete or not at all.
  folder=$(mktemp -d -p "$(dirname -- "$output")" .curvature.XXXXXX 2>/dev/null) ||
    die "cannot write into the folder $(dirname -- "$output")."
  # shellcheck disable=SC2064  # the folder of now
  trap "rm -rf -- '${folder//\'/\'\\\'\'}'" EXIT
  write_script "$folder" "$@"
  run_meshlabserver "$mesh" "$folder" || status=$?
  if ((status != 0)) || [[ ! -s $folder/export.ply ]]; then
    cat -- "$folder/log" "$folder/messages" >"$II_BUILD/meshlabserver.log"
    die "$(failure_reason "$folder" "$status") [log: $II_BUILD/meshlabserver.log]"
  fi
  filter_log "$folder"
  cp -- "$folder/filter.mlx" "$II_BUILD/filter.mlx"
  mv -f -- "$folder/export.ply" "$output" || die "cannot write $output."
}

write_script() {
  local folder=$1 parameter
  shift
  for parameter in "$@"; do
    [[ $parameter != export_file=* ]] || die "the output is named by the second argument, not by export_file."
  done
  "$II_BUILD/filter_feature_adapted_ii/write_filter_script" "$@" "export_file=$folder/export.ply" >"$folder/filter.mlx" \
    2>"$folder/refusal" || die "$(sed 's/^write_filter_script: //' "$folder/refusal")"
}

# meshlabserver prints the filter's log among its own words on stdout; Qt's messages have it line by line.
run_meshlabserver() {
  local mesh=$1 folder=$2
  QT_ASSUME_STDERR_HAS_CONSOLE=1 QT_LOGGING_RULES='*.debug=true' \
    xvfb-run -a stdbuf -o0 "$II_BUILD/meshlab-2020.09/bin/meshlabserver" -i "$mesh" -s "$folder/filter.mlx" \
    2>"$folder/messages" | tee "$folder/log" | show_progress
}

filter_log() { sed -n '/^LOG: [0-9]* Exported: /d; s/^LOG: [0-9]* //p' "$1/messages"; }

failure_reason() {
  local folder=$1 status=$2 reason
  reason=$(filter_log "$folder" | tail -n 1)
  if grep -q 'not possible to import mesh' "$folder/log"; then
    echo "MeshLab cannot read the mesh (is it damaged, or of another format than its name says?)"
  elif [[ -n $reason ]]; then
    echo "the filter refused: $reason"
  elif ((status > 128)); then
    echo "meshlabserver was ended by signal $((status - 128)): $(tail -n 1 "$folder/messages")"
  else
    echo "meshlabserver failed with status $status: $(tail -n 1 "$folder/log")"
  fi
}

# show_progress: meshlabserver's output in; out, on one line of the terminal, its lines that are reports of progress.
show_progress() {
  local line
  while IFS= read -r line; do
    if [[ -t 2 && $line =~ ^(.*):\ ([0-9]+)%$ ]]; then
      printf '\r\033[K%3d %%  %s' "${BASH_REMATCH[2]}" "${BASH_REMATCH[1]}" >&2
    fi
  done
  if [[ -t 2 ]]; then printf '\r\033[K' >&2; fi
}

# draw_picture OUT.ply OUT.png: of the quality that the last filter script asked for.
draw_picture() {
  local script=$II_BUILD/filter.mlx choice name percentile
  choice=$(script_value quality)
  percentile=$(script_value color_percentile)
  name=$(sed -n "s/.* name=\"quality\" .* enum_val$choice=\"\([^\"]*\)\".*/\1/p" "$script")
  # shellcheck disable=SC2086  # options of the user's, one word each
  xvfb-run -a "$II_ROOT/scripts/render_curvature.py" "$1" "$2" --quality-is "$name" --percentile "$percentile" \
    ${II_RENDER_OPTIONS:-} ||
    die "wrote $1, but not its picture."
}

script_value() { sed -n "s/.* name=\"$1\" value=\"\([^\"]*\)\".*/\1/p" "$II_BUILD/filter.mlx"; }
