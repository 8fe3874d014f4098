#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the example of docs/scripting.md in the real PyMeshLab and compares every array with the core's.
# Usage: pymeshlab_test.sh CORE_CURVATURE SAMPLE_MESH. Exit status 77: not run, with the reason.
set -euo pipefail
source_folder=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
source "$source_folder/scripts/lib/all.sh"
core_curvature=$1
sample_mesh=$2

not_run() {
  echo "not run: $*"
  exit 77
}

new_work_folder folder
plugin=${II_BUILD:-$II_ROOT/build/release}/hosts/2025.07-double/filter_feature_adapted_ii/libfilter_feature_adapted_ii.so
[[ -f $plugin ]] || not_run "there is no $plugin; scripts/test makes it"
# In a shell of its own: the end of make_pymeshlab by die must not end this one.
(make_pymeshlab) 2>"$folder/log" || not_run "$(tail -n 1 "$folder/log")"

"$sample_mesh" "$folder/mesh.ply" 0.06
"$core_curvature" "$folder/mesh.ply" "$folder/core" scales=6 r_max=0.3
"$(pymeshlab_dir)/bin/python" "$source_folder/tests/hosts/pymeshlab_test.py" "$source_folder/docs/scripting.md" "$plugin" \
  "$folder/mesh.ply" "$folder/core"
