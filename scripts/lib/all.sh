# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# All that scripts are made of.
for II_PART in lib/{common,packages,screen,build,filter_run} hosts/{debian_archive,meshlab_source,meshlab_2020_09,later_releases,pymeshlab}; do
  # shellcheck source=/dev/null
  source "$(dirname -- "${BASH_SOURCE[0]}")/../$II_PART.sh"
done
