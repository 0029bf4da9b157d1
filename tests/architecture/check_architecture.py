"""Checks the rules that keep the modules apart; prints every error and exits non-zero if there is one.

Usage: check_architecture.py REPOSITORY
"""

import re
import sys
from pathlib import Path

# What each module may include, besides itself. A new module gets a row here first.
ALLOWED = {
    "core": set(),
    "model": {"core"},
    "structure": {"core", "model"},
    "contact": {"core"},
    "rotor": {"core"},
    "film": {"core", "structure"},
    "bearing": {"core", "model", "structure", "contact", "film"},
    "motion": {"core", "model", "structure", "contact", "rotor", "film", "bearing"},
    "case": {"core", "model", "structure"},
    "results": {"core", "model", "case"},
    "experiments": {"core", "model", "structure", "contact", "rotor", "film", "bearing", "motion", "case", "results"},
    "origin": {"core", "model", "structure", "contact", "film", "bearing", "motion", "experiments"},
    "ensemble": {"core", "model", "case", "results", "experiments"},
    "optimise": {"core", "model", "case", "results", "experiments", "ensemble", "sweep"},
    "readers": {"core", "model", "case", "results", "experiments", "ensemble"},
    "sweep": {"core", "model", "case", "results", "experiments"},
    "pages": {"core", "model", "structure", "case", "results", "experiments", "ensemble", "sweep", "readers"},
    "studies": {"core", "model", "structure", "contact", "film", "experiments", "ensemble", "case", "results"},
}

# The method of the source paper and its predecessor: nothing includes them but the place where experiments choose what
# computes.
DOORS = {"origin": "src/experiments/build.cpp"}

# Headers that a module must not include, not through others either, though it may include their module. The case stops
# at the door of experiments: what lies below takes geometry, materials and settings as values of their own. Structure
# takes a FoilDesign, whatever form a design of the bearing gives the foils.
CASE_HEADERS = {f"bumpfoil/model/{name}.hpp" for name in ("case", "validation")}
FOREIGN_HEADERS = {
    "bearing": CASE_HEADERS,
    "motion": CASE_HEADERS,
    "structure": CASE_HEADERS | {"bumpfoil/model/geometry.hpp"},
}

# Words that must not occur in the code of a module: contact knows no foils, structure knows no friction.
FOREIGN_WORDS = {
    "contact": re.compile(r"\w*bump\w*", re.IGNORECASE),
    "structure": re.compile(r"\w*(?:friction|contact)\w*", re.IGNORECASE),
}

# Printing, files and file formats belong to the modules that read and write, and to the programs.
MAY_USE_FILES = {"case", "results", "experiments", "ensemble", "sweep", "optimise", "readers", "pages", "studies"}
IO_HEADERS = re.compile(
    r"iostream|fstream|cstdio|filesystem|print|fmt/(?:os|ostream|color)\.h|nlohmann/.*|toml\+\+/.*|toml\.hpp|"
    r"netcdf.*|hdf5.*|CLI/.*"
)
# Everything that is printed goes through one place, which keeps texts of others from steering the terminal. The progress
# bar has no such texts; the message of a failed assertion is the last thing a broken program says.
MAY_PRINT = {"include/bumpfoil/core/assert.hpp", "apps/output.cpp", "apps/progress_bar.cpp"}
PRINTING = re.compile(r"\b(?:stdout|stderr|cout|cerr|clog|fmt::print|v?f?printf|perror|puts|putchar)\b")

# What the users of an installed library have: its public headers, the standard library and Eigen.
PUBLIC_INCLUDE = re.compile(r'"bumpfoil/[^"]+|<[a-z_]+|<Eigen/\w+')

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
OWN_NAME = re.compile(r"bumpfoil", re.IGNORECASE)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def blank(match):
    """The same number of lines, without the text: line numbers stay right."""
    return "\n" * match.group().count("\n")


def included_module(name, own_module):
    """Module that the quoted include `name` belongs to; None if the path does not say."""
    parts = name.removeprefix("bumpfoil/").split("/")
    if ".." in parts:
        return None
    if len(parts) == 1:
        return own_module
    return parts[0] if parts[0] in ALLOWED else None


def check_includes(path, module, text):
    for match in INCLUDE.finditer(text):
        quote, name = match.groups()
        where = f"{path}:{line_of(text, match.start())}"
        if quote == '"' or name.startswith("bumpfoil/"):
            target = included_module(name, module)
            if target is None:
                yield f'{where}: include "{name}" names no module; write "bumpfoil/<module>/<header>"'
            elif target != module and target not in ALLOWED[module] and path != DOORS.get(target):
                yield f'{where}: {module} must not include {target} ("{name}")'
        elif module not in MAY_USE_FILES and path not in MAY_PRINT and IO_HEADERS.fullmatch(name):
            yield f"{where}: <{name}> belongs to the modules of files, not to {module}"


def check_foreign_headers(root):
    """Follows includes to the headers that a module must not see."""
    headers = {}
    for base in ("include", "src"):
        for file in (root / base).rglob("*.hpp"):
            text = file.read_text(encoding="utf-8")
            headers[file.relative_to(root / base).as_posix()] = [match.group(2) for match in INCLUDE.finditer(text)]
    for module, foreign in FOREIGN_HEADERS.items():
        for base in ("include/bumpfoil", "src"):
            for file in sorted((root / base / module).rglob("*.[ch]pp")):
                path = file.relative_to(root).as_posix()
                text = file.read_text(encoding="utf-8")
                for match in INCLUDE.finditer(text):
                    seen, ahead = set(), [match.group(2)]
                    while ahead:
                        name = ahead.pop()
                        if name not in seen:
                            seen.add(name)
                            ahead += headers.get(name, ())
                    for name in sorted(seen & foreign):
                        through = "" if name == match.group(2) else f' through "{match.group(2)}"'
                        yield (
                            f'{path}:{line_of(text, match.start())}: {module} must not include "{name}"{through}; '
                            "what it needs of a case comes as values"
                        )


def check_private_headers(root):
    """What lies in src/ is included there, and by tests: all else uses the public headers."""
    private = {header.relative_to(root / "src").as_posix() for header in (root / "src").rglob("*.hpp")}
    for base in ("include", "apps", "python", "bench", "examples"):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            path = file.relative_to(root).as_posix()
            text = file.read_text(encoding="utf-8")
            for match in INCLUDE.finditer(text):
                if match.group(2) in private:
                    yield f'{path}:{line_of(text, match.start())}: "{match.group(2)}" is private to the library'


def check_doors(root):
    """Programs, too, come to the modules that have a door through that alone."""
    for base in ("apps", "python", "bench", "examples", "web"):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            path = file.relative_to(root).as_posix()
            text = file.read_text(encoding="utf-8")
            for match in INCLUDE.finditer(text):
                target = included_module(match.group(2), None)
                if target in DOORS:
                    yield f"{path}:{line_of(text, match.start())}: {target} is reached through {DOORS[target]} alone"


def check_words(path, module, text):
    if module not in FOREIGN_WORDS:
        return
    code = COMMENT_OR_STRING.sub(blank, INCLUDE.sub(blank, text))
    code = OWN_NAME.sub("", code)
    for match in FOREIGN_WORDS[module].finditer(code):
        yield f"{path}:{line_of(code, match.start())}: {module} must not know '{match.group()}'"


def check_printing(path, text):
    if path in MAY_PRINT:
        return
    code = COMMENT_OR_STRING.sub(blank, text)
    for match in PRINTING.finditer(code):
        yield f"{path}:{line_of(code, match.start())}: '{match.group()}'; apps/output.hpp is what prints"


def check_programs(root):
    for base in ("apps", "python"):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            yield from check_printing(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))


def check_sources(root):
    for base in ("include/bumpfoil", "src"):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            path = file.relative_to(root).as_posix()
            module = file.relative_to(root / base).parts[0]
            text = file.read_text(encoding="utf-8")
            if module not in ALLOWED:
                yield f"{path}: module '{module}' is not in the table of allowed includes"
                continue
            yield from check_includes(path, module, text)
            yield from check_words(path, module, text)
            yield from check_printing(path, text)
            if file.suffix == ".hpp" and "#pragma once" not in text:
                yield f"{path}: header without #pragma once"


def check_public_headers(root):
    """Every public header has a unit test of its name that includes it first, so that it is known to compile alone."""
    public = root / "include/bumpfoil"
    for header in sorted(public.rglob("*.hpp")):
        path = header.relative_to(root).as_posix()
        text = header.read_text(encoding="utf-8")
        for match in INCLUDE.finditer(text):
            if not PUBLIC_INCLUDE.fullmatch("".join(match.groups())):
                yield f"{path}:{line_of(text, match.start())}: users of the library have no {match.group(2)}"
        name = header.relative_to(root / "include").as_posix()
        test = f"tests/unit/{header.parent.relative_to(public)}/test_{header.stem}.cpp"
        if not (root / test).exists():
            yield f"{path}: no unit test {test}"
            continue
        first = INCLUDE.search((root / test).read_text(encoding="utf-8"))
        if not first or first.group(2) != name:
            yield f'{test}: must include "{name}" first, to show that it compiles alone'


def check_named_tests(root):
    """Filters pass over a name that no test has: what is left out, or runs in `make test-long`, is there."""
    sources = "".join(file.read_text(encoding="utf-8") for file in (root / "tests").rglob("*.cpp"))
    there = set(re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", sources, re.MULTILINE))
    for file in sorted((root / "tests").rglob("CMakeLists.txt")):
        text = file.read_text(encoding="utf-8")
        for match in re.finditer(r"\b([A-Z]\w+)\.([A-Z]\w+)\b", text):
            if match.groups() not in there:
                yield f"{file.relative_to(root).as_posix()}:{line_of(text, match.start())}: no test {match.group()}"


def find_errors(root):
    return [
        *check_sources(root),
        *check_foreign_headers(root),
        *check_private_headers(root),
        *check_doors(root),
        *check_programs(root),
        *check_public_headers(root),
        *check_named_tests(root),
    ]


if __name__ == "__main__":
    found = find_errors(Path(sys.argv[1]))
    print("\n".join(found) or "The modules keep apart.")
    sys.exit(1 if found else 0)
