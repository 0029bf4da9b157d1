"""Figure 10 of the source paper: computed anew by the program, and drawn as a journal prints it."""

import subprocess
import sys

from bumpfoil import figures

subprocess.run([sys.executable, "-m", "bumpfoil", "reproduce", "-o", "paper", "--figure", "10"], check=True)
figure = figures.paper("paper/figure10")
print(len(figure.axes), "panels")
figures.save(figure, "paper_figure")
