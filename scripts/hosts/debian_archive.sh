# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Debian's archive by the machine's own mirror: a private apt that can read other suites and source packages without
# touching the machine's configuration. Needs common.sh.

DEBIAN_KEYRING=/usr/share/keyrings/debian-archive-keyring.gpg

# debian_mirror: address of the archive, as the machine's own apt is set up. II_DEBIAN_MIRROR names another one, for
# machines that are not Debian's.
debian_mirror() {
  if [[ -n ${II_DEBIAN_MIRROR:-} ]]; then
    printf '%s\n' "$II_DEBIAN_MIRROR"
    return
  fi
  local mirror
  mirror=$(configured_debian_mirror)
  if [[ -z $mirror ]]; then
    # Without package lists (as in container images) apt does not know yet which of its sources is Debian's.
    as_root apt-get -q update >&2
    mirror=$(configured_debian_mirror)
  fi
  [[ -n $mirror ]] || die "no source of this machine's apt is Debian's main archive; name one in II_DEBIAN_MIRROR."
  printf '%s\n' "$mirror"
}

configured_debian_mirror() {
  # shellcheck disable=SC2016  # the dollars are apt's
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' \
    'Component: main' | head -n 1
}

# private_apt FOLDER PROGRAM ARGUMENTS...: apt-get or apt-cache with configuration, lists and package status of their own
# in FOLDER: nothing is installed there.
private_apt() {
  local folder=$1 program=$2
  shift 2
  "$program" -q \
    -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=- \
    -o Dir::State="$folder" -o Dir::State::status="$folder/status" -o Dir::State::Lists="$folder/lists" \
    -o Dir::Cache="$folder/cache" -o APT::Sandbox::User="$(id -un)" \
    -o Acquire::Languages=none -o Acquire::Check-Valid-Until=false "$@"
}

# open_debian_archive FOLDER TYPE SUITE: prepares FOLDER for private_apt with what SUITE has of TYPE: deb or deb-src.
open_debian_archive() {
  local folder=$1 type=$2 suite=$3 mirror
  mirror=$(debian_mirror)
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
  touch "$folder/status"
  printf '%s [signed-by=%s] %s %s main\n' "$type" "$DEBIAN_KEYRING" "$mirror" "$suite" >"$folder/sources.list"
  private_apt "$folder" apt-get update >"$folder/update.log" 2>&1 ||
    die "apt cannot read Debian's $suite: $(grep -m 1 -E '^(E|W|Err)' "$folder/update.log")"
}
