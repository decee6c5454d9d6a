# shellcheck shell=bash
# Sourced with FIXPROOF and SCENES: an empty folder to work in, `expect`, `fail` and `failures`.
set -uo pipefail
export LC_ALL=C

fixproof=$(realpath "${1:?usage: ${0##*/} FIXPROOF SCENES}")
# shellcheck disable=SC2034  # of those who source this
scenes=$(realpath "${2:?usage: ${0##*/} FIXPROOF SCENES}")
interrupted=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/interrupted
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
fail() { printf '%s\n' "$*"; failures=$((failures + 1)); }

# expect STATUS PATTERN ARGUMENT...: the status, and an extended regular expression for what is said: on
# stderr, in one line, where the status is 2. `subcommand` may hold the first arguments of all.
subcommand=()
expect() {
  local status=0 said=out arguments=("${subcommand[@]}" "${@:3}")
  "$fixproof" "${arguments[@]}" >out 2>err </dev/null || status=$?
  [[ $1 != 2 ]] || said=err
  [[ $status == "$1" ]] || fail "status $status, not $1: fixproof ${arguments[*]}: $(cat err)"
  [[ $said == out ]] || (($(wc -l <err) == 1)) || fail "not one line: fixproof ${arguments[*]}: $(cat err)"
  grep -qE -- "$2" $said || fail "no \"$2\" from fixproof ${arguments[*]}: $(cat $said)"
}

# stop SIGNAL SECONDS ARGUMENT...: the same of a run that is stopped, which ends with status 130.
stop() {
  local status=0
  "$interrupted" "$1" "$2" "$fixproof" "${@:3}" >out 2>err || status=$?
  [[ $status == 130 ]] || fail "stopped with status $status: fixproof ${*:3}"
}
