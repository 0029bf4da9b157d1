"""``python -m bumpfoil``: the program."""

import os
import sys
from pathlib import Path

program = Path(__file__).with_name("program")
os.execv(program, ["bumpfoil", *sys.argv[1:]])
