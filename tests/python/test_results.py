"""Results are written, read and shown as those of the program."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import netCDF4
import numpy as np
import pandas
import pytest
import xarray

import bumpfoil
from bumpfoil import figures
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
    with pytest.raises(bumpfoil.FileError, match="not a summary"):
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


QUICK_CHOICE = {
    "optimise": {"command": "cycle", "maximise": "loss_factor", "minimise": "max_force", "limits": ["max_force > 600 N"],
                 "evaluations": 40, "tolerance": 0.05, "starts": 1, "front": 1},
    "cycle": {"steps": 5, "directions": ["+X"]},
}

SHORT = {
    "vibration": lambda: bumpfoil.run_vibration(EXAMPLES / "vibration.toml", vibration={"steps": 4, "amplitudes": ["1 um", "2 um"]}),
    "equilibrium": lambda: bumpfoil.run_equilibrium(EXAMPLES / "running.toml", film={"rows": 4}, equilibrium={"loads": [["10 N", "0 N"]]}),
    "stability": lambda: bumpfoil.run_stability(EXAMPLES / "rotor.toml", film={"rows": 4}, stability={"speeds": ["12000 rpm", "14000 rpm"]}),
    "unbalance": lambda: bumpfoil.run_unbalance(EXAMPLES / "rotor.toml", film={"rows": 4}, unbalance={"speeds": ["12000 rpm", "14000 rpm"]}),
    "transient": lambda: bumpfoil.run_transient(EXAMPLES / "rotor.toml", film={"rows": 4}, transient={"speed": {"to": "12000 rpm", "time": "11 ms"}, "steps_per_revolution": 20, "revolutions_per_spectrum": 1}),
    "fit": lambda: bumpfoil.fit(EXAMPLES / "fit.toml", fit={"starts": 1}),
    "optimise": lambda: bumpfoil.optimise(GEN1, keys={"friction.coefficient": {"lower": 0.05, "upper": 0.3}}, **QUICK_CHOICE),
    "sweep": lambda: bumpfoil.run_sweep(GEN1, {"friction.coefficient": [0, 0.1]}, cycle={"steps": 5, "directions": ["+X"]}),
    "montecarlo": lambda: bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=3, cycle={"steps": 5}),
    "cycle": lambda: bumpfoil.run_cycle(EXAMPLES / "gen3-three-pad.toml", cycle={"steps": 5}),
    "path": lambda: bumpfoil.run_path(GEN1, [(1e-5, 0), (5e-5, 0)]),
}


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
@pytest.mark.parametrize("command", SHORT)
def test_data_are_those_of_the_file_and_outlive_the_result(command, tmp_path):
    result = SHORT[command]()
    result.save(tmp_path / "results")
    data = result.data
    assert all(result.data[name] is array for name, array in data.items())
    loaded = bumpfoil.load(tmp_path / "results").data
    del result
    (file,) = (tmp_path / "results").glob("*.nc")
    with netCDF4.Dataset(file) as read:
        read.set_auto_mask(False)
        assert list(data) == list(loaded) == list(read.variables)
        for name, variable in read.variables.items():
            stored, absent = variable[...], variable[...] == getattr(variable, "_FillValue", np.nan)
            assert data[name].shape == stored.shape
            assert data[name].dtype == (float if absent.any() else stored.dtype)
            assert data[name][~absent].tobytes() == stored[~absent].astype(data[name].dtype).tobytes()
            assert np.isnan(data[name][absent]).all()
            np.testing.assert_array_equal(loaded[name], data[name])
            for array in (data[name], loaded[name], data[name][...]):
                with pytest.raises(ValueError, match="read-only"):
                    array[...] = 0


def test_report_is_that_of_the_program(result, tmp_path):
    result.report(tmp_path / "python.html")
    result.save(tmp_path / "cycle")
    subprocess.run([PROGRAM, "report", tmp_path / "cycle", "-o", tmp_path / "program.html", "--quiet"], check=True)
    assert (tmp_path / "python.html").read_bytes() == (tmp_path / "program.html").read_bytes()
    with pytest.raises(bumpfoil.FileError):
        result.report(tmp_path / "python.html")


def test_vtk_files_are_those_of_the_program(result, tmp_path):
    states = result.to_vtk(tmp_path / "python")
    result.save(tmp_path / "cycle")
    subprocess.run([PROGRAM, "export", tmp_path / "cycle", "--to", "vtk", "-o", tmp_path / "program", "--quiet"], check=True)
    files = {path.name: path.read_bytes() for path in (tmp_path / "python").iterdir()}
    assert files == {path.name: path.read_bytes() for path in (tmp_path / "program").iterdir()}
    assert states == 4 * 21 == len([name for name in files if name.startswith("cylinder") and name.endswith(".vtu")])
    assert files["cylinder.pvd"].count(b"<DataSet") == files["unwrapped.pvd"].count(b"<DataSet") == states
    with pytest.raises(bumpfoil.FileError, match="exists already; give another name, or force=True to replace it"):
        result.to_vtk(tmp_path / "python")
    assert result.to_vtk(tmp_path / "python", force=True) == states
    strip = bumpfoil.run_strip(EXAMPLES / "strip.toml", strip={"steps": 2})
    with pytest.raises(bumpfoil.CaseError, match="has no shapes"):
        strip.to_vtk(tmp_path / "strip")
    assert not (tmp_path / "strip").exists()


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
    assert "<td>−X</td>" in page


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
@pytest.mark.parametrize(
    ("command", "cells"),
    [
        ("vibration", ["load_y_N", "amplitude_m", "loss_factor", "−50", "1e-06"]),
        ("equilibrium", ["speed_rad_per_s", "h_min_m", "4712", "10", "converged"]),
        ("stability", ["speed_rad_per_s", "imag_rad_per_s", "1257", "sliding", "converged"]),
        ("unbalance", ["speed_rad_per_s", "bearing 1", "1257", "linear_stuck", "converged"]),
        ("sweep", ["friction_coefficient", "direction_deg", "max_force_N", "520.5", "738.6"]),
        ("montecarlo", ["+X", "maximum force (N)", "loss factor"]),
        ("path", ["path", "journal, X at the end (um)", "50", "force, X at the end (N)"]),
        ("optimise", ["point", "friction_coefficient", "loss_factor", "limit_1_max_force_N", "converged", "0.05"]),
    ],
)
def test_every_command_shows_a_table(command, cells):
    page = SHORT[command]()._repr_html_()
    assert page.startswith(f"<p><b>{command}</b>, complete</p><table>")
    for cell in cells:
        assert f"<td>{cell}</td>" in page, page


def test_sweeps_of_other_commands_show_their_keys_and_states():
    tables = {"film.rows": 4, "equilibrium.loads": [["10 N", "0 N"]]}
    over = {"friction.coefficient": [0.05, 0.1]}
    page = bumpfoil.run_sweep(EXAMPLES / "running.toml", over, command="equilibrium", **tables)._repr_html_()
    for cell in ("friction_coefficient", "0.05", "speed_rad_per_s", "load_x_N", "10", "h_min_m"):
        assert f"<td>{cell}</td>" in page, page


def test_choices_of_keys_can_be_read_and_run():
    result = SHORT["optimise"]()
    (friction,), (least,) = result.summary["keys"], result.summary["limits"]
    points, data = result.to_dataframe(), result.to_xarray()
    np.testing.assert_array_equal(points.friction_coefficient, data.key_value.values[:, 0])
    np.testing.assert_array_equal(points.limit_1_max_force_N, data.limit_value.values[:, 0])
    best = points.iloc[result.summary["best_point"]]
    assert best.friction_coefficient == friction["best_value"] and best.feasible
    assert list(points.feasible) == list(points.max_force_N > 600.0)
    # The front runs from the best of the first aim to that of the second.
    front = points.iloc[result.summary["front"]]
    assert (np.diff(front.loss_factor) < 0).all() and (np.diff(front.max_force_N) < 0).all()
    chosen = bumpfoil.Case(result.files["case.toml"].decode())
    assert bumpfoil.run_cycle(chosen).cycles[0].max_force == pytest.approx(least["value"], rel=1e-12)
    with pytest.raises(bumpfoil.CaseError, match=r"optimise\.maximise\[1\]"):
        bumpfoil.optimise(GEN1, keys={"friction.coefficient": {"lower": 0, "upper": 1}}, optimise={"command": "cycle", "maximise": "loss"})


def test_samples_are_a_table():
    result = bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=3, cycle={"steps": 5, "directions": ["+X", "-Y"]})
    table, data = result.to_dataframe(), result.to_xarray()
    assert list(zip(table["sample"], table.direction_deg)) == [(i, direction) for i in range(3) for direction in (0, 270)]
    np.testing.assert_array_equal(table.loaded_stiffness_N_per_m, data.loaded_stiffness.values.ravel())
    np.testing.assert_array_equal(table.clearance_5N_m, data.clearance_5N.values.ravel())
    assert set(table.status) == {"converged"} and "loss_factor" in table
    means = table.groupby("direction_deg").max_force_N.mean()
    np.testing.assert_allclose(means[0], result.summary["statistics"]["+X"]["max_force_N"]["mean"], rtol=1e-12)
    assert f"<td>{means[0]:.4g} ± " in result._repr_html_()


def test_ensembles_of_version_0_2_0_are_shown(tmp_path):
    new = bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=3, cycle={"steps": 5, "directions": ["+X"]})
    files = dict(new.files)
    summary = json.loads(files["summary.json"])
    del summary["sampled_command"]
    path = tmp_path / "ensemble.nc"
    path.write_bytes(files["ensemble.nc"])
    with netCDF4.Dataset(path, "a") as data:
        data.delncattr("sampled_command")
        data.delncattr("target_quantity")
    old = bumpfoil.Result("montecarlo", [], files={"summary.json": json.dumps(summary).encode(), "ensemble.nc": path.read_bytes()})
    assert old._repr_html_() == new._repr_html_()
    assert old.plot_ensemble().get_xlabel() == new.plot_ensemble().get_xlabel()
    shown, same = ([ax.get_xlabel() for ax in figures.ensemble(one).axes] for one in (old, new))
    assert shown == same


FILM = {"film": {"rows": 4}, "equilibrium": {"loads": [["10 N", "0 N"]]}}
ENSEMBLES = {
    "sweep": lambda: bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=2, cycle={"steps": 5}),
    "equilibrium": lambda: bumpfoil.run_montecarlo(EXAMPLES / "running_tolerances.toml", samples=2, **FILM),
}


def columns_of(data, names):
    return {bumpfoil._native.key_of(name, data[name].attrs.get("units", "")) for name in names}


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
@pytest.mark.parametrize("command", ENSEMBLES)
def test_columns_of_samples_are_those_of_csv_files(command):
    alone, ensemble = SHORT[command](), ENSEMBLES[command]()
    data = alone.to_xarray()
    missing = set(alone.to_dataframe()) - set(ensemble.to_dataframe())
    assert missing <= columns_of(data, set(data.variables) - set(ensemble.data)), missing
    assert {"sweep": "loaded_stiffness_N_per_m", "equilibrium": "attitude_angle_deg"}[command] in ensemble.to_dataframe()


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
@pytest.mark.parametrize("command", SHORT)
def test_columns_have_their_units_by_one_rule(command):
    result = SHORT[command]()
    data = result.to_xarray()
    # Of clearances the file has a list.
    forces = data.clearance_force.values if "clearance_force" in data else []
    clearances = {f"clearance_{force:.6g}N_m" for force in forces}
    # Rows of fits have units of their own, and say in words what they are of; columns of points are named by the keys.
    words = {
        "fit": {"series", "quantity", "unit", "axis", "axis_unit"},
        "optimise": {"status", "friction_coefficient", "loss_factor", "max_force_N", "limit_1_max_force_N"},
    }.get(command, set())
    assert set(result.to_dataframe()) <= columns_of(data, data.variables) | clearances | words


def test_others_are_shown_in_a_notebook(result):
    assert result.case.toml.splitlines()[2] in result.case._repr_html_()
    assert f"<td>{result.cycles[1].max_force:.4g}</td>" in result.cycles[1]._repr_html_()
    page = bumpfoil.Stepper(GEN1, position=(0, -40e-6)).state._repr_html_()
    assert "<td>converged</td>" in page and "<td>position (µm)</td><td>0</td><td>−40</td>" in page


def test_package_runs_the_program():
    words = [sys.executable, "-m", "bumpfoil", "--version"]
    shown = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    assert shown == f"bumpfoil {bumpfoil.__version__} ({bumpfoil._native.commit})\n"
