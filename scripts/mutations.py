"""Changes one token of the sources at a time, builds, and sees whether the short tests of the module notice.

Usage: mutations.py BUILD RESULTS.jsonl [--module NAME]... [--count N] [--seed S] [--page PAGE.md]

Mutants are drawn evenly over the lines of a module. Each is a line of RESULTS: where it is, what it changes and what
became of it. Those that are there are not tried again, so that a stopped run goes on. The sources are as they were in
the end, and must be committed before. With --page the results are written as a page instead.
"""

import argparse
import json
import random
import re
import subprocess
import sys
from pathlib import Path

MODULES = ("contact", "structure", "film", "bearing", "motion", "experiments")
SECONDS_OF_TESTS = 600

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
    try:
        return subprocess.run(command, cwd=folder, timeout=seconds, capture_output=True, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def verdict_on(root, build, mutant):
    """caught, survived, or not compiled."""
    file = root / mutant["file"]
    text = file.read_text(encoding="utf-8")
    lines = text.splitlines()
    lines[mutant["line"] - 1] = mutant["new"]
    tests = f"unit_{mutant['module']}"
    try:
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        if not run(["cmake", "--build", build, "--target", tests], 3600, root):
            return "not compiled"
        program = [build / tests, "--gtest_brief=1", "--gtest_fail_fast"]
        return "survived" if run(program, SECONDS_OF_TESTS, root / "tests") else "caught"
    finally:
        file.write_text(text, encoding="utf-8")


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
            yield f"| {module} | {len(own)} | {own.count('caught')} | {own.count('survived')} |"
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
    parser.add_argument("--page", type=Path)
    options = parser.parse_args()
    root = Path(__file__).resolve().parent.parent
    results = [json.loads(line) for line in options.results.read_text().splitlines()] if options.results.exists() else []
    if options.page:
        options.page.write_text("\n".join(page_of(results)) + "\n", encoding="utf-8")
        return 0
    if subprocess.run(["git", "diff", "--quiet", "--", "src"], cwd=root, check=False).returncode != 0:
        sys.exit("src/ has changes that are not committed: commit or remove them")
    known = {(one["file"], one["line"], one["change"]) for one in results}
    options.results.parent.mkdir(parents=True, exist_ok=True)
    for module in options.module or MODULES:
        for mutant in mutants_of(root, module, options.count, random.Random(options.seed)):
            if (mutant["file"], mutant["line"], mutant["change"]) in known:
                continue
            mutant["verdict"] = verdict_on(root, options.build.resolve(), mutant)
            print(f"{mutant['file']}:{mutant['line']}: {mutant['change']}: {mutant['verdict']}", flush=True)
            with options.results.open("a") as file:
                file.write(json.dumps(mutant) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
