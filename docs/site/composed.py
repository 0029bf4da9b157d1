"""What the site adds to pages: navigation, which is the sections of docs/index.md and the pages that each of them links to,
in that order; what the programs of the gallery draw and print; pictures of the cases; and links to the sources that are cited."""

import posixpath
import re
from pathlib import Path

from sources import with_links

# Pages that only the site has.
MADE = {
    "Begin here": [f"/docs/notebooks/{page}" for page in ("first_steps", "rotor_in_time", "fit_a_rig")],
    "Reference": [f"/docs/reference/{page}" for page in ("variables", "python", "cpp")],
}

# Pages about what a case shows.
CASES = {"docs/pads": "three_pads", "docs/profiles": "out_of_round", "docs/variable_foils": "graded"}


def contents(text):
    for title, section in re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", text, re.M | re.S):
        linked = re.findall(r"\]\(([^)#]+)\.md\)", section)
        pages = [posixpath.normpath(posixpath.join("/docs", page)) for page in linked] + MADE.get(title, [])
        yield "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title}", "", *pages, "```", ""])


def with_pictures(text, folder):
    def shown(section):
        if cases := re.findall(r"/([\w-]+)\.toml\)", section):
            return section + "\n" + "".join(f"`{case}.toml`:\n\n{picture_of(case)}" for case in cases)
        name = re.search(r"/(\w+)\.py\)", section)
        if not name:
            return section
        lines = (folder / f"{name[1]}.txt").read_text(encoding="utf-8")
        drawn = sorted(picture.name for picture in folder.glob(f"{name[1]}*.svg"))
        pictures = "".join(f"`{picture}`:\n\n![What {name[1]}.py draws](gallery/{picture})\n\n" for picture in drawn)
        return f"{section}```text\n{lines}```\n\n{pictures}"

    return "".join(map(shown, re.split(r"^(?=## )", text, flags=re.M)))


def picture_of(case):
    return f"![What {case}.toml comes to](gallery/case_{case}.svg)\n\n"


def after_introduction(text, block):
    """Before the first heading below the title."""
    title, *sections = re.split(r"^(?=## )", text, flags=re.M)
    return "".join([title, block, *sections])


def compose(app, name, source):
    if name == app.config.root_doc:
        source[0] += "".join(contents(source[0]))
    elif name == "docs/gallery":
        source[0] = with_pictures(source[0], Path(app.srcdir, "docs/gallery"))
    elif case := CASES.get(name):
        block = f"Results of `{case}.toml` ([gallery](gallery.md#cases)):\n\n{picture_of(case)}"
        source[0] = after_introduction(source[0], block)
    if name.startswith("docs/"):
        source[0] = with_links(source[0], posixpath.dirname(name))


def setup(app):
    app.connect("source-read", compose)
