#!/bin/bash
# clang-tidy by the rules of .clang-tidy, several files at a time; fails where it finds anything.
# Usage: scripts/lint.sh [source...]    without any: all of src, apps, python, bench and examples, with the headers they include
set -euo pipefail
cd "$(dirname "$0")/.."

sources=("$@")
if (( ${#sources[@]} == 0 )); then mapfile -t sources < <(find src apps python bench examples -name '*.cpp' | sort); fi

# Nothing is built: clang-tidy only needs to know how everything would be compiled.
cmake --log-level=WARNING --preset lint > /dev/null
tidy="$(command -v clang-tidy-14 || command -v clang-tidy)"
log=build/lint/clang-tidy.log  # how many warnings of system headers it left out, and why it failed where it did

echo "clang-tidy: ${#sources[@]} files"
if ! printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tidy" -p build/lint --quiet 2> "$log"; then
  grep -v 'warnings\? generated\|warnings\? and .* generated' "$log" >&2 || true
  echo "clang-tidy: see above" >&2
  exit 1
fi
echo "clang-tidy: nothing to mend"
