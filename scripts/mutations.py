"""Changes one token of the sources at a time and sees whether the short tests of the module notice.

Usage: mutations.py BUILD RESULTS.jsonl [--module NAME]... [--count N] [--seed S] [--jobs N] [--page PAGE.md]

Mutants are drawn evenly over the lines of a module. The changed source is compiled by itself, beside the tree, and
linked before the library of BUILD, whose own functions of the same names it hides: a minute for what a build of the
library would take ten. A function of the library that was inlined elsewhere stays what it was, which can only hide
mutants from tests, not the other way round. Each mutant is a line of RESULTS: where it is, what it changes and what
became of it. Those that are there are not tried again, so that a stopped run goes on. With --page the results are
written as a page instead.
"""

import argparse
import json
import random
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# The tests of a module, quickest first: those of a later program run where those before it have noticed nothing.
QUICK_FILMS = "verification_film --gtest_filter=-FilmBranches.*:FilmInterference.*:Films/*:*Refinement*"
MODULES = {
    "contact": ("unit_contact", "unit_structure", "unit_bearing", "property", "verification"),
    "structure": ("unit_structure", "unit_bearing", "unit_film", "verification", QUICK_FILMS),
    "film": ("unit_film", "unit_bearing", QUICK_FILMS),
    "bearing": ("unit_bearing", "unit_motion", QUICK_FILMS),
    "motion": ("unit_motion", "verification_rotor"),
    "experiments": ("unit_experiments",),
}
SECONDS_OF_TESTS = 1800

# What stands for what; spaces around an operator keep templates, pointers and increments out.
SWAPS = [
    (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" += ", " -= "), (" -= ", " += "),
    (" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
    (" && ", " || "), (" || ", " && "), ("std::min", "std::max"), ("std::max", "std::min"), ("std::sin", "std::cos"),
    ("std::cos", "std::sin"), ("true", "false"), ("false", "true"), ("return -", "return "), ("(-", "("), ("(!", "("),
]  # fmt: skip
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+(?:e[-+]?\d+)?|[1-9]\d*)(?![\w.])")
STATEMENT = re.compile(r"\s+[\w.\[\]()>-]+ (?:[-+*/]?=) [^;{}]*;")
LEFT_ALONE = re.compile(r'^\s*(?://|#|template|using|static_assert|BUMPFOIL_ASSERT|namespace)|"|\bcase\b|<[a-z:_]+>')


def changes_of(line):
    """All changes of a line: (description, new line)."""
    code = line.split("//")[0]
    if LEFT_ALONE.search(code):
        return
    for old, new in SWAPS:
        for match in re.finditer(re.escape(old), code):
            yield f"{old.strip()} -> {new.strip() or 'nothing'}", line[: match.start()] + new + line[match.end() :]
    for match in NUMBER.finditer(code):
        twice = str(2 * int(match[0])) if match[0].isdigit() else repr(2.0 * float(match[0]))
        yield f"{match[0]} -> {twice}", line[: match.start()] + twice + line[match.end() :]
    if STATEMENT.fullmatch(code):
        yield "dropped", re.match(r"\s*", line)[0] + ";"


def mutants_of(root, module, count, generator):
    """A change of each of `count` lines."""
    lines = []
    for file in sorted((root / "src" / module).rglob("*.cpp")):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            changes = list(changes_of(line))
            if changes:
                lines.append((file.relative_to(root).as_posix(), number, line, changes))
    for file, number, line, changes in generator.sample(lines, min(count, len(lines))):
        change, changed = generator.choice(changes)
        yield {"module": module, "file": file, "line": number, "code": line.strip(), "change": change, "new": changed}


def run(command, seconds, folder):
    """Whether it ends well in that time."""
    try:
        return subprocess.run(command, cwd=folder, timeout=seconds, capture_output=True, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def commands_of(build, target):
    """What Ninja would run to build the target, the link of its program last."""
    told = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True, text=True, check=True)
    return told.stdout.splitlines()


def compile_command(build):
    """How a source of the library is compiled, without the names of the source and of what comes out."""
    commands = commands_of(build, "src/libbumpfoil.a")
    line = next(line for line in commands if "/Unity/" in line and " -o src/" in line)
    return shlex.split(line)[: shlex.split(line).index("-MD")]


def link_command(build, program, mutant, linked):
    line = commands_of(build, program)[-1]
    words = shlex.split(line.removeprefix(": && ").split(" && ")[0])
    words[words.index("-o") + 1] = linked
    library = next(place for place, word in enumerate(words) if word.endswith("libbumpfoil.a"))
    return [*words[:library], mutant, "-Wl,--allow-multiple-definition", *words[library:]]


def verdict_on(root, build, mutant):
    """caught (by which program), survived, or not compiled."""
    lines = (root / mutant["file"]).read_text(encoding="utf-8").splitlines()
    lines[mutant["line"] - 1] = mutant["new"]
    with tempfile.TemporaryDirectory() as folder:
        source, object_file, linked = (f"{folder}/{name}" for name in ("mutant.cpp", "mutant.o", "tests"))
        Path(source).write_text("\n".join(lines) + "\n", encoding="utf-8")
        if not run([*compile_command(build), "-w", "-c", source, "-o", object_file], 3600, build):
            return "not compiled"
        for tests in MODULES[mutant["module"]]:
            program, *options = tests.split()
            if not run(link_command(build, program, object_file, linked), 3600, build):
                return "not compiled"
            command = [linked, "--gtest_brief=1", "--gtest_fail_fast", *options]
            if not run(command, SECONDS_OF_TESTS, root / "tests"):
                return f"caught by {program}"
    return "survived"


def page_of(results):
    """The table of the results, and all that survived."""
    tried = [one for one in results if one["verdict"] != "not compiled"]
    yield "# Mutations\n"
    yield "One token of the sources is changed at a time, and the short tests of its module run on it"
    yield "(`make mutations`). What they do not notice is listed below.\n"
    yield "| module | changes | caught | survived |\n|---|---|---|---|"
    for module in MODULES:
        own = [one["verdict"] for one in tried if one["module"] == module]
        if own:
            yield f"| {module} | {len(own)} | {sum(one.startswith('caught') for one in own)} | {own.count('survived')} |"
    yield "\n| where | line | change |\n|---|---|---|"
    for one in tried:
        if one["verdict"] == "survived":
            code = one["code"].replace("|", "\\|")
            yield f"| `{one['file']}:{one['line']}` | `{code}` | `{one['change'].replace('|', chr(92) + '|')}` |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("results", type=Path)
    parser.add_argument("--module", action="append", choices=MODULES)
    parser.add_argument("--count", type=int, default=70, help="of each module")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="mutants at the same time")
    parser.add_argument("--page", type=Path)
    options = parser.parse_args()
    root = Path(__file__).resolve().parent.parent
    results = [json.loads(line) for line in options.results.read_text().splitlines()] if options.results.exists() else []
    if options.page:
        options.page.write_text("\n".join(page_of(results)) + "\n", encoding="utf-8")
        return 0
    known = {(one["file"], one["line"], one["change"]) for one in results}
    options.results.parent.mkdir(parents=True, exist_ok=True)
    build = options.build.resolve()

    def try_one(mutant):
        mutant["verdict"] = verdict_on(root, build, mutant)
        print(f"{mutant['file']}:{mutant['line']}: {mutant['change']}: {mutant['verdict']}", flush=True)
        with options.results.open("a") as file:
            file.write(json.dumps(mutant) + "\n")

    drawn = [
        mutant
        for module in options.module or MODULES
        for mutant in mutants_of(root, module, options.count, random.Random(options.seed))
        if (mutant["file"], mutant["line"], mutant["change"]) not in known
    ]
    with ThreadPoolExecutor(options.jobs) as jobs:
        list(jobs.map(try_one, drawn))
    return 0


if __name__ == "__main__":
    sys.exit(main())
