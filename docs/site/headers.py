"""The page of the C++ reference: what each header declares, with links to what Doxygen says of it, by Doxygen's tag file."""

from itertools import groupby
from pathlib import Path
from xml.etree import ElementTree

INTRODUCTION = """\
C++ reference
=============

Types and functions of the library by module and header. Each leads to what its header says, with equations, sources, units
and shapes, as Doxygen shows it; `those pages <../../cpp/index.html>`__ have a search field of their own. How to build against the
library: :doc:`/docs/howto/cpp_and_python`.
"""
KINDS = ("typedef", "enumeration", "function")


def link(name, target):
    return f"`{name} <../../cpp/{target}>`__"


def declared(header, pages):
    """Names of types and functions of a header with where they are described; overloads once."""
    names = {}
    for kind in header.findall("class"):
        name = kind.text.removeprefix("bumpfoil::")
        if name.isidentifier():  # neither inside another, nor specialised
            names[name] = pages[kind.text]
    for member in header.findall("member"):
        name = member.findtext("name")
        if member.get("kind") in KINDS and name.isidentifier():
            names.setdefault(name, f"{member.findtext('anchorfile')}#{member.findtext('anchor')}")
    return names


def page_of(tags):
    compounds = ElementTree.parse(tags).findall("compound")
    pages = {compound.findtext("name"): compound.findtext("filename") for compound in compounds}
    headers = [compound for compound in compounds if compound.findtext("name").endswith(".hpp")]

    def module(header):
        return Path(header.findtext("path")).name

    lines = [INTRODUCTION]
    for name, group in groupby(sorted(headers, key=module), module):
        lines += [name, "-" * len(name), ""]
        for header in group:
            links = ", ".join(link(*item) for item in sorted(declared(header, pages).items()))
            lines.append(f"* {link(header.findtext('name'), header.findtext('filename'))}: {links}")
        lines.append("")
    return "\n".join(lines)
