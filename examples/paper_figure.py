"""The figures of the source paper, recomputed and drawn as a journal prints them."""

import subprocess
import sys

from bumpfoil import figures

subprocess.run([sys.executable, "-m", "bumpfoil", "reproduce", "-o", "paper", "--quiet"], check=True)
for number in range(10, 17):
    figure = figures.paper(f"paper/figure{number}")
    print(f"figure {number}: {len(figure.axes)} panels")
    figures.save(figure, f"paper_figure{number}")
