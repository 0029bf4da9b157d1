"""The site of the documentation is built without a warning, and stands alone: links lead to what it holds, and nothing is
fetched from elsewhere. The example programs that it runs draw their pictures, and those that are there in C++, too, print
the same lines.

Usage: test_site.py REPOSITORY PACKAGE OUTPUT FOLDER_OF_PROGRAMS
"""

import json
import os
import re
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(sys.argv[1]).resolve()
OUTPUT = Path(sys.argv[3]).resolve()
PROGRAMS = Path(sys.argv[4]).resolve()


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
            self.loaded += [given["src"]] * (given["src"] != "javascript:void(0)")  # an empty frame of Doxygen's


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        built = subprocess.run(
            [sys.executable, "-B", ROOT / "docs/site/build.py", sys.argv[2], OUTPUT], capture_output=True, text=True
        )
        if built.returncode != 0:
            raise AssertionError(built.stdout + built.stderr)
        cls.html = OUTPUT / "html"
        cls.pages = {path: Page(path) for path in cls.html.rglob("*.html")}

    def test_examples_draw_and_say_the_same_in_cpp(self):
        examples = ROOT / "examples"
        names = {example.stem for example in examples.glob("*.py")}
        twins = {example.stem for example in examples.glob("*.cpp")}
        self.assertLessEqual(twins, names)
        self.assertGreaterEqual(len(twins), 8)
        made = OUTPUT / "pages/docs/gallery"
        for name in sorted(names):
            with self.subTest(example=name):
                lines = (made / f"{name}.txt").read_text(encoding="utf-8")
                self.assertGreater(len(lines.splitlines()), 1)
                if name in twins:
                    program = [PROGRAMS / f"example_{name}"]
                    self.assertEqual(subprocess.run(program, stdout=subprocess.PIPE, text=True, cwd=examples).stdout, lines)
                if name != "quickstart":
                    pictures = list(made.glob(f"{name}*.svg"))
                    self.assertEqual(len(pictures), 7 if name == "paper_figure" else 1)
                    for picture in pictures:
                        self.assertIn("<svg", picture.read_text(encoding="utf-8"))

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

    def test_citations_lead_to_their_source(self):
        links = self.pages[self.html / "docs/theory/top_foil.html"].links
        self.assertIn("../references.html#arghir2019", links)

    def test_loads_nothing_from_elsewhere(self):
        self.assertGreater(len(self.pages), 40)
        for path, page in self.pages.items():
            for link in page.loaded:
                self.assertFalse(urlsplit(link).scheme not in ("", "data") or link.startswith("//"), f"{path}: {link}")
                if not link.startswith("data:"):
                    self.assertTrue((path.parent / unquote(urlsplit(link).path)).exists(), f"{path}: {link}")

    def test_styles_load_what_is_there(self):
        loaded = re.compile(r"""url\(\s*("[^"]*"|'[^']*'|[^)]*)|@import\s+("[^"]*"|'[^']*')""")
        for style in self.html.rglob("*.css"):
            for links in loaded.findall(style.read_text(encoding="utf-8")):
                link = "".join(links).strip("\"' ")
                if not link.startswith("data:"):
                    self.assertTrue(re.match(r"[\w.]", link), f"{style}: {link}")
                    self.assertTrue((style.parent / unquote(urlsplit(link).path)).is_file(), f"{style}: {link}")

    def test_is_dark_for_those_who_prefer_it(self):
        """Its pages as well as the code in them."""
        for style, colour in (("styles/furo.css", "--color-background-primary:"), ("pygments.css", ".highlight")):
            text = (self.html / "_static" / style).read_text(encoding="utf-8")
            rule = r'@media[^{]*\(prefers-color-scheme: dark\)\s*\{\s*body:not\(\[data-theme="light"\]\)[^}]*' + colour
            self.assertTrue(re.search(rule, text), style)

    @unittest.skipUnless("BUMPFOIL_WEB" in os.environ, "without the page of reports there is no axe-core")
    def test_axe_finds_nothing(self):
        """Of each kind of page one, in light and dark."""
        pages = ("docs/index", "docs/tutorial", "docs/theory/energies", "docs/notebooks/first_steps", "search")
        script = ROOT / "tests/documents/axe_of_site.mjs"
        command = [os.environ["BUMPFOIL_NODE"], script, self.html, *(f"{page}.html" for page in pages)]
        looked = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual((looked.stdout, looked.returncode), ("", 0))

    def test_scripts_are_no_modules(self):
        """Which pages opened from a disk may not load."""
        for script in self.html.rglob("*.js"):
            text = script.read_text(encoding="utf-8")
            self.assertFalse(re.findall(r"""^\s*(?:import|export)[\s{*"'].*|\bimport\(.*""", text, re.M), script)

    def test_search_knows_words_of_pages(self):
        index = (self.html / "searchindex.js").read_text(encoding="utf-8")
        self.assertTrue(index.startswith("Search.setIndex("))  # a script, which pages from a disk may load
        self.assertTrue('"hysteresi": [' in index)

    def test_search_leads_to_what_headers_declare(self):
        index = (self.html / "searchindex.js").read_text(encoding="utf-8")
        self.assertTrue('"cycleresult": ' in index)
        links = self.pages[self.html / "docs/reference/cpp.html"].links
        described = [link for link in links if "/cpp/" in link]
        self.assertGreater(len(described), 400)
        for target in ("structbumpfoil_1_1CycleResult.html", "classbumpfoil_1_1FoilStepper.html"):
            self.assertIn(f"../../cpp/{target}", described)

    def test_reference_of_headers_has_a_main_page(self):
        self.assertIn("structbumpfoil_1_1Case.html", self.pages[self.html / "cpp/index.html"].links)

    def test_lists_all_that_results_hold(self):
        page = (self.html / "docs/reference/variables.html").read_text(encoding="utf-8")
        listed = {re.sub("<.*?>", "", name) for name in re.findall(r"<td><p><code.*?>(.*?)</code></p></td>", page)}
        environment = dict(os.environ, PYTHONPATH=sys.argv[2])
        command = [sys.executable, "-B", ROOT / "tests/documents/results_of_all_kinds.py", ROOT / "examples"]
        made = subprocess.run(command, env=environment, capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        for command, names in json.loads(made.stdout):
            self.assertGreater(len(names), 20)
            self.assertEqual(set(names) - listed, set(), command)

    def test_lists_what_tables_and_summaries_hold(self):
        page = (self.html / "docs/reference/variables.html").read_text(encoding="utf-8")
        rows = [re.findall(r"<td>(.*?)</td>", row, re.S) for row in re.findall(r"<tr.*?</tr>", page, re.S)]
        rows = {tuple(re.sub("<.*?>", "", cell).strip() for cell in row) for row in rows}
        self.assertIn(("force_x_N", "N", "applied force on the journal, X"), rows)
        self.assertIn(("cycles[].max_force_N", "N", "force along the direction at full displacement"), rows)
        stuck = "dF_x/d(dy/dt) at the frequency, full stick"
        self.assertIn(("cxy_stuck_N_s_per_m", "N s/m", stuck), rows)

    def test_shows_what_notebooks_give(self):
        for notebook in (ROOT / "examples").glob("*.ipynb"):
            page = (self.html / f"docs/notebooks/{notebook.stem}.html").read_text(encoding="utf-8")
            self.assertIn(f"{notebook.stem}_", "".join(re.findall(r'<img[^>]* src="([^"]*\.png)"', page)))

    def test_shows_what_examples_draw(self):
        page = (self.html / "docs/gallery.html").read_text(encoding="utf-8")
        pictures = [picture.name for picture in (OUTPUT / "pages/docs/gallery").glob("*.svg")]
        self.assertGreaterEqual(len(pictures), 14)
        for picture in pictures:
            self.assertIn(f'/{picture}"', page)

    def test_shows_every_case(self):
        pages = {"pads": ["three_pads"], "variable_foils": ["graded"], "profiles": ["out_of_round"]}
        pages["gallery"] = [case.stem for case in (ROOT / "examples").glob("*.toml")]
        for page, cases in pages.items():
            loaded = {Path(link).name for link in self.pages[self.html / f"docs/{page}.html"].loaded}
            self.assertEqual({f"case_{case}.svg" for case in cases} - loaded, set(), page)

    def test_formulas_are_set(self):
        page = (self.html / "docs/theory/gas_film.html").read_text(encoding="utf-8")
        self.assertGreater(page.count('<span class="katex">'), 20)
        style = (self.html / "_static/katex.css").read_text(encoding="utf-8")
        self.assertGreater(style.count("data:font/woff2"), 10)
        self.assertFalse(re.search(r"url\((?!data:)", style))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
