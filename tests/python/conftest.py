"""What the tests of the Python package share."""

import os
import subprocess
from pathlib import Path

import pytest

import bumpfoil

EXAMPLES = Path(__file__).parents[2] / "examples"
# A mesh of the film for tests of what is done with numbers, not of the numbers.
COARSE = {"columns_per_pitch": 4, "rows": 6}
PROGRAM = Path(bumpfoil.__file__).with_name("program")


@pytest.fixture
def program(tmp_path):
    """Runs the program and gives the folder of its results."""

    def run(*words):
        folder = tmp_path / "by_program"
        subprocess.run([PROGRAM, *map(str, words), "-o", folder, "--quiet"], check=True)
        return folder

    return run


@pytest.fixture(scope="session")
def studies():
    """What `bumpfoil reproduce --all` wrote."""
    return Path(os.environ["BUMPFOIL_STUDIES"])
