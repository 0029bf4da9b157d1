"""What the site adds to pages: navigation, which is the sections of docs/index.md and the pages that each of them links to,
in that order; and what the programs of the gallery draw and print."""

import posixpath
import re
from pathlib import Path

# Pages that only the site has.
MADE = {
    "Begin here": [f"/docs/notebooks/{page}" for page in ("first_steps", "rotor_in_time")],
    "Reference": [f"/docs/reference/{page}" for page in ("variables", "python", "cpp")],
}


def contents(text):
    for title, section in re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", text, re.M | re.S):
        linked = re.findall(r"\]\(([^)#]+)\.md\)", section)
        pages = [posixpath.normpath(posixpath.join("/docs", page)) for page in linked] + MADE.get(title, [])
        yield "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title}", "", *pages, "```", ""])


def with_pictures(text, folder):
    def shown(section):
        name = re.search(r"/(\w+)\.py\)", section)
        if not name:
            return section
        lines = (folder / f"{name[1]}.txt").read_text(encoding="utf-8")
        return f"{section}```text\n{lines}```\n\n![What {name[1]}.py draws](gallery/{name[1]}.svg)\n\n"

    return "".join(map(shown, re.split(r"^(?=## )", text, flags=re.M)))


def compose(app, name, source):
    if name == app.config.root_doc:
        source[0] += "".join(contents(source[0]))
    elif name == "docs/gallery":
        source[0] = with_pictures(source[0], Path(app.srcdir, "docs/gallery"))


def setup(app):
    app.connect("source-read", compose)
