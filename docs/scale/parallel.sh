#!/usr/bin/env bash
# usage: parallel.sh SHARDS FOLDER [OPTION OF fixproof verify]...      (without options: --level 3)
# A verification in SHARDS parts under GNU parallel, one processor a part, and the sum in FOLDER/sum.json.
# Each part keeps its state in FOLDER, half a second old at most: whatever was killed, the same command goes on.
# PARALLEL='--sshloginfile machines --workdir .' takes other machines; FOLDER is one they share.
# FIXPROOF is the command where it is not in the PATH.
# Exit status: that of `fixproof merge`: 0 all equal, 1 a mismatch, 2 bad usage or a part that did not end;
# 130 stopped.
set -uo pipefail

[[ ${1:-} =~ ^[1-9][0-9]{0,5}$ && ${2:-} ]] || { sed -n '2,8s/^# //p' "$0" >&2; exit 2; }
shards=$1 folder=$2
shift 2
(($#)) || set -- --level 3
fixproof=${FIXPROOF:-fixproof}
command -v parallel >/dev/null || { echo "parallel.sh: GNU parallel is not installed" >&2; exit 2; }
mkdir -p "$folder" || exit 2
# A part without a chunk: what is wrong with the options is said once and not by every part.
"$fixproof" verify "$@" --shard 999999999/999999999 >/dev/null || exit 2

# A mismatch (1) and a wrong option (2) are no reason to try again; merge says so.
# In the background, since bash would hear of a signal only after the last part. SIGTERM twice is how GNU
# parallel is stopped at once.
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

# A part that wrote nothing is missing; merge says so of the others.
parts=()
for ((i = 1; i <= shards; i++)); do [[ ! -e $folder/$i.json ]] || parts+=("$folder/$i.json"); done
((${#parts[@]})) || { echo "parallel.sh: no part wrote anything" >&2; exit 2; }
exec "$fixproof" merge "${parts[@]}" --report "$folder/sum.json"
