#!/bin/bash
# Makes sure that the system packages of the given purposes (see packages.txt) are there; installs what is missing.
# Usage: scripts/require_packages.sh build [plot] [test] [bench]
set -euo pipefail

list="$(dirname "$0")/../packages.txt"
wanted=()
while read -r purpose package _; do
  for requested in "$@"; do
    if [[ "$purpose" == "$requested" ]]; then wanted+=("$package"); fi
  done
done < <(grep -Ev '^[[:space:]]*(#|$)' "$list")

if ! command -v dpkg-query > /dev/null; then
  echo "This is not a Debian system, so its packages cannot be checked. Needed, by their Debian names:" >&2
  echo "  ${wanted[*]}" >&2
  echo "With those in place, build with CMake directly: see CONTRIBUTING.md." >&2
  exit 1
fi

missing_packages() {
  local installed
  # What an installed package provides is there, too: Node.js from its makers brings its own npm.
  installed="$(dpkg-query -W -f='${db:Status-Abbrev},${Package},${Provides}\n' | awk -F',' '$1 ~ /^ii/ {
    for (i = 2; i <= NF; i++) { split($i, words, " "); print words[1] } }')"
  for package in "${wanted[@]}"; do
    if ! grep -qxF -- "$package" <<< "$installed"; then echo "$package"; fi
  done
}

mapfile -t missing < <(missing_packages)
if (( ${#missing[@]} == 0 )); then exit 0; fi

install=(apt-get install -y --no-install-recommends "${missing[@]}")
give_up() {
  local sudo="sudo "
  if (( EUID == 0 )); then sudo=""; fi
  echo "Nothing was built: $1" >&2
  echo "Missing packages: ${missing[*]}" >&2
  echo "Install them with:" >&2
  echo "  ${sudo}apt-get update && ${sudo}${install[*]}" >&2
  exit 1
}

as_root=(env DEBIAN_FRONTEND=noninteractive)
if (( EUID != 0 )); then
  if ! command -v sudo > /dev/null; then give_up "installing packages needs root, and sudo is not here."; fi
  # Where nobody can type a password, sudo must not wait for one.
  if [[ -t 0 ]]; then as_root=(sudo "${as_root[@]}"); else as_root=(sudo -n "${as_root[@]}"); fi
fi

echo "Installing packages: ${missing[*]}"
"${as_root[@]}" apt-get update -q > /dev/null || give_up "apt-get update failed."
"${as_root[@]}" "${install[@]}" > /dev/null || give_up "apt-get could not install the packages."
