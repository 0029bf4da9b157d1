"""The site of the documentation is built without a warning, and stands alone: links lead to what it holds, and nothing is
fetched from elsewhere.

Usage: test_site.py REPOSITORY PACKAGE OUTPUT
"""

import re
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(sys.argv[1]).resolve()
OUTPUT = Path(sys.argv[3]).resolve()


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loaded = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids |= {given[name] for name in ("id", "name") if given.get(name)}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        elif tag == "link" and given.get("rel") not in ("index", "search", "next", "prev"):
            self.loaded.append(given["href"])
        elif "src" in given:
            self.loaded.append(given["src"])


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        built = subprocess.run(
            [sys.executable, "-B", ROOT / "docs/site/build.py", sys.argv[2], OUTPUT], capture_output=True, text=True
        )
        if built.returncode != 0:
            raise AssertionError(built.stdout + built.stderr)
        cls.html = OUTPUT / "html"
        # Those of Sphinx: Doxygen's hundreds lead to each other alone.
        found = (path for path in cls.html.rglob("*.html") if cls.html / "cpp" not in path.parents)
        cls.pages = {path: Page(path) for path in found}

    def test_has_every_document(self):
        for document in (ROOT / "docs").rglob("*.md"):
            self.assertIn(self.html / document.relative_to(ROOT).with_suffix(".html"), self.pages)

    def test_links_lead_somewhere(self):
        for path, page in self.pages.items():
            for link in page.links:
                parts = urlsplit(link)
                if parts.scheme or (not parts.path and not parts.fragment):
                    continue
                target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
                self.assertTrue(target.exists(), f"{path}: {link}")
                if parts.fragment and target in self.pages:
                    self.assertIn(unquote(parts.fragment), self.pages[target].ids | {""}, f"{path}: {link}")

    def test_loads_nothing_from_elsewhere(self):
        self.assertGreater(len(self.pages), 40)
        for path, page in self.pages.items():
            for link in page.loaded:
                self.assertFalse(urlsplit(link).scheme not in ("", "data") or link.startswith("//"), f"{path}: {link}")
                if not link.startswith("data:"):
                    self.assertTrue((path.parent / unquote(urlsplit(link).path)).exists(), f"{path}: {link}")

    def test_search_knows_words_of_pages(self):
        index = (self.html / "searchindex.js").read_text(encoding="utf-8")
        self.assertTrue(index.startswith("Search.setIndex("))  # a script, which pages from a disk may load
        self.assertTrue('"hysteresi": [' in index)

    def test_lists_variables_of_every_command(self):
        page = (self.html / "docs/reference/variables.html").read_text(encoding="utf-8")
        for name in ("loss_factor", "pad_force_x", "orbit_energy", "kxy_whirl_stuck", "bump_height_deviation", "load_x_N"):
            self.assertTrue(f">{name}<" in page, name)

    def test_shows_what_notebooks_give(self):
        for notebook in (ROOT / "examples").glob("*.ipynb"):
            page = (self.html / f"docs/notebooks/{notebook.stem}.html").read_text(encoding="utf-8")
            self.assertIn(f"{notebook.stem}_", "".join(re.findall(r'<img[^>]* src="([^"]*\.png)"', page)))

    def test_formulas_are_set(self):
        page = (self.html / "docs/theory/gas_film.html").read_text(encoding="utf-8")
        self.assertGreater(page.count('<span class="katex">'), 20)
        style = (self.html / "_static/katex.css").read_text(encoding="utf-8")
        self.assertGreater(style.count("data:font/woff2"), 10)
        self.assertFalse(re.search(r"url\((?!data:)", style))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
