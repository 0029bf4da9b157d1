"""The example programs run without a warning and draw their pictures, and those that are there in C++, too, print the
same lines.

Usage: test_examples.py REPOSITORY FOLDER_OF_PROGRAMS
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(sys.argv[1]).resolve() / "examples"
PROGRAMS = Path(sys.argv[2]).resolve()


def lines_of(*command, folder=None):
    environment = dict(os.environ, MPLBACKEND="agg")
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, env=environment)
    if done.returncode != 0 or "Warning" in done.stderr:
        raise AssertionError(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout.splitlines()


class Examples(unittest.TestCase):
    def test_python_runs_and_cpp_says_the_same(self):
        names = {example.stem for example in EXAMPLES.glob("*.py")}
        twins = {example.stem for example in EXAMPLES.glob("*.cpp")}
        self.assertLessEqual(twins, names)
        self.assertGreaterEqual(len(twins), 8)
        for name in sorted(names):
            with self.subTest(example=name), tempfile.TemporaryDirectory() as folder:
                script = EXAMPLES / f"{name}.py"
                lines = lines_of(sys.executable, "-B", script, folder=folder)
                self.assertGreater(len(lines), 1)
                if name in twins:
                    self.assertEqual(lines_of(PROGRAMS / f"example_{name}", folder=EXAMPLES), lines)
                if name != "quickstart":
                    pictures = list(Path(folder).glob(f"{name}*.svg"))
                    self.assertEqual(len(pictures), 7 if name == "paper_figure" else 1)
                    for picture in pictures:
                        self.assertIn("<svg", picture.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
