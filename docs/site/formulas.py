"""Formulas set by KaTeX while pages are built: they need no network and no script, and one that is wrong is an error."""

import base64
import functools
import json
import re
import subprocess
from pathlib import Path

from docutils.nodes import SkipNode
from sphinx.util import logging

KATEX = Path("/usr/share/javascript/katex")  # where Debian has it
PROGRAM = """
const katex = require(process.argv[1]);
require("readline").createInterface({input: process.stdin}).on("line", (line) => {
  const {formula, display} = JSON.parse(line);
  let answer;
  try {
    answer = {html: katex.renderToString(formula, {displayMode: display, strict: "error"})};
  } catch (error) {
    answer = {html: "", error: error.message};
  }
  console.log(JSON.stringify(answer));
});
"""


@functools.cache
def renderer():
    command = ["node", "--eval", PROGRAM, str(KATEX / "katex.js")]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def rendered(node, display):
    print(json.dumps({"formula": node.astext(), "display": display}), file=renderer().stdin, flush=True)
    answer = json.loads(renderer().stdout.readline())
    if "error" in answer:
        logging.getLogger(__name__).warning("%s", answer["error"], location=node)
    return answer["html"]


def inline(writer, node):
    writer.body.append(rendered(node, False))
    raise SkipNode


def block(writer, node):
    writer.body.append(f'<div class="formula">{rendered(node, True)}</div>\n')
    raise SkipNode


def write_style(app):
    """KaTeX's style sheet with its fonts in it: browsers do not let pages from a disk read fonts beside them."""

    def embedded(match):
        data = base64.b64encode((KATEX / match.group(1)).read_bytes()).decode()
        return f"src:url(data:font/woff2;base64,{data}) format('woff2')"

    text = (KATEX / "katex.min.css").read_text(encoding="utf-8")
    text = re.sub(r"src:url\((fonts/[\w-]+\.woff2)\)[^;}]*", embedded, text)
    static = Path(app.outdir) / "_static"
    static.mkdir(parents=True, exist_ok=True)
    wide_ones_scroll = ".formula{overflow-x:auto;overflow-y:hidden}"
    (static / "katex.css").write_text(text + wide_ones_scroll, encoding="utf-8")


def setup(app):
    app.add_html_math_renderer("katex", (inline, None), (block, None))
    app.add_css_file("katex.css")
    app.connect("builder-inited", write_style)
