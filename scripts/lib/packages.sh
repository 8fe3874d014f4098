# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# shellcheck disable=SC2034  # the lists are the scripts'
# Debian packages that the scripts need, installed where they are missing. Needs common.sh.

PACKAGES_BUILD=(g++ cmake ninja-build pkg-config libfftw3-dev libeigen3-dev libglew-dev qtbase5-dev libqt5opengl5-dev
  debian-archive-keyring xz-utils)
PACKAGES_MESHLAB=(meshlab chemical-mime-data xvfb)
PACKAGES_PICTURE=(python3-vtk9 python3-numpy libgl1-mesa-dri xvfb)
PACKAGES_TESTS=(libgtest-dev python3-venv xvfb xauth)
PACKAGES_WINDOW=(xvfb openbox xdotool scrot fonts-dejavu-core libgl1-mesa-dri)
PACKAGES_CLANG=(clang-14 libclang-rt-14-dev)

# require_packages PACKAGE...: installs those that are not installed.
require_packages() {
  local missing
  missing=$(missing_packages "$@")
  if [[ -z $missing ]]; then return; fi
  missing=${missing//$'\n'/ }
  command -v apt-get >/dev/null || die "this machine has no apt; install what these Debian packages hold: $missing"
  note "installing with apt: $missing"
  # Package lists may be missing (as in container images) or so old that what they name is gone.
  # shellcheck disable=SC2086  # one word a package
  install_packages $missing || { as_root apt-get -q update >&2 && install_packages $missing; } ||
    die "apt could not install what is missing: $missing"
}

# Another apt may be at work, also that of a second script: wait for it.
install_packages() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600 --no-install-recommends install "$@" >&2
}

# missing_packages PACKAGE...: those that are not installed, one a line.
missing_packages() {
  # shellcheck disable=SC2016  # the dollars are dpkg's
  { dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true; } |
    sed -n 's/^installed //p' | sort -u | comm -13 - <(printf '%s\n' "$@" | sort -u)
}
