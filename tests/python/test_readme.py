"""What the README shows of the package works."""

import re
from pathlib import Path

import bumpfoil
from conftest import EXAMPLES

README = Path(__file__).parents[2] / "README.md"


def test_block_runs(tmp_path, monkeypatch, capsys):
    section = README.read_text(encoding="utf-8").split("## In Python\n")[1]
    code = re.search(r"```python\n(.*?)```", section, re.DOTALL).group(1)
    (tmp_path / "case.toml").write_text((EXAMPLES / "gen1.toml").read_text())
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out.startswith("0.0 ")
    assert bumpfoil.load("rough").command == "cycle"
