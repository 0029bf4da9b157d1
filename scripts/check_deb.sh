#!/bin/bash
# Installs a package of `make deb`, uses it as its users do and removes it: nothing is left. As root.
# Usage: scripts/check_deb.sh FILE.deb
set -euo pipefail
deb="$(realpath "$1")"
sources="$(dirname "$(realpath "$0")")/.."
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"

echo "lintian:"
# What is left are informations: report.html is no documentation but what reports are made from, and the words that it
# finds misspelt in the program are those of the pages' libraries.
lintian --info --fail-on error,warning "$deb"

echo "links of the documents:"
dpkg-deb --extract "$deb" files
python3 - files/usr/share/doc/bumpfoil <<'CHECK'
import re
import sys
from pathlib import Path

root = Path(sys.argv[1])
pages = [root / "README.md", root / "CONTRIBUTING.md", *root.glob("docs/**/*.md")]
dead = [f"{page}: {link}" for page in pages for link in re.findall(r'(?:\]\(|src=")([^)"#\s]+)', page.read_text())
        if "://" not in link and not (page.parent / link).exists()]
print(f"{len(pages)} pages, dead links: {dead}")
sys.exit(bool(dead) or len(pages) < 10)
CHECK

echo "installed:"
apt-get install -y -q --no-install-recommends "$deb" > install.log 2>&1 || { cat install.log; exit 1; }
dpkg -L bumpfoil > installed
bumpfoil --version
bumpfoil cycle files/usr/share/doc/bumpfoil/examples/gen1.toml -o results --quiet
bumpfoil report results --quiet
bumpfoil designer -o designer.html --quiet
bumpfoil reproduce -o studies --study increments --quiet
grep -q "</svg>" studies/increments/picture.svg
man --where bumpfoil
bash -c 'source /usr/share/bash-completion/completions/bumpfoil && complete -p bumpfoil'
/usr/bin/python3 -c 'import bumpfoil; print("bumpfoil", bumpfoil.__version__, bumpfoil.__file__)
assert bumpfoil.run_cycle("files/usr/share/doc/bumpfoil/examples/gen1.toml").cycles[0].max_force == bumpfoil.load("results").cycles[0].max_force'
/usr/bin/python3 -m bumpfoil --version
cmake -S "$sources/tests/install/consumer" -B consumer -G Ninja -DCMAKE_BUILD_TYPE=Release > /dev/null
cmake --build consumer > /dev/null
consumer/consumer

echo "removed:"
apt-get purge -y -q bumpfoil > remove.log 2>&1 || { cat remove.log; exit 1; }
left="$(while read -r path; do if [[ -e "$path" && ! -d "$path" ]]; then echo "$path"; fi; done < installed)"
left+="$(find /usr -ignore_readdir_race -path '*bumpfoil*' -print 2> /dev/null | head)"
if [[ -n "$left" ]]; then echo "left behind: $left"; exit 1; fi
echo "nothing is left"
