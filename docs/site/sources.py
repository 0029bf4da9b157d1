"""The sources that pages cite: docs/references.md, made of docs/references.bib, and links to it where a page cites.

Usage: sources.py    writes docs/references.md
"""

import posixpath
import re
import textwrap
import unicodedata
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
ACCENTS = {"'": "\u0301", "`": "\u0300", "^": "\u0302", '"': "\u0308", "~": "\u0303"}
CITED = re.compile(r"\[([A-Z][A-Za-z]+(?:19|20)\d\d)\b([^\]]*)\](?!\()")


def plain(text):
    """Without TeX."""
    letters = re.sub(r"\{\\(.)\{?(\w)\}?\}", lambda found: found[2] + ACCENTS[found[1]], text)
    return unicodedata.normalize("NFC", re.sub(r"[{}]", "", letters.replace("--", "–").replace("\\&", "&")))


def described(fields):
    pages = f", pages {fields['pages']}" if "pages" in fields else ""
    place = f"{fields['journal']} {fields['volume']}{pages}" if "journal" in fields else ""
    issued = [fields.get(name) for name in ("publisher", "institution", "number") if name != "number" or not place]
    parts = [fields["author"].replace(" and ", "; "), f"*{fields['title']}*", place, *issued]
    doi = [f"[doi:{fields['doi']}](https://doi.org/{fields['doi']})"] if "doi" in fields else []
    return ". ".join(part.strip(" .") for part in [*parts, fields["year"], *doi] if part) + "."


def page_of(bibliography):
    lines = ["# References", "", "Pages and comments in the code cite these by their keys.", ""]
    for key, body in sorted(re.findall(r"^@\w+\{(\w+),\n(.*?)^\}", bibliography, re.M | re.S)):
        fields = {name: plain(value) for name, value in re.findall(r"^ *(\w+) *= *\{(.*)\},?$", body, re.M)}
        text = textwrap.fill(described(fields), 120, break_long_words=False, break_on_hyphens=False)
        lines += [f"## {key}", "", text, ""]
    return "\n".join(lines[:-1]) + "\n"


def with_links(text, folder):
    """Of a page in a folder of the site."""
    page = posixpath.relpath("docs/references.md", folder)
    return CITED.sub(lambda found: f"[\\[{found[1]}{found[2]}\\]]({page}#{found[1].lower()})", text)


if __name__ == "__main__":
    made = page_of((DOCS / "references.bib").read_text(encoding="utf-8"))
    (DOCS / "references.md").write_text(made, encoding="utf-8")
