"""Types are right: mypy finds nothing in the package, and what they say of its compiled part is what that has."""

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import bumpfoil
from bumpfoil import _native, figures

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


def public_signatures():
    """Functions and methods that people call, and the classes that they make themselves."""
    for module in (bumpfoil, figures):
        for name in module.__all__:
            held = getattr(module, name)
            if not inspect.isclass(held):
                yield name, held
                continue
            if held in (bumpfoil.Case, bumpfoil.Stepper):
                yield name, held
            yield from ((f"{name}.{method}", getattr(held, method)) for method in vars(held)
                        if not method.startswith("_") and callable(getattr(held, method)))  # fmt: skip


@pytest.mark.parametrize(("name", "held"), public_signatures())
def test_every_parameter_is_told(name, held):
    told = inspect.getdoc(held)
    section = re.search(r"^Parameters\n-+\n(.*?)(?=^\w[\w ]*\n-+\n|\Z)", told, re.DOTALL | re.MULTILINE)
    heads = re.findall(r"^(\S.*?) :", section.group(1), re.MULTILINE) if section else []
    named = [name.strip("* ") for head in heads for name in head.split(",")]
    due = [name for name in inspect.signature(held).parameters if name != "self"]
    assert sorted(named) == sorted(due)
