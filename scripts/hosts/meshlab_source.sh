# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# MeshLab's source trees, for their headers: Debian packages none. Needs common.sh, debian_archive.sh.

# The MeshLab releases that plugins are built for, and the Debian suite that has each.
MESHLAB_RELEASES=(2020.09 2022.02 2025.07)
declare -A MESHLAB_SUITE=([2020.09]=bookworm [2022.02]=trixie [2025.07]=sid)

meshlab_source_dir() { printf '%s/meshlab-%s\n' "$II_CACHE" "$1"; }

# fetch_meshlab_source RELEASE: the source tree is in $(meshlab_source_dir RELEASE) afterwards.
fetch_meshlab_source() {
  local release=$1
  [[ -n ${MESHLAB_SUITE[$release]:-} ]] || die "no such release: $release. There are: ${MESHLAB_RELEASES[*]}"
  make_once "$(meshlab_source_dir "$release")" unpack_meshlab_source "$release"
}

unpack_meshlab_source() {
  local release=$1 folder=$2 apt=$2/apt suite=${MESHLAB_SUITE[$1]} version
  note "fetching the source of MeshLab $release from Debian's $suite"
  mkdir "$apt"
  open_debian_archive "$apt" deb-src "$suite"
  version=$(newest_meshlab_version "$apt" "$release")
  [[ -n $version ]] || die "Debian's $suite has no MeshLab ${release%%.*} any more."
  # The tarball alone: what Debian's patches change is not in the headers.
  (cd "$apt" && private_apt "$apt" apt-get source --tar-only --download-only "meshlab=$version" >source.log 2>&1) ||
    die "cannot fetch the source of MeshLab $version: $(tail -n 1 "$apt/source.log")"
  tar -x -f "$apt"/meshlab_*.orig.tar.* -C "$folder" --strip-components=1
  rm -rf "$apt"
  [[ -f $folder/ML_VERSION ]] || die "the source of MeshLab $version does not have the expected layout."
}

# newest_meshlab_version APT_FOLDER RELEASE: the newest of that year, because a suite may have moved on to a point release.
newest_meshlab_version() {
  private_apt "$1" apt-cache showsrc meshlab | sed -n "s/^Version: \(${2%%.*}\..*\)/\1/p" | sort -V | tail -n 1
}
