# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# PyMeshLab in a virtual environment of its own. Needs common.sh.

PYMESHLAB_VERSION=2025.7.post1

pymeshlab_dir() { printf '%s/pymeshlab-%s\n' "$II_CACHE" "$PYMESHLAB_VERSION"; }

# make_pymeshlab: $(pymeshlab_dir)/bin/python has PyMeshLab and numpy afterwards.
make_pymeshlab() { make_once "$(pymeshlab_dir)" fill_pymeshlab; }

fill_pymeshlab() {
  local folder=$1
  note "fetching PyMeshLab $PYMESHLAB_VERSION"
  /usr/bin/python3 -m venv "$folder" >"$folder.log" 2>&1 || die "cannot make a virtual environment: $(tail -n 1 "$folder.log")"
  "$folder/bin/python" -m pip -q install --only-binary :all: "pymeshlab==$PYMESHLAB_VERSION" numpy >"$folder.log" 2>&1 ||
    die "cannot install PyMeshLab: $(grep -m 1 ERROR "$folder.log" || tail -n 1 "$folder.log")"
  rm -f "$folder.log"
}
