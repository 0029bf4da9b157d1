"""Sweeps and ensembles of Python are those of the program, bit by bit."""

import warnings

import netCDF4
import numpy as np
import pytest

import bumpfoil
from bumpfoil import figures
from conftest import EXAMPLES
from test_runs import assert_same, variables

GEN1 = EXAMPLES / "gen1.toml"
TOLERANCES = EXAMPLES / "tolerances.toml"
SHORT = {"cycle.steps": 10, "cycle.directions": ["+X", "-Y"]}


def assert_same_file(result, path):
    with netCDF4.Dataset(path) as by_program, netCDF4.Dataset(path.name, memory=result.files[path.name]) as file:
        assert_same(variables(file), variables(by_program))


def test_sweep_is_that_of_the_program(program):
    over = {"friction.coefficient": np.array([0.0, 0.1, 0.2]), "cycle.amplitude": "60 um:80 um:20 um"}
    result = bumpfoil.run_sweep(GEN1, over, **SHORT)
    words = ["--over", "friction.coefficient=[0.0, 0.1, 0.2]", "--over", "cycle.amplitude=60 um:80 um:20 um"]
    sets = ["--set", "cycle.steps=10", "--set", 'cycle.directions=["+X","-Y"]']
    folder = program("sweep", GEN1, *words, *sets)
    assert_same_file(result, folder / "sweep.nc")
    table, by_program = (read.to_dataframe().drop(columns="wall_time_s") for read in (result, bumpfoil.load(folder)))
    assert table.equals(by_program)
    energy = result.to_xarray().loop_energy.sel(direction=0)
    assert energy.shape == (3, 2) and np.all(np.diff(energy[1:], axis=1) > 0)
    assert len(result.to_dataframe()) == 12
    assert bumpfoil.load(folder).command == "sweep" == result.command


def test_sweep_of_another_command():
    result = bumpfoil.run_sweep(EXAMPLES / "strip.toml", {"friction.coefficient": [0.0, 0.1]}, command="strip")
    assert result.to_xarray().attrs["swept_command"] == "strip"
    with pytest.raises(ValueError, match="use one of cycle, strip"):
        bumpfoil.run_sweep(GEN1, {"friction.coefficient": [0]}, command="path")


def test_errors_of_a_sweep():
    with pytest.raises(bumpfoil.CaseError, match=r"^friction\.coefficient = -1"):
        bumpfoil.run_sweep(GEN1, {"friction.coefficient": [0, -1]})


def test_sweep_can_be_stopped():
    with pytest.warns(bumpfoil.RunWarning) as warned:
        result = bumpfoil.run_sweep(GEN1, {"friction.coefficient": "0:0.5:0.01"}, progress=lambda fraction: False)
    assert result.status == "interrupted"
    assert warned[0].filename == __file__


def test_ensemble_is_that_of_the_program(program, tmp_path):
    folder = program("montecarlo", TOLERANCES, "--samples", 20, "--seed", 3, "--limit", "clearance_5N > 20 um")
    result = bumpfoil.run_montecarlo(TOLERANCES, samples=20, seed=3, limits=["clearance_5N > 20 um"])
    assert_same_file(result, folder / "ensemble.nc")
    assert result.summary["statistics"] == bumpfoil.load(folder).summary["statistics"]
    assert (result.command, result.status, result.summary["solver"]) == ("montecarlo", "complete", "events")
    with pytest.raises(bumpfoil.FileError):
        bumpfoil.run_montecarlo(TOLERANCES, folder, samples=20, seed=3)


def test_number_of_samples_may_stand_in_the_table():
    result = bumpfoil.run_montecarlo(TOLERANCES, montecarlo={"samples": 3, "seed": 8}, cycle={"steps": 5})
    assert (result.summary["samples"], result.summary["seed"]) == (3, 8)


def test_ensemble_of_running_bearings(program):
    film = {"film": {"columns_per_pitch": 4, "rows": 4}, "equilibrium": {"loads": [[10, 0], [20, 0]], "steps": 1}}
    film["film"]["h_lift_off"] = "8 um"
    film["top_foil"] = {"formed_radius": "seated"}  # states last
    scatter = {"command": "equilibrium", "samples": 3, "limits": True, "radial_clearance": {"std": "1 um"}}
    result = bumpfoil.run_montecarlo(EXAMPLES / "running.toml", montecarlo=scatter, **film)
    data = result.to_xarray()
    assert dict(data.sizes) == {"sample": 3, "state": 2, "bump": 26}
    assert list(data.load_x.values) == [10, 20] and np.all(data.status == 0)
    for sample, state in ((1, 0), (2, 1)):
        radial_clearance = 31.8e-6 + float(data.radial_clearance_deviation[sample])
        with warnings.catch_warnings():  # of a foil that is lifted
            warnings.simplefilter("ignore", bumpfoil.RunWarning)
            alone = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", bearing={"radial_clearance": radial_clearance}, **film)
        for name in ("h_min", "power", "kyx", "cxx_whirl", "highest_bump_load"):
            np.testing.assert_allclose(data[name][sample, state], alone.to_xarray()[name][state], rtol=1e-9)
        np.testing.assert_allclose(data.bump_load[sample, state].max(), data.highest_bump_load[sample, state])
    assert np.all(data.load_capacity > 0) and np.all(np.diff(data.lift_off_speed, axis=1) > 0)
    table = result.to_dataframe()
    assert list(table.h_min_m) == list(data.h_min.values.ravel()) and set(table.state) == {1, 2}
    texts = [text.get_text() for text in result.plot_ensemble().get_legend().get_texts()]
    assert texts == ["45000 rpm, load (10, 0) N", "45000 rpm, load (20, 0) N"]
    assert "minimum film thickness" in figures.ensemble(result, width="single").axes[0].get_xlabel()
    assert "power loss (W)" in result._repr_html_()


def test_ensemble_of_unbalanced_rotors():
    tables = {"film": {"rows": 4}, "rotor": {"unbalance": [{"amount": "2 g mm"}]}, "unbalance": {"speeds": ["8000 rpm", "10000 rpm"]}}
    of = {"command": "unbalance"}
    result = bumpfoil.run_montecarlo(EXAMPLES / "rotor_tolerances.toml", samples=4, limits=["largest_amplitude < 1.8 um"], montecarlo=of, **tables)
    data = result.to_xarray()
    assert np.all(data.status == 0)
    assert result.summary["yield"]["passed"] == np.sum(data.largest_amplitude < 1.8e-6)
    assert "amplitude" in result.plot_ensemble().get_xlabel()
    assert figures.ensemble(result).axes[0].get_xlabel() == "largest amplitude (µm)"


def test_ensemble_of_rotors_in_time():
    march = {"speed": {"to": "9000 rpm", "time": "14 ms"}, "steps_per_revolution": 20, "revolutions_per_spectrum": 1}
    tables = {"film": {"rows": 4, "columns_per_pitch": 4}, "rotor": {"unbalance": [{"amount": "2 g mm"}]}, "transient": march}
    result = bumpfoil.run_montecarlo(EXAMPLES / "rotor_tolerances.toml", samples=2, montecarlo={"command": "transient"}, **tables)
    assert np.all(result.to_xarray().status == 0)
    assert "half peak to peak" in result.plot_ensemble().get_xlabel()
    assert figures.ensemble(result).axes[0].get_xlabel() == "largest half peak-to-peak (µm)"
    assert "largest half peak-to-peak" in result._repr_html_()


def test_sweep_of_unbalanced_rotors():
    tables = {"film": {"rows": 4, "columns_per_pitch": 4}, "unbalance": {"speeds": ["8000 rpm", "10000 rpm"]}}
    swept = bumpfoil.run_sweep(EXAMPLES / "rotor.toml", {"rotor.mass": [1.0, 2.0]}, command="unbalance", **tables).to_xarray()
    assert swept.journal_amplitude.dims == ("rotor_mass", "speed")
    np.testing.assert_array_equal(swept.largest_amplitude, swept.journal_amplitude.max("speed"))


def test_ensemble_of_rotors():
    tables = {"film": {"rows": 4}, "stability": {"speeds": ["12000 rpm", "15000 rpm"]}}
    result = bumpfoil.run_montecarlo(EXAMPLES / "rotor_tolerances.toml", samples=4, limits=["stable_up_to > 12000 rpm"], **tables)
    data = result.to_xarray()
    assert dict(data.sizes) == {"sample": 4, "rotor": 1, "bump": 26} and "bump_load" not in data
    assert np.all(data.status == 0) and not np.any(data.stable_throughout)
    np.testing.assert_array_equal(data.stable_up_to, np.fmin(data.onset_speed, data.onset_speed_stuck))
    assert result.summary["yield"]["passed"] == np.sum(data.stable_up_to > 400 * np.pi)
    assert list(result.to_dataframe().stable_up_to_rad_per_s) == list(data.stable_up_to.values.ravel())
    assert "stable" in result.plot_ensemble().get_xlabel()
    assert figures.ensemble(result).axes[1].get_xlabel() == "onset of whirl (rpm)"
    assert "stable up to (rpm)" in result._repr_html_()


def test_ensemble_goes_on_where_it_was_stopped(tmp_path):
    with pytest.warns(bumpfoil.RunWarning, match="interrupted"):
        stopped = bumpfoil.run_montecarlo(TOLERANCES, tmp_path, samples=200, progress=lambda fraction: False)
    assert stopped.status == "interrupted"
    resumed = bumpfoil.run_montecarlo(TOLERANCES, tmp_path, samples=40, resume=True, threads=2)
    whole = bumpfoil.run_montecarlo(TOLERANCES, samples=40, threads=1)
    np.testing.assert_array_equal(resumed.to_xarray().max_force, whole.to_xarray().max_force)


def test_ctrl_c_keeps_the_samples(tmp_path):
    def press(fraction):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        bumpfoil.run_montecarlo(TOLERANCES, tmp_path, samples=10, progress=press)
    assert bumpfoil.load(tmp_path).status == "interrupted"
