#!/bin/bash
# Builds Debian's oneTBB from its sources with the thread sanitizer.
# Usage: scripts/sanitized_tbb.sh FOLDER    installs it there, unless it is
set -euo pipefail

folder="$(realpath -m "$1")"
if [[ -e "$folder/lib/cmake/TBB/TBBConfig.cmake" ]]; then exit 0; fi
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# The lists of packages of the machine have no sources: those of this run alone do.
suite="$(. /etc/os-release && echo "$VERSION_CODENAME")"
mkdir -p "$work/lists"
echo "deb-src http://deb.debian.org/debian $suite main" > "$work/sources.list"
apt=(apt-get -q -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=/dev/null
     -o Dir::State::Lists="$work/lists" -o Dir::Cache::srcpkgcache= -o Dir::Cache::pkgcache= -o APT::Sandbox::User=)
cd "$work"
"${apt[@]}" update > /dev/null
"${apt[@]}" source --download-only onetbb > /dev/null
tar -xf onetbb_*.orig.tar.*
cmake --log-level=WARNING -G Ninja -S oneTBB-* -B build -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_SANITIZE=thread \
  -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_PREFIX="$folder" \
  > /dev/null
cmake --build build > /dev/null
cmake --install build > /dev/null
