"""docs/studies/tolerances.md is what its data say, and its data are what the program computes.

Usage: test_tolerances.py REPOSITORY PROGRAM
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
sys.path.insert(0, str(ROOT / "studies/tolerances"))
sys.dont_write_bytecode = True

import ensembles  # noqa: E402
import page  # noqa: E402

DATA = json.loads(ensembles.DATA.read_text(encoding="utf-8"))
#: Another compiler rounds otherwise; events that change places with that move forces by less.
SAME = 1e-6


class Tolerances(unittest.TestCase):
    def test_page_is_what_the_data_say(self):
        self.assertEqual(ensembles.PAGE.read_text(encoding="utf-8"), page.text(DATA))

    def test_every_ensemble_is_there_and_none_failed(self):
        self.assertEqual(list(DATA["ensembles"]), list(ensembles.ENSEMBLES))
        for name, ensemble in DATA["ensembles"].items():
            self.assertEqual(ensemble["failed"], 0, name)
            self.assertGreaterEqual(ensemble["samples"], 100, name)

    def test_data_are_what_the_program_computes(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, ensemble in DATA["ensembles"].items():
                results = Path(folder) / name
                command = ensembles.command(PROGRAM, name, results, ensembles.KEPT)
                done = subprocess.run([*command, "--quiet"], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                for direction, forces in ensembles.first_forces(results).items():
                    stored = ensemble["directions"][direction]["first_forces_N"]
                    for force, one in zip(forces, stored, strict=True):
                        self.assertAlmostEqual(force / one, 1.0, delta=SAME, msg=f"{name}, {direction}")

    def test_the_bearing_as_drawn_is_what_the_program_computes(self):
        with tempfile.TemporaryDirectory() as folder:
            drawn = ensembles.nominal(PROGRAM, Path(folder) / "nominal")
        for direction, quantities in DATA["nominal"].items():
            for name, value in quantities.items():
                scale = max(abs(value), 1e-9)
                self.assertAlmostEqual(drawn[direction][name] / scale, value / scale, delta=1e-5, msg=name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
