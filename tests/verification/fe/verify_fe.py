"""Everything of `make verify-fe`: runs the finite elements, writes the data and the pages.

Usage: verify_fe.py PROGRAM FOLDER [--pages]

PROGRAM is bumpfoil, FOLDER takes decks and results; --pages only writes the pages anew, from the data that are there.
"""

import sys
from pathlib import Path

import bearing_page
import full_bearing
import strip_page
import strips
from program import ROOT

DATA = ROOT / "tests/data/fe"
PAGES = ROOT / "docs/verification"


def main(program, folder, pages_only):
    if not pages_only:
        strips.measure(folder, DATA / "strips.json")
        full_bearing.measure(folder, DATA / "full_bearing.json")
    strip_page.write(program, folder / "program", DATA / "strips.json", PAGES / "fe_strip.md")
    bearing_page.write(program, folder / "program", DATA / "full_bearing.json", PAGES / "fe_bearing.md")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), "--pages" in sys.argv[3:])
