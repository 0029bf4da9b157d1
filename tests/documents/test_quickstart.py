"""The first program in Python prints what the one in C++ prints.

Usage: test_quickstart.py REPOSITORY PROGRAM
"""

import subprocess
import sys
from pathlib import Path

example = Path(sys.argv[1]) / "examples/quickstart.py"
by_python = subprocess.run([sys.executable, example], check=True, capture_output=True, text=True).stdout
by_cpp = subprocess.run([sys.argv[2]], check=True, capture_output=True, text=True).stdout
print(by_python, by_cpp, sep="")
sys.exit(by_python != by_cpp or by_cpp.count("\n") != 4)
