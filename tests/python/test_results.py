"""Results are written, read and shown as those of the program."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pandas
import pytest
import xarray

import bumpfoil
from conftest import EXAMPLES, PROGRAM

GEN1 = EXAMPLES / "gen1.toml"


@pytest.fixture(scope="module")
def result():
    return bumpfoil.run_cycle(GEN1, cycle={"steps": 10})


def test_saved_is_loaded(result, tmp_path):
    result.save(tmp_path / "results")
    loaded = bumpfoil.Result.load(tmp_path / "results")
    assert loaded.files == result.files
    assert loaded.case == result.case
    assert (loaded.command, loaded.status, repr(loaded)) == (result.command, result.status, repr(result))
    for cycle, read in zip(result.cycles, loaded.cycles):
        np.testing.assert_array_equal(cycle.force_direct, read.force_direct)
        np.testing.assert_array_equal(cycle.state_bump_sleeve, read.state_bump_sleeve)
        assert cycle.status == read.status == "converged"
        assert cycle.converged is read.converged is True
        assert not read.force_direct.flags.writeable
    assert loaded._repr_html_() == result._repr_html_()


def test_results_are_not_overwritten(result, tmp_path):
    result.save(tmp_path)
    with pytest.raises(bumpfoil.FileError, match="--force|force"):
        result.save(tmp_path)
    result.save(tmp_path, force=True)


def test_damage_is_told(result, tmp_path):
    with pytest.raises(bumpfoil.FileError, match="summary.json"):
        bumpfoil.load(tmp_path)
    result.save(tmp_path)
    (tmp_path / "result.nc").write_bytes(result.files["result.nc"][:-1] + b"?")
    with pytest.raises(bumpfoil.FileError, match="result.nc: is damaged"):
        bumpfoil.load(tmp_path)
    (tmp_path / "summary.json").write_bytes(result.files["summary.json"].replace(b"0.1", b"0.2"))
    with pytest.raises(bumpfoil.FileError, match="summary.json: is damaged"):
        bumpfoil.load(tmp_path)
    (tmp_path / "summary.json").write_text("{}")
    with pytest.raises(bumpfoil.FileError, match="no summary"):
        bumpfoil.load(tmp_path)


def test_data_set_and_table_are_those_of_the_files(result, tmp_path):
    result.save(tmp_path)
    with xarray.open_dataset(tmp_path / "result.nc") as read:
        assert result.to_xarray().identical(read.load())
    table = result.to_dataframe()
    assert table.equals(pandas.read_csv(tmp_path / "cycle.csv", float_precision="round_trip"))
    np.testing.assert_array_equal(
        table.force_direct_N, np.concatenate([cycle.force_direct for cycle in result.cycles])
    )


def test_report_is_that_of_the_program(result, tmp_path):
    result.report(tmp_path / "python.html")
    result.save(tmp_path / "cycle")
    subprocess.run([PROGRAM, "report", tmp_path / "cycle", "-o", tmp_path / "program.html", "--quiet"], check=True)
    assert (tmp_path / "python.html").read_bytes() == (tmp_path / "program.html").read_bytes()
    with pytest.raises(bumpfoil.FileError):
        result.report(tmp_path / "python.html")


def test_several_results_in_one_report(result, tmp_path):
    other = bumpfoil.run_cycle(GEN1, cycle={"steps": 10}, friction={"coefficient": 0})
    bumpfoil.write_report({"rough": result, "smooth": other}, tmp_path / "both.html")
    page = (tmp_path / "both.html").read_text()
    assert '"rough"' in page and '"smooth"' in page


def test_files_of_several_threads(tmp_path):
    """They are made and read one at a time, as netCDF is not thread-safe."""

    def round_trip(number):
        result = bumpfoil.run_cycle(GEN1, cycle={"steps": 5}, friction={"coefficient": number / 100})
        result.save(tmp_path / str(number))
        assert bumpfoil.load(tmp_path / str(number)).to_xarray().identical(result.to_xarray())

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(round_trip, range(8)))


def test_shown_in_a_notebook(result):
    page = result._repr_html_()
    assert "<td>maximum force (N)</td><td>73" in page
    assert "<td>-X</td>" in page


def test_package_runs_the_program():
    words = [sys.executable, "-m", "bumpfoil", "--version"]
    shown = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    assert shown == f"bumpfoil {bumpfoil.__version__} ({bumpfoil._native.commit})\n"
