#!/bin/bash
# Times a command of the Makefile in a clean clone of HEAD, without a compiler cache: processor time (user and system)
# and wall time. What npm has cached and apt installed stays. docs/performance.md has the figures.
# Usage: scripts/time_make.sh [COMMAND, by default demo]
set -euo pipefail

target="${1:-demo}"
repository="$(git -C "$(dirname "$0")" rev-parse --show-toplevel)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
git clone --quiet "$repository" "$folder/bumpfoil"
export CCACHE_DISABLE=1
TIMEFORMAT="make $target: %U s user + %S s system; %R s of wall time"
time make --no-print-directory -C "$folder/bumpfoil" "$target"
