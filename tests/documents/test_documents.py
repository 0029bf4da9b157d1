"""The documents must be true: links lead somewhere, sources are named, the README's numbers and commands work.

Usage: test_documents.py REPOSITORY PROGRAM [CLASS OF TESTS ...]
"""

import json
import math
import os
import re
import shlex
import subprocess
import sys
import tempfile
import traceback
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
PACKAGE = PROGRAM.parent / "python"  # where it was built
sys.path.insert(0, str(ROOT / "docs/site"))
import sources

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

    def test_list_of_references_is_that_of_the_bibliography(self):
        """`docs/site/sources.py` writes it. Every citation leads to its entry there, as keys are its headings."""
        entries = sources.page_of((ROOT / "docs/references.bib").read_text(encoding="utf-8"))
        self.assertEqual((ROOT / "docs/references.md").read_text(encoding="utf-8"), entries)

    def test_theory_goes_from_the_problem_to_the_limits(self):
        order = ["Problem", "Model", "Equations", "Method", "Check", "Limits"]
        others = {"conventions", "notation", "limits", "paper_errors"}
        pages = [page for page in (ROOT / "docs/theory").glob("*.md") if page.stem not in others]
        self.assertGreater(len(pages), 10)
        for page in pages:
            headings = re.findall(r"^## (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
            self.assertEqual(headings, order, page.name)

    def test_pages_write_folders_of_their_own(self):
        """Who goes through all pages in one place is refused nowhere."""
        pages = {}
        for document in documents():
            for code in re.findall(r"^```sh\n(.*?)^```", document.read_text(encoding="utf-8"), re.M | re.S):
                for folder in re.findall(r"^ *bumpfoil (?!init|report).* -o (\S+)", code.replace("\\\n", " "), re.M):
                    self.assertEqual(pages.setdefault(folder, document), document, folder)
        self.assertGreater(len(pages), 20)

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


class Introduction(unittest.TestCase):
    """The example by hand of docs/introduction.md, computed again; `Pages` runs the same case with the program."""

    PAGE = (ROOT / "docs/introduction.md").read_text(encoding="utf-8")

    def by_hand(self):
        k1, k2, inclination, friction, full = 150.0, 5.0, math.radians(16), 0.3, 10.0  # MN/m, which is N/um; um
        cotangent = 1 / math.tan(inclination)
        stuck = 1 / (2 * k1 * math.sin(inclination) ** 2)
        pressed, released = (stuck + cotangent * (cotangent + sign * friction) / (4 * k2) for sign in (-1, 1))
        force = full / pressed
        back = (force - full / released) / (1 / stuck - 1 / released)
        force_back = (full - back) / released
        energy = ((full - back) * force - full * force_back) / 2
        figures = {f"{1 / pressed:.4f}", f"{1 / stuck:.3f}", f"{1 / released:.4f}", f"{back:.4f}", f"{force:.3f}"}
        return figures | {f"{force_back:.3f}", f"{energy:.2f}"}, (force, 1 / pressed, 1 / stuck, energy / 1e3)

    def test_figures_by_hand(self):
        figures, _ = self.by_hand()
        for figure in figures:
            self.assertIn(figure, self.PAGE)
        drawn = (ROOT / "docs/images/one_bump_loop.svg").read_text(encoding="utf-8")
        for text in ("16.68 N at 10 µm", "14.03 N at 9.88 µm", "1.668 MN/m", "1.420 MN/m"):
            self.assertIn(text, drawn)

    def test_program_prints_them(self):
        printed = re.search(r"```text\n(.*?)```", self.PAGE, re.DOTALL).group(1).splitlines()
        _, expected = self.by_hand()
        for line, figure in zip(printed, expected, strict=True):
            self.assertAlmostEqual(float(line.split()[-1]) / figure, 1, delta=1e-4, msg=line)

    def test_forces_of_strips_are_those_of_finite_elements(self):
        table = (ROOT / "docs/verification/strip.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| (\d+) \| ([\d.]+) N \| ([\d.]+) N \|$", self.PAGE, re.MULTILINE)
        self.assertEqual(len(rows), 3)
        for bumps, free, rubbing in rows:
            for friction, force in (("0", free), ("0.1", rubbing)):
                self.assertIn(f"| {bumps} | {friction} | small | {force} |", table)


class Validation(unittest.TestCase):
    PAGE = (ROOT / "docs/validation.md").read_text(encoding="utf-8")

    def test_coefficients_are_those_of_the_loads(self):
        """Load over area, diameter and speed, in pounds, inches and thousands of revolutions per minute."""
        rows = re.findall(r"^\| \d \|(.*)\|$", self.PAGE, re.MULTILINE)
        self.assertEqual(len(rows), 4)
        for row in rows:
            cells = [float(re.match(r"[\d.]+", cell.strip()).group(0)) for cell in row.split("|")]
            for speed, load, coefficient in zip((15, 30, 45), cells[::2], cells[1::2], strict=True):
                self.assertAlmostEqual(load / 4.4482 / 1.5**3 / speed, coefficient, delta=0.006, msg=row)

    def test_load_of_the_table_is_what_the_program_prints(self):
        """`Pages` runs the program."""
        printed = float(re.search(r"load capacity at 45000 rpm: ([\d.]+) N", self.PAGE).group(1))
        self.assertIn(f"| {printed:.0f} | 0.26 |", re.search(r"^\| 3 \|.*$", self.PAGE, re.MULTILINE).group(0))

    def test_claims_are_those_of_the_page_of_the_paper(self):
        paper = (ROOT / "docs/verification/paper.md").read_text(encoding="utf-8")
        verdicts = re.findall(r"^\| \d+ \|[^|]*\| ([a-z ]+) \|", paper, re.MULTILINE)
        claims, stated = re.search(r"^\| (\d+) claims of the paper \|[^|]*\|([^|]*)\|", self.PAGE, re.MULTILINE).groups()
        self.assertEqual(len(verdicts), int(claims))
        for verdict in set(verdicts):
            self.assertIn(f" {verdicts.count(verdict)} {verdict}", stated)


class English(unittest.TestCase):
    """Phrases that were translated word by word, or ask riddles; what engineers write stands in their places."""

    CODE = ("src", "apps", "include", "bench", "tests", "web/solver", "python/src")

    PHRASES = """
        how the foils answer | force that holds the journal | results are told | that was right | height is: overall
        least film thickness | highest pressure | lowest pressure | highest stress | pressure beyond ambient
        in a row where gas enters | states are come to | when it turns | hardly carries | knows no | knows neither
        there is no load to carry | an angle is due | is no known key | holds results already | holds no number
        take the journal along | make the program as | find where the journal | tell how far | who runs a | who wants
        going on in their modes | slip on or stick | than that before | sense of winding | quantity over key
        rotor of one's own | way of the journal | keep the limits | what was drawn makes | bearing at work
        where the journal is | whirl coefficients | bed stiffness | pressing body | what is asked | nobody asked
        of which some | the begin of | its begin | from the begin | is told by | are told by | what it comes to
        what the bearings stand on | all that is recorded | unless told | a step is vain | former model
        is told with | are told with | one fault in | the design before | is the last that | um at least | µm at least
        all stuck | stuck stiffness | further stiffness | loaded stiffness | loaded, tangent | behind a click
        touchdown below | from nothing to | is more at | the rounding of | should mind | on a fault | assumed is one
        no cylinder | no cylinders | what the rig reads | the rig sees | number of sixths | several answers | nothing heats up
        stands for a millionth | held against sliding | called right | measured less fitted | that the search has met
    """.replace("\n", "|").split("|")

    def texts(self):
        """Documents, cases, pages, the Python package; of C++ comments, and texts: help, messages, labels."""
        for path in [*documents(), *(ROOT / "examples").glob("*.toml"), *(ROOT / "studies").rglob("*.toml")]:
            if path.name != "CHANGELOG.md":
                yield path, path.read_text(encoding="utf-8")
        for folder, kind in (("web/src", "ts"), ("python/bumpfoil", "py"), ("docs/site", "py")):
            for path in (ROOT / folder).rglob(f"*.{kind}"):
                yield path, re.sub(r"^\s*(//|#|\*)", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
        for path in [file for folder in self.CODE for file in (ROOT / folder).rglob("*.[ch]pp")]:
            text = path.read_text(encoding="utf-8")
            comments = re.findall(r"//[/!]?<?(.*)", text)
            code = re.sub(r"^\s*//.*$", "", text, flags=re.MULTILINE)
            texts = re.findall(r'"(?:[^"\\\n]|\\.)*"', re.sub(r'"\s*\n\s*"', "", code))
            # What tests expect or refuse is not of the program.
            yield path, "\n".join(comments if path.is_relative_to(ROOT / "tests") else comments + texts)

    def test_no_phrase_comes_back(self):
        phrases = [" ".join(phrase.split()) for phrase in self.PHRASES if phrase.strip()]
        pattern = re.compile(r"\b(" + "|".join(map(re.escape, phrases)) + r"|some \d[\d.,]*)(?!\w)")
        texts = {path: " ".join(text.lower().split()) for path, text in self.texts()}
        found = {path: hits for path, text in texts.items() if (hits := pattern.findall(text))}
        self.assertEqual(found, {})
        self.assertGreater(len(texts), 300)


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


class Blocks(InADirectory):
    """Blocks of code in the documents. Cases and programs are shown as examples hold them, `text` as the block before it
    printed it."""

    RUN = {"sh": ["bash", "-euo", "pipefail", "-c"], "octave": ["octave-cli", "--no-gui", "--eval"]}
    # They write the folders that take longest.
    LONG = re.compile(r"-o (running_strips|fluttering|exact)\b")

    def run_python(self, code):
        """In a copy of this process, which has imported what most blocks do."""
        printed = Path(self.directory) / "printed"
        child = os.fork()
        if child == 0:
            with printed.open("w") as file:
                os.dup2(file.fileno(), 1)
                os.dup2(file.fileno(), 2)
            os.chdir(self.directory)
            done = 1
            try:
                exec(compile(code, "<block>", "exec"), {"__name__": "__main__"})
                done = 0
            except BaseException:
                traceback.print_exc()
            finally:
                sys.stdout.flush()
                sys.stderr.flush()
                os._exit(done)
        _, status = os.waitpid(child, 0)
        text = printed.read_text()
        printed.unlink()
        self.assertEqual(status, 0, text)
        return text

    def run_blocks(self, is_run):
        shown = {
            language: "".join(example.read_text(encoding="utf-8") for example in (ROOT / "examples").glob(f"*.{language}"))
            for language in ("cpp", "toml")
        }
        blocks = 0
        for document in (ROOT / "docs").rglob("*.md"):
            printed = ""
            for language, code in re.findall(r"^```(\w+)\n(.*?)^```", document.read_text(encoding="utf-8"), re.M | re.S):
                if language == "python" and "import bumpfoil\n" in code and not PACKAGE.exists():
                    continue
                with self.subTest(document=document.name, language=language):
                    if language in shown:
                        self.assertIn(code, shown[language])
                        continue
                    if language == "text":
                        if printed is not None:
                            lines = [" ".join(line.split()) for line in printed.splitlines()]
                            for line in code.splitlines():
                                self.assertIn(" ".join(line.split()), lines)
                        continue
                    printed = None
                    if not is_run(code):
                        continue
                    printed = self.run_python(code) if language == "python" else self.run_in_directory([*self.RUN[language], code])
                blocks += 1
        return blocks


class Pages(Blocks):
    def test_examples_are_right(self):
        examples = sorted((ROOT / "examples").glob("*.toml"))
        self.assertGreater(len(examples), 3)
        for example in examples:
            self.run_in_directory([str(PROGRAM), "check", str(example)])

    def test_blocks_of_code_run(self):
        """On the results of the reference bearing, in the folders that they name."""
        case = str(ROOT / "examples/gen1.toml")
        self.run_in_directory([str(PROGRAM), "cycle", case, "-o", "loops"])
        over = ["--over", "cycle.amplitude=60 um:90 um:10 um", "--over", "friction.coefficient=[0.05, 0.1]"]
        self.run_in_directory([str(PROGRAM), "sweep", case, *over, "-o", "grid"])
        case = str(ROOT / "examples/vibration.toml")
        over = ["--command", "vibration", "--over", "friction.coefficient=[0.1, 0.2]", "--set", "vibration.steps=5"]
        self.run_in_directory([str(PROGRAM), "sweep", case, *over, "-o", "stiffness"])
        os.symlink(ROOT / "examples", Path(self.directory) / "examples")
        self.run_in_directory([str(PROGRAM), "montecarlo", str(ROOT / "examples/tolerances.toml"), "-o", "tolerances"])
        if PACKAGE.exists():
            sys.path.insert(0, str(PACKAGE))
            import bumpfoil, matplotlib, numpy, pandas, xarray  # noqa: E401, F401
        self.assertGreater(self.run_blocks(lambda code: not self.LONG.search(code)), 50)


class LongPages(Blocks):
    def test_blocks_of_code_run(self):
        os.symlink(ROOT / "examples", Path(self.directory) / "examples")
        self.assertEqual(self.run_blocks(self.LONG.search), 3)


class CommandsNotRun(InADirectory):
    """Those that are set in by four blanks: they take clusters, builds or long, but the program and the project know them."""

    COMMAND = re.compile(r"^    (?:\(cd tests && )?(?=(?:bumpfoil|make|mpirun|sbatch|cmake|python3|\.\./build)\b)(.*?)\)?$", re.M)

    def setUp(self):
        super().setUp()
        self.help = {}
        listed = (path.read_text(encoding="utf-8") for folder in ("tests", "bench") for path in (ROOT / folder).rglob("CMakeLists.txt"))
        self.targets = set(re.findall(r"add_executable\((\w+)", "".join(listed)))
        self.made = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.M))

    def look_at_options(self, words):
        if words[0] not in self.help:
            self.help[words[0]] = self.run_in_directory([str(PROGRAM), words[0], "--help"])
        for word in words[1:]:
            if word.startswith("-"):
                self.assertTrue(re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", self.help[words[0]]), word)

    def look_at(self, words):
        first, *others = words
        if first == "mpirun":
            self.look_at(words[words.index("bumpfoil") :])
        elif first == "bumpfoil":
            self.look_at_options(others)
        elif first == "make":
            self.assertIn(others[0], self.made)
        elif first == "cmake":
            self.assertIn(words[words.index("--target") + 1], self.targets)
        elif first.startswith("../build/"):
            self.assertIn(Path(first).name, self.targets)
        for word in others:
            if word.startswith(("examples/", "bench/")):
                self.assertTrue((ROOT / word).exists(), word)

    def test_are_known(self):
        found = 0
        for document in documents():
            text = re.sub(r"^```.*?^```", "", document.read_text(encoding="utf-8"), flags=re.M | re.S)
            text = re.sub(r" \\\n +", " ", text)  # lines that go on
            for line in self.COMMAND.findall(text):
                with self.subTest(document=document.name, line=line):
                    self.look_at(shlex.split(line, comments=True))
                found += 1
        self.assertGreater(found, 30)


class VariableFoils(InADirectory):
    """Rows of the table of docs/variable_foils.md, computed again; all of them would take a minute."""

    IN_TURN = [0.0, -28e-6] * 13
    ROWS = {
        "uniform: the reference foil": {},
        "pitch 4.6 and 4.4 mm in turn": {"pitch": [4.6e-3, 4.4e-3] * 13},
        "thickness 0.12 and 0.09 mm in turn": {"thickness": [0.12e-3, 0.09e-3] * 13},
        "uniform, height errors 0 and −28 µm in turn": {"height_errors": IN_TURN},
        "height 0.508 and 0.48 mm in turn": {"height": [0.508e-3 + lower for lower in IN_TURN]},
    }

    def cycles(self, model, dimensions):
        settings = [f"bump_foil.model={model}", "cycle.steps=20", 'cycle.directions=["+X", "+Y", "-Y", "-X"]']
        settings += [f"bump_foil.{key}={values}" for key, values in dimensions.items()]
        sets = [word for setting in settings for word in ("--set", setting)]
        case = str(ROOT / "examples/gen1.toml")
        self.run_in_directory([str(PROGRAM), "cycle", case, "-o", "foil", "--force", "--quiet", *sets])
        summary = json.loads((Path(self.directory) / "foil/summary.json").read_text(encoding="utf-8"))
        return {cycle["direction_deg"]: cycle for cycle in summary["cycles"]}

    def row(self, dimensions):
        truss, frame = (self.cycles(model, dimensions) for model in ("truss", "frame"))
        forces = [truss[angle]["max_force_N"] / frame[angle]["max_force_N"] - 1 for angle in (0, 90, 270, 180)]
        a, b = truss[180]["bump_loads_N"], frame[180]["bump_loads_N"]
        others = (sum(a[1:-1]) - sum(b[1:-1])) / frame[180]["max_force_N"]
        return [100 * part for part in (*forces, a[0] / b[0] - 1, a[-1] / b[-1] - 1, others)]

    def test_table_shows_what_the_program_computes(self):
        page = (ROOT / "docs/variable_foils.md").read_text(encoding="utf-8")
        for name, dimensions in self.ROWS.items():
            shown = re.search(rf"^\| {re.escape(name)} \|(.*)\|$", page, re.MULTILINE).group(1).split("|")
            computed = [f"{part:.1f}".replace("-0.0", "0.0").replace("-", "−") for part in self.row(dimensions)]
            self.assertEqual([cell.strip() for cell in shown], computed, name)


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
