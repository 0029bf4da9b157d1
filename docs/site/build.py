"""Builds the documentation: lays its pages out, runs the examples and notebooks, and has Sphinx and, for the headers,
Doxygen make the site, whose warnings are errors.

Usage: build.py PACKAGE OUTPUT    PACKAGE is the folder of the built Python package
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from headers import page_of

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def lay_out(pages):
    """The documents as they lie in the repository, so that their links lead where they do there."""
    shutil.copytree(ROOT / "docs", pages / "docs", ignore=shutil.ignore_patterns("site"))
    others = ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", ".pre-commit-config.yaml", "packages.txt")
    for name in (*others, "examples", "include", "tests"):
        (pages / name).symlink_to(ROOT / name)


def describe(pages):
    """The page that Sphinx makes of the Python package."""
    folder = pages / "docs/reference"
    folder.mkdir()
    python = ["Python reference", "================", "", ".. automodule:: bumpfoil", "   :members:", "   :imported-members:"]
    python += ["", ".. automodule:: bumpfoil.figures", "   :members:", "   :imported-members:"]
    (folder / "python.rst").write_text("\n".join(python), encoding="utf-8")


def run_doxygen(html, tags):
    html.mkdir(parents=True)
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8") + f"HTML_OUTPUT = {html}\nGENERATE_TAGFILE = {tags}\n"
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)


def list_variables(page, environment):
    with open(page, "w", encoding="utf-8") as lines:
        subprocess.run([sys.executable, "-B", HERE / "variables.py"], stdout=lines, env=environment, check=True)


def run_examples(folder, environment):
    """Their pictures and what programs print."""
    folder.mkdir()
    to_files = environment | {"MPLBACKEND": "agg"}
    for example in sorted((ROOT / "examples").glob("*.py")):
        with open(folder / f"{example.stem}.txt", "w", encoding="utf-8") as lines:
            command = [sys.executable, "-B", example]
            done = subprocess.run(command, stdout=lines, stderr=subprocess.PIPE, text=True, cwd=folder, env=to_files)
        if done.returncode != 0 or "Warning" in done.stderr:
            sys.exit(f"{example}: {done.stderr}")
    subprocess.run([sys.executable, "-B", HERE / "draw_cases.py"], cwd=folder, env=to_files, check=True)


def run_notebooks(folder, environment):
    """As pages, with what their cells give."""
    notebooks = sorted((ROOT / "examples").glob("*.ipynb"))
    convert = ["jupyter-nbconvert", "--to", "markdown", "--execute", "--log-level=ERROR", "--output-dir", folder]
    quiet = {"PYDEVD_DISABLE_FILE_VALIDATION": "1"}  # about its debugger, which is not used
    subprocess.run([*convert, *notebooks], env=environment | quiet, check=True)


def complete_theme(static):
    """Makes up for what Debian's build of the theme lacks: its style and script lead to a file of the system and to a module,
    neither of which pages opened from a disk can load, and it lost its dark colours for those whose browsers prefer them."""

    def put_in(path, pattern, folder):
        text = path.read_text(encoding="utf-8")
        path.write_text(re.sub(pattern, lambda found: (folder / found[1]).read_text(encoding="utf-8"), text), encoding="utf-8")

    put_in(static / "styles/furo.css", r"@import url\(/javascript/([^)]*)\);", Path("/usr/share/javascript"))
    text = (static / "styles/furo.css").read_text(encoding="utf-8")
    if "prefers-color-scheme" not in text:
        colours = re.search(r'body\[data-theme="dark"\] (\{[^}]*\})', text)[1]
        preferred = f'@media screen and (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {colours} }}\n'
        (static / "styles/furo.css").write_text(text + preferred, encoding="utf-8")
    put_in(static / "scripts/furo.js", r"""^import Gumshoe from ["']\./([^"']*)["'];""", static / "scripts")


def complete_pages(html):
    """For those who cannot see the pages: names of landmarks and levels of headings that the theme leaves out, no heading
    over an empty column, and nothing read out that only the pointer can use."""
    changes = {
        r'<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">',
        r'<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="All pages">',
        r'<aside class="toc-drawer': '<aside aria-label="On this page" class="toc-drawer',
        r'<label class="overlay ': '<label aria-hidden="true" class="overlay ',
        r"<th[^>]*>(?:\s|<p></p>)*</th>": "<td></td>",
        r'<div id="search-results">': '<h1>Search</h1>\n\\g<0>',
    }
    for page in html.rglob("*.html"):
        if html / "cpp" not in page.parents:
            text = page.read_text(encoding="utf-8")
            for pattern, replacement in changes.items():
                text = re.sub(pattern, replacement, text)
            page.write_text(text, encoding="utf-8")


def main():
    package, output = (Path(argument).resolve() for argument in sys.argv[1:])
    environment = dict(os.environ, PYTHONPATH=str(package))
    for made in ("pages", "doctrees", "html"):
        shutil.rmtree(output / made, ignore_errors=True)
    pages = output / "pages"
    lay_out(pages)
    describe(pages)
    run_doxygen(output / "html/cpp", output / "cpp.tags")
    (pages / "docs/reference/cpp.rst").write_text(page_of(output / "cpp.tags"), encoding="utf-8")
    list_variables(pages / "docs/reference/variables.md", environment)
    run_examples(pages / "docs/gallery", environment)
    run_notebooks(pages / "docs/notebooks", environment)
    sphinx = ["sphinx-build", "-W", "--keep-going", "-q", "-c", HERE, "-d", output / "doctrees", pages, output / "html"]
    subprocess.run(sphinx, env=environment, check=True)
    complete_theme(output / "html/_static")
    complete_pages(output / "html")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as failure:
        sys.exit(failure.returncode)
