#!/bin/bash
# clang-tidy by the rules of .clang-tidy, several files at a time; fails where it finds anything.
# Usage: scripts/lint.sh [source...]    without any: all of src, apps, python, bench and examples, with the headers they include
set -euo pipefail
cd "$(dirname "$0")/.."

# Clang passes over options that are for g++ alone.
arguments=(--extra-arg=-Wno-unused-command-line-argument --extra-arg=-Wno-unknown-warning-option)

# Nothing is built: clang-tidy only needs to know how everything would be compiled. Headers take most of its time, so
# that all sources are read in the batches of a unity build.
if (( $# )); then
  cmake --log-level=WARNING --preset lint -DCMAKE_UNITY_BUILD=OFF > /dev/null
  sources=("$@")
else
  cmake --log-level=WARNING --preset lint -DCMAKE_UNITY_BUILD=ON > /dev/null
  mapfile -t sources < <(python3 -c '
import json, os
files = {os.path.relpath(entry["file"]) for entry in json.load(open("build/lint/compile_commands.json"))}
print(*sorted(file for file in files if os.path.exists(file) and "tests" not in file.split(os.sep)), sep="\n")')
  # That sources are included is no mistake here, nor that a name of one hides what is meant for another.
  arguments+=(--checks=-bugprone-suspicious-include --extra-arg=-Wno-shadow)
fi
tidy="$(command -v clang-tidy-14 || command -v clang-tidy)"
log=build/lint/clang-tidy.log  # how many warnings of system headers it left out, and why it failed where it did

echo "clang-tidy: ${#sources[@]} sources or batches of them"
if ! printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tidy" -p build/lint --quiet "${arguments[@]}" 2> "$log"; then
  grep -v 'warnings\? generated\|warnings\? and .* generated' "$log" >&2 || true
  echo "clang-tidy: see above" >&2
  exit 1
fi
echo "clang-tidy: nothing to mend"
