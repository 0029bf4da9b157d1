#!/bin/bash
# Feeds each target of tests/fuzz/ for some minutes, from what is committed and what was found before.
# Usage: scripts/fuzz.sh FUZZER FOLDER MINUTES [TARGET...]    exits non-zero if anything was found
set -uo pipefail

fuzzer="$1" folder="$2" minutes="$3"
shift 3
targets=("$@")
if (( $# == 0 )); then mapfile -t targets < <(ls tests/fuzz/corpus); fi
found=0
for target in "${targets[@]}"; do
  mkdir -p "$folder/$target"
  FUZZ_TARGET="$target" nice -n 15 "$fuzzer" -max_total_time=$(( 60 * minutes )) -timeout=300 -rss_limit_mb=3000 \
    -print_final_stats=1 -artifact_prefix="$folder/$target." "$folder/$target" "tests/fuzz/corpus/$target" \
    > "$folder/$target.log" 2>&1 || { found=1; echo "$target: FOUND, see $folder/$target.log"; }
  echo "$target: $(awk '/number_of_executed_units/ {print $2}' "$folder/$target.log") executions," \
    "$(grep -o 'cov: [0-9]*' "$folder/$target.log" | tail -1)"
done
exit $found
