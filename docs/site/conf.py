"""Sphinx's settings of the documentation, which build.py lays out and builds."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

project = "Bumpfoil"
author = "The Bumpfoil authors"
project_copyright = author
release = re.search(r"VERSION (\d+\.\d+\.\d+)", (HERE.parents[1] / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "formulas", "composed"]
root_doc = "docs/index"
exclude_patterns = ["examples", "include", "tests"]  # there for the links to their files
nitpicky = True

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]

html_math_renderer = "katex"
html_theme = "furo"
html_static_path = ["static"]
html_js_files = ["scrollable.js"]
pygments_style = "code_style.CodeStyle"
html_title = f"Bumpfoil {release}"
html_show_sourcelink = False
html_copy_source = False
html_show_search_summary = False  # they are requests, which pages opened from a disk may not make

autodoc_typehints = "none"  # docstrings have them, with units and shapes
napoleon_preprocess_types = False
nitpick_ignore_regex = [("py:.*", r"(?!bumpfoil).*|bumpfoil\._native.*")]  # types of others
