"""Types are right: mypy finds nothing in the package, and what they say of its compiled part is what that has."""

import ast
import subprocess
import sys
from pathlib import Path

import bumpfoil
from bumpfoil import _native

ROOT = Path(__file__).parents[2]


def test_mypy_finds_nothing(tmp_path):
    words = [sys.executable, "-m", "mypy", "--config-file", "pyproject.toml", "--cache-dir", tmp_path]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_are_of_what_is_there():
    stubs = ast.parse(Path(bumpfoil.__file__).with_name("_native.pyi").read_text())
    for body, found in [(stubs, _native), *((node, getattr(_native, node.name)) for node in stubs.body if isinstance(node, ast.ClassDef))]:
        told = {
            getattr(node, "name", None) or node.target.id
            for node in body.body
            if isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign))
        }
        assert {name for name in told if not name.startswith("_")} == {name for name in dir(found) if not name.startswith("_")}
