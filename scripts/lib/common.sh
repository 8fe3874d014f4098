# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# What every script shares: where things are, what is said to the user, what ends with a script, results made once.

II_ROOT=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
II_CACHE=$(realpath -m -- "${II_CACHE:-$II_ROOT/.cache}")
II_BUILD=$(realpath -m -- "${II_BUILD:-$II_ROOT/build/release}")
II_MODELS=$(realpath -m -- "${II_MODELS:-$II_ROOT/../shared/models}")
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

# help_if_asked ARGUMENT...: prints the script's help and ends it where the first argument asks for that.
help_if_asked() {
  if [[ ${1:-} != -h && ${1:-} != --help ]]; then return; fi
  print_header_comment "$0"
  exit 0
}

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

# run_job COMMAND...: runs it so that a signal to this script ends it, too: bash alone would first wait for its end.
run_job() {
  "$@" &
  wait "$!"
}

# new_work_folder VARIABLE [PARENT]: a folder that goes away when the script ends, however it ends.
new_work_folder() {
  local -n made=$1
  made=$(mktemp -d -p "${2:-${TMPDIR:-/tmp}}" ".$II_SCRIPT.XXXXXX" 2>/dev/null) || die "cannot write into the folder ${2:-${TMPDIR:-/tmp}}."
  work_folders+=("$made")
}
work_folders=()

end_all() {
  trap '' HUP INT TERM
  end_children
  if ((${#work_folders[@]})); then rm -rf -- "${work_folders[@]}"; fi
}
trap end_all EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# descendants PID: the processes that it and its children have started, the youngest generation first.
descendants() {
  local child
  for child in $(cat /proc/"$1"/task/*/children 2>/dev/null); do
    descendants "$child"
    printf '%s\n' "$child"
  done
}

# end_children: asks what this script has started to end, and ends what has not done so after two seconds.
end_children() {
  local processes states tries=20
  mapfile -t processes < <(descendants "$$")
  if ((${#processes[@]} == 0)); then return; fi
  mapfile -t states < <(printf '/proc/%s/status\n' "${processes[@]}")
  kill -TERM "${processes[@]}" 2>/dev/null || true
  while ((tries-- > 0)) && grep -qsE '^State:\s+[^ZX]' "${states[@]}"; do sleep 0.1; done
  kill -KILL "${processes[@]}" 2>/dev/null || true
}

# make_once FOLDER COMMAND...: unless FOLDER exists, runs "COMMAND... TEMPORARY_FOLDER" and renames the result to FOLDER,
# so that FOLDER is complete whenever it is there, also where several scripts ask at once or one is interrupted.
make_once() {
  if [[ -d $1 ]]; then return; fi
  mkdir -p -- "$(dirname -- "$1")" 2>/dev/null && : 2>/dev/null >>"$1.lock" ||
    die "the cache folder $(dirname -- "$1") cannot be written. Name one of your own in the environment variable II_CACHE."
  run_job make_locked "$@" 9>>"$1.lock"
}

make_locked() {
  local folder=$1
  shift
  flock 9
  if [[ -d $folder ]]; then return; fi
  temporary=$(mktemp -d -- "$folder.XXXXXX")
  trap 'rm -rf -- "$temporary"' EXIT
  "$@" "$temporary"
  chmod 755 "$temporary"
  mv -T -- "$temporary" "$folder"
}
