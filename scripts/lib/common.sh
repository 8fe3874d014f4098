# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# What every script shares: where things are, what is said to the user, and results that are made once.

II_ROOT=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
II_CACHE=$(realpath -m -- "${II_CACHE:-$II_ROOT/.cache}")
II_SCRIPT=${0##*/}

# note SENTENCE...: tells the user what happens; on stderr, so that stdout can be used by other programs.
note() { printf '%s: %s\n' "$II_SCRIPT" "$*" >&2; }

# die SENTENCE...: says what is wrong and what to do, and ends the script.
die() {
  note "$*"
  exit 1
}

# print_header_comment FILE: the comment at the head of a script is its help text.
print_header_comment() { sed -n '3,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$1"; }

# as_root COMMAND...: runs the command with the rights of the administrator.
as_root() {
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    die "this needs root rights, and there is no sudo here. Run as root: $*"
  fi
}

# make_once FOLDER COMMAND...: unless FOLDER exists, runs "COMMAND... TEMPORARY_FOLDER" and renames the result to FOLDER,
# so that FOLDER is complete whenever it is there, also where several scripts ask at once or one is interrupted.
make_once() {
  local folder=$1
  shift
  if [[ -d $folder ]]; then return; fi
  mkdir -p -- "$(dirname -- "$folder")"
  (
    flock 9
    if [[ -d $folder ]]; then exit 0; fi
    temporary=$(mktemp -d -- "$folder.XXXXXX")
    trap 'rm -rf -- "$temporary"' EXIT
    "$@" "$temporary"
    chmod 755 "$temporary"
    mv -T -- "$temporary" "$folder"
  ) 9>"$folder.lock"
}
