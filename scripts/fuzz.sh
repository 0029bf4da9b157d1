#!/bin/bash
# Feeds each target of tests/fuzz/ for some minutes, from what is committed and what was found before; twice as many at
# a time as there are cores. The seed is always the same, so that findings are found again.
# Usage: scripts/fuzz.sh FUZZER FOLDER MINUTES [TARGET...]    exits non-zero if anything was found
set -uo pipefail

export fuzzer="$1" folder="$2" seconds=$(( 60 * $3 ))
shift 3
targets=("$@")
if (( $# == 0 )); then mapfile -t targets < <(ls tests/fuzz/corpus); fi

feed() {
  local target="$1" log="$folder/$1.log" found=0
  mkdir -p "$folder/$target"
  FUZZ_TARGET="$target" nice -n 15 "$fuzzer" -max_total_time="$seconds" -timeout=300 -rss_limit_mb=3000 \
    -print_final_stats=1 -seed=1 -artifact_prefix="$folder/$target." "$folder/$target" "tests/fuzz/corpus/$target" \
    > "$log" 2>&1 || found=1
  if (( found )); then echo "$target: FOUND, see $log"; fi
  echo "$target: $(awk '/number_of_executed_units/ {print $2}' "$log") executions," \
    "$(grep -o 'cov: [0-9]*' "$log" | tail -1)"
  return $found
}
export -f feed
printf '%s\0' "${targets[@]}" | xargs -0 -n 1 -P "$(( 2 * $(nproc) ))" bash -c 'feed "$1"' feed
