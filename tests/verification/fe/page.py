"""Pages whose tables are written by the checks, between <!-- table:NAME --> and <!-- /table -->, and their plots."""

import re

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"font.size": 11, "svg.hashsalt": "bumpfoil", "axes.grid": True, "grid.color": "#dddddd",
                            "axes.spines.top": False, "axes.spines.right": False, "svg.fonttype": "none",
                            "font.family": "DejaVu Sans"})
# Told apart without colours, too.
STYLES = [("#0b57a4", "-"), ("#a8330b", "--"), ("#1a7f37", "-."), ("#7a3fa0", ":")]


def save(figure, file):
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None, "Creator": None})


def percent(value, reference):
    """Deviation from the reference as it stands in the tables."""
    return f"{100 * (value / reference - 1):+.1f}".replace("-", "−")


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def fill(file, tables):
    """Writes tables into a page; each must have its place there."""
    text = file.read_text(encoding="utf-8")
    for name, content in tables.items():
        pattern = re.compile(rf"(<!-- table:{name} -->\n).*?(<!-- /table -->)", re.DOTALL)
        if not pattern.search(text):
            raise SystemExit(f"{file}: no place for the table {name}")
        text = pattern.sub(lambda match: match.group(1) + content + "\n" + match.group(2), text)
    file.write_text(text, encoding="utf-8")
