"""What a wheel holds is whole: it is imported from where it was moved, and runs the program."""

import os
import subprocess
import sys
from pathlib import Path

import bumpfoil


def test_installed_package_is_whole(tmp_path):
    build = Path(bumpfoil.__file__).parents[2]
    words = ["cmake", "--install", build, "--component", "python", "--prefix", tmp_path / "first"]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    moved = (tmp_path / "first").rename(tmp_path / "moved")
    assert [path.name for path in moved.iterdir()] == ["bumpfoil"]
    code = "import bumpfoil; print(bumpfoil.__file__); bumpfoil.run_cycle(bumpfoil.template()).report('report.html')"
    environment = {**os.environ, "PYTHONPATH": str(moved), "PYTHONDONTWRITEBYTECODE": "1"}
    run = lambda *words: subprocess.run(  # noqa: E731
        [sys.executable, *words], check=True, capture_output=True, text=True, cwd=tmp_path, env=environment
    )
    assert run("-c", code).stdout.startswith(str(moved))
    assert (tmp_path / "report.html").stat().st_size > 100_000
    assert "bumpfoil" in run("-m", "bumpfoil", "--version").stdout
