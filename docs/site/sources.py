"""The sources that pages cite: a page made of docs/references.bib, and links to it where a page cites."""

import posixpath
import re
import unicodedata

ACCENTS = {"'": "\u0301", "`": "\u0300", "^": "\u0302", '"': "\u0308", "~": "\u0303"}
CITED = re.compile(r"\[([A-Z][A-Za-z]+(?:19|20)\d\d)\b([^\]]*)\](?!\()")


def plain(text):
    """Without TeX."""
    letters = re.sub(r"\{\\(.)\{?(\w)\}?\}", lambda found: found[2] + ACCENTS[found[1]], text)
    return unicodedata.normalize("NFC", re.sub(r"[{}]", "", letters.replace("--", "–").replace("\\&", "&")))


def described(fields):
    place = f"{fields['journal']} {fields.get('volume', '')}" if "journal" in fields else ""
    parts = [fields.get("author"), f"*{fields['title']}*", place, fields.get("publisher")]
    pages = [f"pages {fields['pages']}"] if "pages" in fields else []
    doi = [f"[doi:{fields['doi']}](https://doi.org/{fields['doi']})"] if "doi" in fields else []
    return ". ".join(part.strip(" .") for part in [*parts, *pages, fields["year"], *doi] if part) + "."


def page_of(bibliography):
    lines = ["# Sources", "", "What pages and comments in the code cite by these keys.", ""]
    for key, body in sorted(re.findall(r"^@\w+\{(\w+),\n(.*?)^\}", bibliography, re.M | re.S)):
        fields = {name: plain(value) for name, value in re.findall(r"^ *(\w+) *= *\{(.*)\},?$", body, re.M)}
        lines += [f"## {key}", "", described(fields), ""]
    return "\n".join(lines)


def with_links(text, folder):
    """Of a page in a folder of the site."""
    page = posixpath.relpath("docs/reference/sources.md", folder)
    return CITED.sub(lambda found: f"[\\[{found[1]}{found[2]}\\]]({page}#{found[1].lower()})", text)
