"""Navigation: the sections of docs/index.md and the pages that each of them links to, in that order."""

import posixpath
import re

MADE = {"Reference": ["/docs/reference/python", "/docs/reference/cpp"]}  # pages that only the site has


def add_contents(app, name, source):
    if name != app.config.root_doc:
        return
    for title, section in re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", source[0], re.M | re.S):
        linked = re.findall(r"\]\(([^)#]+)\.md\)", section)
        pages = [posixpath.normpath(posixpath.join("/docs", page)) for page in linked] + MADE.get(title, [])
        source[0] += "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title}", "", *pages, "```", ""])


def setup(app):
    app.connect("source-read", add_contents)
