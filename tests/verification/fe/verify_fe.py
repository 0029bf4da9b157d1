"""Everything of `make verify-fe`: runs the finite elements, writes the data and the pages.

Usage: verify_fe.py PROGRAM STUDY FOLDER [--pages]

PROGRAM is bumpfoil, STUDY shells_study of tests/verification/, FOLDER takes decks and results; --pages only writes the
pages anew, from the data that are there.
"""

import sys
from pathlib import Path

import bearing_page
import full_bearing
import shell_page
import shells
import strip_page
import strips
from program import ROOT

DATA = ROOT / "tests/data/fe"
PAGES = ROOT / "docs/verification"


def main(program, study, folder, pages_only):
    if not pages_only:
        shells.measure(folder, DATA / "shells.json")
        strips.measure(folder, DATA / "strips.json")
        full_bearing.measure(folder, DATA / "full_bearing.json")
    shell_page.write(study, DATA / "shells.json", PAGES / "fe_shells.md")
    strip_page.write(program, folder / "program", DATA / "strips.json", PAGES / "fe_strip.md")
    bearing_page.write(program, folder / "program", DATA / "full_bearing.json", PAGES / "fe_bearing.md")


if __name__ == "__main__":
    main(*(Path(argument).resolve() for argument in sys.argv[1:4]), "--pages" in sys.argv[4:])
