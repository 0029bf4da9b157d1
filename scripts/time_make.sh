#!/bin/bash
# Times a command of the Makefile in a clean clone of HEAD, without a compiler cache: processor time (user and system) and
# wall time. docs/performance.md has the figures of `make demo` and `make test`.
# Usage: scripts/time_make.sh [COMMAND, by default demo]
set -euo pipefail

command="${1:-demo}"
source="$(git -C "$(dirname "$0")" rev-parse --show-toplevel)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
git clone --quiet "$source" "$folder/bumpfoil"
export CCACHE_DISABLE=1
TIMEFORMAT="make $command: %U s user + %S s system; %R s of wall time"
time make --no-print-directory -C "$folder/bumpfoil" "$command"
