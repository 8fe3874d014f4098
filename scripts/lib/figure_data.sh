# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# shellcheck disable=SC2154  # data and the meshes are set by scripts/figures
# What the figures show: runs of the filters, kept in $data. Needs common.sh, filter_run.sh, and the variables data,
# armadillo, lucy and buddha.

# in_edges MESH FACTOR: that many average edge lengths, in the unit of the mesh.
in_edges() { "$II_ROOT/scripts/lib/paper_figures.py" edge "$1" "$2"; }

# once NAME MESH PARAMETER=VALUE...: the export of a run as $data/NAME.ply, and its log as $data/NAME.log.
once() {
  local name=$1 mesh=$2
  shift 2
  if [[ -s $data/$name.ply && -s $data/$name.log ]]; then return; fi
  note "computing $name"
  # The figures are the paper's, so the method is: its estimator and its radius, unless a run asks for another.
  local published=(estimator=0 scales=8 radius_choice=0)
  if [[ $1 == --filter ]]; then set -- "$1" "$2" "${published[@]}" "${@:3}"; else set -- "${published[@]}" "$@"; fi
  run_filter "$mesh" "$data/$name.ply" "$@" >"$data/$name.log.part"
  mv "$data/$name.log.part" "$data/$name.log"
}

# What the filter does by default, where `published` above says otherwise.
BY_DEFAULT=(radius_choice=2 estimator=2 scales=7)

# all_radii NAME MESH SMALL LARGE PARAMETER...: the same run with a small, a large and an adapted radius (in edges), and
# as the plugin does it by default.
all_radii() {
  local name=$1 mesh=$2 small large
  small=$(in_edges "$2" "$3")
  large=$(in_edges "$2" "$4")
  shift 4
  once "${name}_small" "$mesh" "$@" radius_choice=1 "radius=$small"
  once "${name}_large" "$mesh" "$@" radius_choice=1 "radius=$large"
  once "${name}_adapted" "$mesh" "$@" "r_min=$small" "r_max=$large"
  once "${name}_statistical" "$mesh" "$@" "${BY_DEFAULT[@]}"
}

# The statue at the resolution of the paper's; with noise of a fifth of an edge along the normals.
make_buddha() {
  local small=$data/buddha_small.ply
  if [[ ! -s $small ]]; then
    note "simplifying the Buddha"
    "$II_ROOT/scripts/lib/paper_figures.py" simplify "$buddha" 150000 "$small"
  fi
  if [[ ! -s $data/buddha_noisy.ply ]]; then "$II_ROOT/scripts/lib/paper_figures.py" noise "$small" 0.2 "$data/buddha_noisy.ply"; fi
}

compute_figure_data() {
  all_radii armadillo "$armadillo" 2 8
  all_radii armadillo_directions "$armadillo" 2 8 --filter create_principal_direction_layer style=1 maximal=true \
    "spacing=$(in_edges "$armadillo" 1.6)" "segment_length=$(in_edges "$armadillo" 1.5)" umbilic=0
  all_radii armadillo_features "$armadillo" 2 8 --filter select_ridges_and_valleys_by_curvature high_percentile=92 \
    low_percentile=82
  once armadillo_crest "$armadillo" --filter create_crest_lines_layer "${BY_DEFAULT[@]}" minimum_strength=3
  once armadillo_lines "$armadillo" --filter create_principal_direction_layer minimal=true \
    "r_min=$(in_edges "$armadillo" 2)" "r_max=$(in_edges "$armadillo" 8)" "spacing=$(in_edges "$armadillo" 2.5)"
  all_radii lucy "$lucy" 2 8
  make_buddha
  all_radii buddha_noisy_curvature "$data/buddha_noisy.ply" 3 10
  once buddha_noisy_unsmoothed "$data/buddha_noisy.ply" "r_min=$(in_edges "$data/buddha_noisy.ply" 3)" \
    "r_max=$(in_edges "$data/buddha_noisy.ply" 10)" smooth_radius=false
  once buddha_noisy_smoothed "$data/buddha_noisy.ply" "r_min=$(in_edges "$data/buddha_noisy.ply" 3)" \
    "r_max=$(in_edges "$data/buddha_noisy.ply" 10)" smoothing_passes=10
  once buddha_clean_curvature "$data/buddha_small.ply" "r_min=$(in_edges "$data/buddha_small.ply" 3)" \
    "r_max=$(in_edges "$data/buddha_small.ply" 10)"
  once times_armadillo_surface "$armadillo" engine=1
  once times_armadillo_fft "$armadillo" engine=0
  once times_lucy_surface "$lucy" engine=1
  once times_lucy_fft "$lucy" engine=0
  once times_buddha_surface "$buddha" engine=1
  once times_buddha_fft "$buddha" engine=0
}

# table_row LABEL LOG PAPER: vertices, seconds of the moments, seconds in all.
table_row() {
  local vertices moments total
  [[ -s $data/$2.log ]] || return 0
  vertices=$(sed -n 's/^Mesh: \([0-9]*\) vertices.*/\1/p' "$data/$2.log" | head -n 1)
  total=$(sed -n 's/^Time: \([0-9.]*\) s.*/\1/p' "$data/$2.log" | head -n 1)
  moments=$(sed -n 's/^Time: .*ball moments \([0-9.]*\) s.*/\1/p' "$data/$2.log" | head -n 1)
  echo "| $1 | $vertices | $moments | $total | $3 |"
}

write_times_table() {
  echo "Seconds for 8 scales, radii from 1 to 8 average edges, all processors of: $(sed -n 's/^model name.*: //p' /proc/cpuinfo |
    head -n 1) ($(nproc) processors). The paper's machine was a laptop with a Core 2 Duo at 2 GHz; its meshes were not these."
  echo
  echo "| mesh, engine | vertices | ball moments, s | in all, s | paper's, s [Lai09, Table 1] |"
  echo "|---|---|---|---|---|"
  table_row "Armadillo, surface integral" times_armadillo_surface ""
  table_row "Armadillo, voxels and FFT" times_armadillo_fft 82
  table_row "Lucy, surface integral" times_lucy_surface ""
  table_row "Lucy, voxels and FFT" times_lucy_fft 114
  table_row "Happy Buddha, surface integral" times_buddha_surface ""
  table_row "Happy Buddha, voxels and FFT" times_buddha_fft 113
}
