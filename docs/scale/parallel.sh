#!/usr/bin/env bash
# usage: parallel.sh SHARDS FOLDER [OPTION OF fixproof verify]...      (without options: --level 3)
# Runs a verification in SHARDS shards under GNU parallel, one per processor; the merged report is FOLDER/sum.json.
# Each shard saves its state in FOLDER every half second, so the same command resumes after a kill.
# With PARALLEL='--sshloginfile machines --workdir .' it runs on other machines, which must share FOLDER.
# Set FIXPROOF to the path of the command if it is not in PATH.
# Exit status: 130 if stopped, else that of `fixproof merge`: 0 all equal, 1 a mismatch, 2 wrong usage or an
# incomplete shard.
set -uo pipefail

[[ ${1:-} =~ ^[1-9][0-9]{0,5}$ && ${2:-} ]] || { sed -n '2,8s/^# //p' "$0" >&2; exit 2; }
shards=$1 folder=$2
shift 2
(($#)) || set -- --level 3
fixproof=${FIXPROOF:-fixproof}
command -v parallel >/dev/null || { echo "parallel.sh: GNU parallel is not installed" >&2; exit 2; }
mkdir -p "$folder" || exit 2
# This shard is empty. It reports wrong options once; otherwise every shard would.
"$fixproof" verify "$@" --shard 999999999/999999999 >/dev/null || exit 2

# A mismatch (1) or an error (2) is not retried; merge reports it.
# In the background, since bash handles a signal only after a foreground command ends. GNU parallel stops at once
# on the second SIGTERM.
parallel --retries 5 --termseq INT,3000,KILL,100 --joblog "$folder/log" \
  "$(printf '%q ' "$fixproof" verify "$@" --threads 1)" \
  --shard "{}/$shards" --resume "$(printf '%q' "$folder")/{}.json" '>/dev/null || [ $? -le 2 ]' \
  ::: $(seq "$shards") </dev/null &
jobs=$!
stopped=0
trap 'stopped=1; kill -TERM $jobs; sleep 0.2; kill -TERM $jobs 2>/dev/null' INT TERM HUP
wait $jobs
if ((stopped)); then
  wait $jobs
  echo "Stopped. The same command goes on." >&2
  exit 130
fi

# merge names a shard without a file as missing.
parts=()
for ((i = 1; i <= shards; i++)); do [[ ! -e $folder/$i.json ]] || parts+=("$folder/$i.json"); done
((${#parts[@]})) || { echo "parallel.sh: no part wrote anything" >&2; exit 2; }
exec "$fixproof" merge "${parts[@]}" --report "$folder/sum.json"
