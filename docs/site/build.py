"""Builds the documentation: lays its pages out, runs the examples and notebooks, and has Sphinx and, for the headers,
Doxygen make the site, whose warnings are errors.

Usage: build.py PACKAGE OUTPUT    PACKAGE is the folder of the built Python package
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def lay_out(pages):
    """The documents as they lie in the repository, so that their links lead where they do there."""
    shutil.copytree(ROOT / "docs", pages / "docs", ignore=shutil.ignore_patterns("site"))
    others = ("CHANGELOG.md", "CONTRIBUTING.md", ".pre-commit-config.yaml", "packages.txt", "examples", "include", "tests")
    for name in others:
        (pages / name).symlink_to(ROOT / name)


def describe(pages):
    """Pages that only the site has: what Sphinx reads from the Python package, and the way to what Doxygen makes."""
    folder = pages / "docs/reference"
    folder.mkdir()
    python = ["Python reference", "================", "", ".. automodule:: bumpfoil", "   :members:", "   :imported-members:"]
    python += ["", ".. automodule:: bumpfoil.figures", "   :members:", "   :imported-members:"]
    (folder / "python.rst").write_text("\n".join(python), encoding="utf-8")
    shutil.copy(HERE / "cpp.rst", folder)


def list_variables(page, environment):
    with open(page, "w", encoding="utf-8") as lines:
        subprocess.run([sys.executable, "-B", HERE / "variables.py"], stdout=lines, env=environment, check=True)


def run_examples(folder, environment):
    """Their pictures and what they print."""
    folder.mkdir()
    to_files = environment | {"MPLBACKEND": "agg"}
    for example in sorted((ROOT / "examples").glob("*.py")):
        with open(folder / f"{example.stem}.txt", "w", encoding="utf-8") as lines:
            subprocess.run([sys.executable, "-B", example], stdout=lines, cwd=folder, env=to_files, check=True)


def run_notebooks(folder, environment):
    """As pages, with what their cells give."""
    notebooks = sorted((ROOT / "examples").glob("*.ipynb"))
    convert = ["jupyter-nbconvert", "--to", "markdown", "--execute", "--log-level=ERROR", "--output-dir", folder]
    quiet = {"PYDEVD_DISABLE_FILE_VALIDATION": "1"}  # about its debugger, which nobody asked for
    subprocess.run([*convert, *notebooks], env=environment | quiet, check=True)


def main():
    package, output = (Path(argument).resolve() for argument in sys.argv[1:])
    environment = dict(os.environ, PYTHONPATH=str(package))
    for made in ("pages", "doctrees", "html"):
        shutil.rmtree(output / made, ignore_errors=True)
    pages = output / "pages"
    lay_out(pages)
    describe(pages)
    list_variables(pages / "docs/reference/variables.md", environment)
    run_examples(pages / "docs/gallery", environment)
    run_notebooks(pages / "docs/notebooks", environment)
    sphinx = ["sphinx-build", "-W", "--keep-going", "-q", "-c", HERE, "-d", output / "doctrees", pages, output / "html"]
    subprocess.run(sphinx, env=environment, check=True)
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8") + f"HTML_OUTPUT = {output}/html/cpp\n"
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as failure:
        sys.exit(failure.returncode)
