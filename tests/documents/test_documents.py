"""The documents must be true: links lead somewhere, sources are named, the README's numbers and commands work.

Usage: test_documents.py REPOSITORY PROGRAM [CLASS OF TESTS ...]
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
PACKAGE = PROGRAM.parent / "python"  # where it was built
README = (ROOT / "README.md").read_text(encoding="utf-8")


def documents():
    return [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]


def readme_block(language):
    return re.search(rf"```{language}\n(.*?)```", README, re.DOTALL).group(1)


def anchors(document):
    """Of the headings of a document, as they are made of their words: small letters, no marks, hyphens for blanks."""
    headings = re.findall(r"^#+ (.+)$", document.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Documents(unittest.TestCase):
    def test_links_lead_somewhere(self):
        for document in documents():
            text = document.read_text(encoding="utf-8")
            for target, anchor in re.findall(r"""(?:\]\(|src=")([^)#\s"]*)#?([^)\s"]*)""", text):
                if target.startswith("http"):
                    continue
                linked = document.parent / target if target else document
                self.assertTrue(linked.exists(), f"{document}: {target}")
                if anchor:
                    self.assertIn(anchor, anchors(linked), f"{document}: {target}#{anchor}")

    def test_sources_are_named_in_the_bibliography(self):
        known = set(re.findall(r"@\w+\{(\w+),", (ROOT / "docs/references.bib").read_text(encoding="utf-8")))
        sources = [file for folder in ("include", "src", "apps", "tests") for file in (ROOT / folder).rglob("*.[ch]pp")]
        cited = set()
        for file in [*documents(), *sources]:
            cited |= set(re.findall(r"\[([A-Z][A-Za-z]+(?:19|20)\d\d)\b", file.read_text(encoding="utf-8")))
        self.assertIn("Arghir2019", cited)
        self.assertEqual(cited, known)

    def test_folders_of_contributing_are_there(self):
        """A row of the table names folders and what is in them; folders in the text are at the top or modules."""
        text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        folder = re.compile(r"`([\w./-]+)/`")
        rows = re.findall(r"^\| (`[^|]*/`) \|(.*)$", text, re.MULTILINE)
        self.assertGreater(len(rows), 5)
        for first, second in rows:
            for outer in folder.findall(first):
                for inner in ["", *folder.findall(second)]:
                    self.assertTrue((ROOT / outer / inner).is_dir(), f"CONTRIBUTING.md names {outer}/{inner}")
        for name in folder.findall(re.sub(r"^\|.*$", "", text, flags=re.MULTILINE)):
            self.assertTrue((ROOT / name).is_dir() or (ROOT / "src" / name).is_dir(), f"CONTRIBUTING.md names {name}/")

    def test_contributing_names_every_module_and_folder(self):
        text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        table = re.search(r"## Where things are\n(.*?)\nData flows", text, re.DOTALL).group(1)
        for folder in [*(ROOT / "src").iterdir(), *(ROOT / "include/bumpfoil").iterdir(), *(ROOT / "tests").iterdir()]:
            if folder.is_dir() and not folder.name.startswith(("_", ".")):
                self.assertIn(f"`{folder.name}/`", table)

    def test_one_version(self):
        version = re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
        self.assertIn(f"version: {version}\n", (ROOT / "CITATION.cff").read_text(encoding="utf-8"))
        changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        self.assertEqual(version, re.search(r"^## \[(\d[\d.]*)\] - \d{4}-\d\d-\d\d$", changelog, re.MULTILINE).group(1))


class InADirectory(unittest.TestCase):
    """Runs commands where nothing else is, with the program on the path."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def run_in_directory(self, command):
        environment = dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}", PYTHONPATH=str(PACKAGE))
        done = subprocess.run(command, cwd=self.directory, env=environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout


class Pages(InADirectory):
    RUN = {
        "sh": ["bash", "-euo", "pipefail", "-c"],
        "python": [sys.executable, "-c"],
        "octave": ["octave-cli", "--no-gui", "--eval"],
    }

    def test_examples_are_right(self):
        examples = sorted((ROOT / "examples").glob("*.toml"))
        self.assertGreater(len(examples), 3)
        for example in examples:
            self.run_in_directory([str(PROGRAM), "check", str(example)])

    def test_blocks_of_code_run(self):
        """On the results of the reference bearing, in the folders that they name. Cases and programs are shown as examples
        hold them, `text` as it was printed by the block before."""
        case = str(ROOT / "examples/gen1.toml")
        self.run_in_directory([str(PROGRAM), "cycle", case, "-o", "loops"])
        over = ["--over", "cycle.amplitude=60 um:90 um:10 um", "--over", "friction.coefficient=[0.05, 0.1]"]
        self.run_in_directory([str(PROGRAM), "sweep", case, *over, "-o", "grid"])
        case = str(ROOT / "examples/vibration.toml")
        over = ["--command", "vibration", "--over", "friction.coefficient=[0.1, 0.2]", "--set", "vibration.steps=5"]
        self.run_in_directory([str(PROGRAM), "sweep", case, *over, "-o", "stiffness"])
        os.symlink(ROOT / "examples", Path(self.directory) / "examples")
        shown = {
            language: "".join(example.read_text(encoding="utf-8") for example in (ROOT / "examples").glob(f"*.{language}"))
            for language in ("cpp", "toml")
        }
        self.run_in_directory([str(PROGRAM), "montecarlo", str(ROOT / "examples/tolerances.toml"), "-o", "tolerances"])
        blocks = 0
        for document in (ROOT / "docs").rglob("*.md"):
            printed = ""
            for language, code in re.findall(r"^```(\w+)\n(.*?)^```", document.read_text(encoding="utf-8"), re.M | re.S):
                if language == "python" and "import bumpfoil\n" in code and not PACKAGE.exists():
                    continue
                with self.subTest(document=document.name, language=language):
                    if language in shown:
                        self.assertIn(code, shown[language])
                    elif language == "text":
                        lines = [" ".join(line.split()) for line in printed.splitlines()]
                        for line in code.splitlines():
                            self.assertIn(" ".join(line.split()), lines)
                    else:
                        printed = self.run_in_directory([*self.RUN[language], code])
                blocks += 1
        self.assertGreater(blocks, 1)


class Readme(InADirectory):
    def test_cpp_is_the_example(self):
        self.assertEqual(readme_block("cpp"), (ROOT / "examples/quickstart.cpp").read_text(encoding="utf-8"))

    def test_shell_commands_work(self):
        self.run_in_directory(["bash", "-euo", "pipefail", "-c", readme_block("sh")])

    def test_python_reads_the_results(self):
        self.run_in_directory([str(PROGRAM), "cycle", str(ROOT / "examples/gen1.toml"), "-o", "loops"])
        self.run_in_directory([sys.executable, "-c", readme_block("python")])

    def test_example_is_what_init_writes(self):
        self.run_in_directory([str(PROGRAM), "init", "-o", "case.toml"])
        written = (Path(self.directory) / "case.toml").read_text(encoding="utf-8")
        self.assertEqual(written, (ROOT / "examples/gen1.toml").read_text(encoding="utf-8"))

    def test_table_shows_what_the_program_computes(self):
        self.run_in_directory([str(PROGRAM), "cycle", str(ROOT / "examples/gen1.toml"), "-o", "demo"])
        summary = json.loads((Path(self.directory) / "demo/summary.json").read_text(encoding="utf-8"))
        names = {0: "+X", 90: "+Y", 180: "−X", 270: "−Y"}
        expected = {
            names[round(cycle["direction_deg"])]: [
                f"{cycle['max_force_N']:.0f}",
                f"{cycle['cross_force_at_max_N']:.0f}",
                f"{cycle['loaded_stiffness_N_per_m'] * 1e-6:.2f}",
                f"{cycle['loop_energy_J'] * 1e3:.2f}",
                f"{cycle['loss_factor']:.3f}",
            ]
            for cycle in summary["cycles"]
        }
        rows = re.search(r"<!-- loops:.*?-->\n(.*?)<!-- /loops -->", README, re.DOTALL).group(1).splitlines()[2:]
        cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]
        shown = {row[0]: [cell.replace("−", "-") for cell in row[1:]] for row in cells}
        self.assertEqual(shown, expected)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
