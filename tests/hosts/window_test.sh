#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# scripts/gui_screenshots for every release whose MeshLab is here: it fails where MeshLab's log does not say what it
# should. Exit status 77: not run, with the reason.
set -euo pipefail
source_folder=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
build=${II_BUILD:-$source_folder/build/release}
releases=()
if [[ -x $build/meshlab-2020.09/bin/meshlab ]]; then releases+=(2020.09); fi
if [[ -x $build/hosts/2025.07/runner/meshlab_script_runner ]]; then releases+=(2025.07); fi
if [[ ${#releases[@]} == 0 ]]; then
  echo "not run: there is no MeshLab; scripts/test makes it"
  exit 77
fi
"$source_folder/scripts/gui_screenshots" -o "$build/screenshots" "${releases[@]}"
for release in "${releases[@]}"; do
  for picture in 1-search 2-dialog 3-result 4-directions; do [[ -s $build/screenshots/$release-$picture.png ]]; done
done
