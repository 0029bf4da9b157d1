"""Changes one token of the sources at a time and sees whether the short tests of the module notice.

Usage: mutations.py BUILD RESULTS.jsonl [--module NAME]... [--count N] [--seed S] [--jobs N] [--again] [--page PAGE.md]

Mutants are drawn evenly over the lines of a module. Those of one source are compiled together (mutant_schemata.py),
beside the tree, and linked before the library of BUILD, whose own functions of the same names they hide: seconds for
what a build of the library would take minutes. A function of the library that was inlined elsewhere stays what it was,
which can only hide mutants from tests, not the other way round. The tests beside the changed source run first, as they
notice most.

Each mutant is a line of RESULTS: where it is, what it changes and what became of it. Those that are there are not tried
again, so that a stopped run goes on; with --again those that no test noticed are, where tests have been written since.
With --page the results are written as a page instead; why a change is none that a test should notice is in
mutations.json.
"""

import argparse
import functools
import itertools
import json
import os
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mutant_schemata import HEADER, switched

# Of the films against the prototype, those of less than half a second stand in front; those of minutes are left out.
FIRST_OF_FILMS = (
    "FilmPlain.*:FilmPads.*:FilmInSleeves.*:FilmTables.*:FilmOverFoils.I*:FilmOverFoils.MeetsThePrototypeAlong*:"
    "FilmOverFoils.W*:FilmOverTheWidth.C*:FilmOverTheWidth.S*:FilmUnderATiltedJournal.StiffnessIs*:FilmHeld.M*:"
    "FilmHeld.IsA*:FilmHeld.IsTheSame*:FilmTime.G*:FilmTime.IsTheSame*:FilmAsperities.StiffnessIs*:FilmFormed.P*"
)
FIRST_FILMS = f"verification_film --gtest_filter={FIRST_OF_FILMS}"
QUICK_FILMS = (
    f"verification_film --gtest_filter=-{FIRST_OF_FILMS}:FilmBranches.*:FilmInterference.*:Films/*:*Refinement*:"
    "FilmTime.FreeMotions*:FilmFormed.Runs*:FilmUnderATiltedJournal.MeetsThePrototype"
)
# Of each module the tests of seconds, then those of a minute, which only meet what those before have not noticed. The
# tests beside a source come before all of them.
MODULES = {
    "contact": (("unit_contact", "unit_structure", "unit_bearing"), ("property", "verification")),
    "structure": (("unit_structure", "unit_bearing", "unit_film"), (FIRST_FILMS, "verification", QUICK_FILMS)),
    "film": (("unit_film", "unit_bearing", FIRST_FILMS), (QUICK_FILMS,)),
    "bearing": (("unit_bearing", FIRST_FILMS), ("verification", "unit_motion", QUICK_FILMS)),
    "motion": ((), ("unit_motion", "verification_rotor")),
    "experiments": ((), ("unit_experiments",)),
}
SUITE = re.compile(r"^(?:TYPED_TEST|TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\((\w+),", re.MULTILINE)
# A mutant that takes more processor time goes on for ever: all tests of a program; those beside a source are allowed
# so many times as long as on what is unchanged, and some seconds.
SECONDS_OF_PROGRAM = 600
TIMES_AS_LONG = 5
SECONDS_BESIDES = 10
MOST_MEMORY = 4 << 30

NOT_TRIED = ("not compiled", "gone")
OPEN = "not noticed by quick tests"

# What stands for what; spaces around an operator keep templates, pointers and increments out.
SWAPS = [
    (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" += ", " -= "), (" -= ", " += "),
    (" == ", " != "), (" != ", " == "),
    (" && ", " || "), (" || ", " && "), ("std::min", "std::max"), ("std::max", "std::min"), ("std::sin", "std::cos"),
    ("std::cos", "std::sin"), ("true", "false"), ("false", "true"), ("return -", "return "), ("(-", "("), ("(!", "("),
]  # fmt: skip
# A loop or a place goes one too far; any other condition is turned round, as two real numbers are hardly ever equal.
BOUND = re.compile(r"\bfor \(|size\(\)")
BOUNDS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > ")]
CONDITIONS = [(" < ", " >= "), (" <= ", " > "), (" > ", " <= "), (" >= ", " < ")]
NUMBER = re.compile(r"(?<![\w.])(?<!\de-)(\d+\.\d+|\d+(?:\.\d+)?e[-+]?\d+|[1-9]\d*)(?![\w.])")
STATEMENT = re.compile(r"\s+[\w.\[\]()>-]+ (?:[-+*/]?=) [^;{}]*;")
# Named constants of iterations, steps and tolerances, which tune how quickly or finely an answer is found; messages;
# memory that is only taken sooner.
LEFT_ALONE = re.compile(
    r"^constexpr (?:int|double|Eigen::Index|std::size_t|std::int64_t) \w+ =|"
    r'^\s*(?://|#|template|using|static_assert|BUMPFOIL_ASSERT|namespace)|"|\bcase\b|<[a-z:_]+>|\breserve\('
)


def other_number(text):
    """Twice a number; a thousand times a tolerance; one in place of zero."""
    if text.isdigit():
        return str(2 * int(text))
    value = float(text)
    return repr(1000.0 * value if "e" in text else 2.0 * value if value else 1.0)


def changes_of(line):
    """All changes of a line: (description, new line, place of what changes, old, new)."""
    code = line.split("//")[0]
    if LEFT_ALONE.search(code):
        return
    for old, new in [*SWAPS, *(BOUNDS if BOUND.search(code) else CONDITIONS)]:
        for match in re.finditer(re.escape(old), code):
            changed = line[: match.start()] + new + line[match.end() :]
            yield f"{old.strip()} -> {new.strip() or 'nothing'}", changed, match.start(), old, new
    for match in NUMBER.finditer(code):
        other = other_number(match[0])
        changed = line[: match.start()] + other + line[match.end() :]
        yield f"{match[0]} -> {other}", changed, match.start(), match[0], other
    if STATEMENT.fullmatch(code):
        yield "dropped", re.match(r"\s*", line)[0] + ";", 0, "", ""


def mutants_of(root, module, count, generator):
    """A change of each of `count` lines."""
    lines = []
    for file in sorted((root / "src" / module).rglob("*.cpp")):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            changes = list(changes_of(line))
            if changes:
                lines.append((file.relative_to(root).as_posix(), number, line, changes))
    for file, number, line, changes in generator.sample(lines, min(count, len(lines))):
        change, changed, *_ = generator.choice(changes)
        yield {"module": module, "file": file, "line": number, "code": line.strip(), "change": change, "new": changed}


def runs(command, folder):
    return subprocess.run(command, cwd=folder, capture_output=True, check=False).returncode == 0


def seconds_of(command, folder, temporary, chosen=0, limit=None):
    """Processor time of a test program and whether it ended well with a mutant; it is ended after `limit` seconds."""
    limits = ["prlimit", f"--as={MOST_MEMORY}", *([f"--cpu={limit:.0f}"] if limit else [])]
    environment = {**os.environ, "TMPDIR": temporary, "MUTANT": str(chosen)}
    with subprocess.Popen(
        [*limits, *command], cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as process:
        # What waits for ever takes no processor time.
        until = time.monotonic() + 60 + 20 * limit if limit else float("inf")
        while os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
            if time.monotonic() > until:
                process.kill()
            time.sleep(0.02)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return used.ru_utime + used.ru_stime, process.returncode == 0


def commands_of(build, target):
    """What Ninja would run to build the target, the link of its program last."""
    told = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True, text=True, check=True)
    return told.stdout.splitlines()


@functools.cache
def compile_command(build, folder):
    """How a source of the library is compiled, without the names of the source and of what comes out: less optimised, as
    it takes longer to compile than to run. Accesses behind the end of what holds them are ended, as under the sanitizers;
    the header in front is compiled for that anew."""
    commands = commands_of(build, "src/libbumpfoil.a")
    line = next(line for line in commands if "/Unity/" in line and " -o src/" in line)
    words = [*shlex.split(line)[: shlex.split(line).index("-MD")], "-O1", "-w", "-D_GLIBCXX_ASSERTIONS"]
    place = words.index("-include")
    header = f"{folder}/{Path(words[place + 1]).name}"
    Path(header).write_bytes(Path(words[place + 1]).read_bytes())
    words = [*words[:place], *words[place + 2 :]]
    subprocess.run([*words, "-x", "c++-header", header, "-o", f"{header}.gch"], cwd=build, check=True)
    Path(f"{folder}/mutants.hpp").write_text(HEADER, encoding="utf-8")
    return [*words, "-include", header, "-include", f"{folder}/mutants.hpp"]


def link_command(build, program, mutant, linked):
    line = commands_of(build, program)[-1]
    words = shlex.split(line.removeprefix(": && ").split(" && ")[0])
    words[words.index("-o") + 1] = linked
    library = next(place for place, word in enumerate(words) if word.endswith("libbumpfoil.a"))
    return [*words[:library], mutant, "-Wl,--allow-multiple-definition", *words[library:]]


@functools.cache
def own_suites(root, file):
    """Names of the suites of tests beside a source: of its own file, or of all in its folder where it has none."""
    folder = root / "tests/unit" / Path(file).parent.relative_to("src")
    own = folder / f"test_{Path(file).stem}.cpp"
    files = [own] if own.exists() else folder.glob("*.cpp") if len(Path(file).parts) > 3 else []
    return sorted({suite for test in files for suite in SUITE.findall(test.read_text(encoding="utf-8"))})


def place_of(lines, mutant):
    """Index of the line that the mutant changes, which may have moved since it was drawn."""
    places = [place for place, line in enumerate(lines) if line.strip() == mutant["code"]]
    return min(places, key=lambda place: abs(place + 1 - mutant["line"]), default=None)


class Mutants:
    """A source with some of its mutants, compiled together, and the test programs that are linked with it."""

    def __init__(self, root, build, kept, mutants):
        self.root, self.build, self.kept, self.mutants = root, build, kept, mutants
        self.file, self.module = mutants[0]["file"], mutants[0]["module"]
        self.lines = (root / self.file).read_text(encoding="utf-8").splitlines()
        self.together, self.alone = [], []
        self.limit = SECONDS_OF_PROGRAM
        for mutant in mutants:
            place = place_of(self.lines, mutant)
            others = [place_of(self.lines, other) for other in self.together]
            if place is None:
                mutant["verdict"] = "gone"
            elif place in others or not self.switched_line(mutant, 1):
                self.alone.append(mutant)
            else:
                self.together.append(mutant)

    def switched_line(self, mutant, k):
        line = self.lines[place_of(self.lines, mutant)]
        changes = [rest for _, new, *rest in changes_of(line) if new == mutant["new"]]
        return switched(line, *changes[0], k) if changes else None

    def compiled(self, folder, lines):
        """Where the compiler sees errors, by line; None if nowhere."""
        source = f"{folder}/mutant.cpp"
        Path(source).write_text("\n".join(lines) + "\n", encoding="utf-8")
        command = [*compile_command(self.build, self.kept), "-fno-diagnostics-show-caret", "-c", source]
        told = subprocess.run(
            [*command, "-o", f"{folder}/mutant.o"], cwd=self.build, capture_output=True, text=True, check=False
        )
        return {int(line) - 1 for line in re.findall(r"mutant\.cpp:(\d+):", told.stderr)} if told.returncode else None

    def try_all(self, stage, report):
        """Gives all their verdicts: caught (by which program), OPEN, survived, or not compiled."""
        while self.together:
            with tempfile.TemporaryDirectory() as folder:
                lines = list(self.lines)
                for k, mutant in enumerate(self.together, 1):
                    lines[place_of(self.lines, mutant)] = self.switched_line(mutant, k)
                wrong = self.compiled(folder, lines)
                if wrong is None:
                    self.meet_tests(folder, self.together, stage, report)
                    break
                # What is wrong anywhere else comes of one of them.
                left = [mutant for mutant in self.together if place_of(self.lines, mutant) not in wrong]
                left = left if len(left) < len(self.together) else []
                self.alone += [mutant for mutant in self.together if mutant not in left]
                self.together = left
        for mutant in self.alone:
            with tempfile.TemporaryDirectory() as folder:
                lines = list(self.lines)
                lines[place_of(self.lines, mutant)] = mutant["new"]
                if self.compiled(folder, lines) is None:
                    self.meet_tests(folder, [mutant], stage, report)
                else:
                    mutant["verdict"] = "not compiled"
                    report(mutant)

    def meet_tests(self, folder, mutants, stage, report):
        """What is left of the mutants after each test program, those beside the source first."""
        beside = f"unit_{self.module}"
        own = ":".join(f"{suite}.*:*/{suite}.*:{suite}/*" for suite in own_suites(self.root, self.file))
        tests = [(beside, [f"--gtest_filter={own}"])] if own and stage == 0 else []
        for program, *options in map(str.split, MODULES[self.module][stage]):
            tests.append((program, [f"--gtest_filter=-{own}"] if own and program == beside else options))
        last = None
        for place, (program, options) in enumerate(tests):
            if program != last and not runs(
                link_command(self.build, program, f"{folder}/mutant.o", f"{folder}/tests"), self.build
            ):
                raise RuntimeError(f"{self.file}: {program} does not link")
            last = program
            command = [f"{folder}/tests", "--gtest_brief=1", "--gtest_fail_fast", *options]
            limit = SECONDS_OF_PROGRAM
            if place == 0 and own and stage == 0:
                if mutants is self.together:
                    usual, passed = seconds_of(command, self.root / "tests", folder)
                    if not passed:
                        raise RuntimeError(f"{self.file}: {program} fails on what is unchanged")
                    self.limit = SECONDS_BESIDES + TIMES_AS_LONG * usual
                limit = self.limit
            for k, mutant in enumerate(mutants, 1):
                if "verdict" in mutant or seconds_of(command, self.root / "tests", folder, k, limit)[1]:
                    continue
                mutant["verdict"] = f"caught by {program}"
                report(mutant)
        for mutant in mutants:
            if "verdict" not in mutant:
                mutant["verdict"] = "survived" if stage == 1 else OPEN
                report(mutant)


def key_of(mutant):
    return mutant["file"], mutant["line"], mutant["new"]


def page_of(results, reasons):
    """The table of the results, and all changes that no test detects."""
    last = {key_of(one): one for one in results}
    yield "# Mutations\n"
    yield "`make mutations` changes one token of the sources at a time and runs the short tests of its module. It"
    yield "changes signs, operators, conditions, constants and loop bounds, and drops statements. Comparisons"
    yield "outside loops and sizes are reversed; tolerances grow a thousandfold. Messages, and named constants of"
    yield "iterations, steps and tolerances, are not changed. Lines are sampled uniformly over a module; the"
    yield "sources with most of them come first.\n"
    yield "| module | changes | caught | of these by tests added since | not caught |\n|---|---|---|---|---|"
    rows = []
    for module in MODULES:
        own = [one for one in last.values() if one["module"] == module and one["verdict"] not in NOT_TRIED]
        caught = [one for one in own if one["verdict"].startswith("caught")]
        rows.append([len(own), len(caught), sum("again" in one for one in caught), len(own) - len(caught)])
        yield "| " + " | ".join(map(str, [module, *rows[-1]])) + " |"
    yield "| all | " + " | ".join(str(sum(numbers)) for numbers in zip(*rows)) + " |"
    lasting = [one for one in last.values() if one["verdict"] in ("survived", OPEN)]
    why = [reasons.get(one["file"], {}).get(f"{one['code']} {one['change']}", "**Open.**") for one in lasting]
    tried, caught = sum(row[0] for row in rows), sum(row[1] for row in rows)
    equivalent = sum(not reason.startswith(("Could change a result", "**Open")) for reason in why)
    share = 100 * caught / (tried - equivalent)
    yield f"\nOf those not caught {equivalent} are equivalent mutants: a converged run gives the same result, after more or fewer"
    yield f"steps. Of the other {tried - equivalent} changes {share:.1f} % are caught.\n"
    left = sum(one["verdict"] == OPEN for one in lasting)
    yield f"Changes that no test detects; for {left} of these only the short tests of their module were run:\n"
    yield "| where | line | change | why |\n|---|---|---|---|"
    for one, reason in zip(lasting, why):
        # Neither a column nor a link.
        code, change = (text.replace("|", "\\|").replace("](", "] (") for text in (one["code"], one["change"]))
        yield f"| `{one['file']}:{one['line']}` | `{code}` | `{change}` | {reason} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("results", type=Path)
    parser.add_argument("--module", action="append", choices=MODULES)
    parser.add_argument("--count", type=int, default=70, help="of each module")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="mutants at the same time")
    parser.add_argument("--again", action="store_true", help="those that no test noticed")
    parser.add_argument("--page", type=Path)
    options = parser.parse_args()
    root = Path(__file__).resolve().parent.parent
    results = [json.loads(line) for line in options.results.read_text().splitlines()] if options.results.exists() else []
    if options.page:
        reasons = json.loads((root / "scripts/mutations.json").read_text(encoding="utf-8"))
        options.page.write_text("\n".join(page_of(results, reasons)) + "\n", encoding="utf-8")
        return 0
    options.results.parent.mkdir(parents=True, exist_ok=True)
    build = options.build.resolve()
    modules = options.module or list(MODULES)
    known = {key_of(one): one for one in results}
    if options.again:
        unnoticed = [one for one in known.values() if one["verdict"] in ("survived", OPEN)]
        drawn = [{**one, "again": True} for one in unnoticed if one["module"] in modules]
    else:
        every = (mutants_of(root, module, options.count, random.Random(options.seed)) for module in modules)
        drawn = [one for one in itertools.chain(*every) if key_of(one) not in known]
    known.update({key_of(one): one for one in drawn})

    def report(mutant):
        print(f"{mutant['file']}:{mutant['line']}: {mutant['change']}: {mutant['verdict']}", flush=True)
        with options.results.open("a") as file:
            file.write(json.dumps(mutant) + "\n")

    def try_source(mutants, stage):
        for mutant in mutants:
            mutant.pop("verdict", None)
        try:
            Mutants(root, build, kept, mutants).try_all(stage, report)
        except RuntimeError as error:
            print(error, flush=True)

    def by_source(mutants):
        """The source with most mutants of each module in turn, so that a run that is stopped has tried many of all."""
        sources = {module: {} for module in modules}
        for mutant in mutants:
            sources[mutant["module"]].setdefault(mutant["file"], []).append(mutant)
        sizes = [sorted(files.values(), key=len, reverse=True) for files in sources.values()]
        return [source for turn in itertools.zip_longest(*sizes) for source in turn if source]

    with tempfile.TemporaryDirectory() as kept, ThreadPoolExecutor(options.jobs) as jobs:
        compile_command(build, kept)
        list(jobs.map(try_source, by_source(drawn), itertools.repeat(0)))
        left = [one for one in known.values() if one.get("verdict") == OPEN and one["module"] in modules]
        list(jobs.map(try_source, by_source(left), itertools.repeat(1)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
