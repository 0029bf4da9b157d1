"""Runs of Python are those of the program, bit by bit; from several threads, again and again, until Ctrl-C."""

import os
import resource
import signal
import threading
import time
import tomllib
from concurrent.futures import ThreadPoolExecutor

import netCDF4
import numpy as np
import pytest
import xarray

import bumpfoil
from conftest import COARSE, EXAMPLES

GEN1 = EXAMPLES / "gen1.toml"
FRAME = {"bump_foil.model": "frame", "cycle.steps": 10}


def variables(file):
    """Of a netCDF file, as they are stored, but for what a clock says."""
    file.set_auto_mask(False)
    return {name: variable[...] for name, variable in file.variables.items() if "wall_time" not in name}


def assert_same(by_python, by_program):
    assert by_python.keys() == by_program.keys()
    for name, values in by_program.items():
        assert values.tobytes() == by_python[name].tobytes(), name


def test_any_experiment_runs_by_the_name_of_its_command():
    at = {"speeds": ["45000 rpm"], "positions": [["15 um", "-4 um"]]}
    result = bumpfoil.run("film", GEN1, equilibrium=at, film={"rows": 4})
    assert (result.command, result.status, len(result.summary["states"])) == ("film", "complete", 1)
    with pytest.raises(ValueError, match="no experiment 'hover'; use one of cycle, strip"):
        bumpfoil.run("hover", GEN1)


@pytest.mark.parametrize(
    ("command", "example", "changes"),
    [
        ("cycle", "gen1", {}),
        ("cycle", "gen1", FRAME),
        ("cycle", "gen1", {"solver.name": "events", "cycle.steps": 20}),
        ("strip", "strip", {}),
        ("path", "gen1", {"path.centre": ["0 um", "-45 um"], "path.semi_axes": ["10 um", "5 um"], "path.steps": 20}),
        ("cycle", "three_pads", {"cycle.steps": 10}),
        ("path", "three_pads", {"path.points": [["10 um", "0 um"], ["40 um", "-20 um"]]}),
        ("vibration", "vibration", {"vibration.steps": 10}),
        ("equilibrium", "running", {"equilibrium.loads": [["20 N", "0 N"]], "film": COARSE}),
        ("stability", "rotor", {"stability.speeds": ["12000 rpm", "14000 rpm"], "film": COARSE}),
        ("unbalance", "rotor", {"unbalance.speeds": ["12000 rpm", "14000 rpm"], "film": COARSE}),
        ("equilibrium", "running_pads", {"equilibrium.loads": [["20 N", "0 N"]], "film": COARSE}),
    ],
)
def test_results_are_those_of_the_program(command, example, changes, program):
    case = bumpfoil.Case(EXAMPLES / f"{example}.toml", **changes)
    result = getattr(bumpfoil, f"run_{command}")(case)
    written = bumpfoil.Result(command, [], files=result.files)
    sets = [word for change in case._source.changes for word in ("--set", change)]
    folder = program(command, EXAMPLES / f"{example}.toml", *sets)
    assert result.status == written.status == "complete"
    assert result.case == case
    assert sorted(result.files) == sorted(path.name for path in folder.iterdir() if path.suffix != "")
    with netCDF4.Dataset(folder / "result.nc") as by_program, netCDF4.Dataset("result.nc", memory=result.files["result.nc"]) as file:
        assert_same(variables(file), variables(by_program))
        assert file.case_understood == by_program.case_understood
    if result.cycles:
        assert_same_cycles(result.cycles, bumpfoil.load(folder).cycles)
        assert (folder / f"{command}.csv").read_bytes() == result.files[f"{command}.csv"]


def assert_same_cycles(by_python, by_program):
    """What is in memory is what a file of the program holds, no more and no less."""
    assert [cycle.name for cycle in by_python] == [cycle.name for cycle in by_program]
    for cycle, read in zip(by_python, by_program):
        for place in ("quantities", "series", "fields"):
            held, expected = getattr(cycle, place), getattr(read, place)
            absent = {name for name, values in expected.items() if np.ndim(values) and np.all(np.isnan(values))}
            assert held.keys() ^ expected.keys() == absent - held.keys(), place
            for name, values in held.items():
                if name != "wall_time":
                    np.testing.assert_array_equal(values, expected[name], err_msg=name)


def test_fields_are_views_that_cannot_be_written():
    run = bumpfoil.run_cycle(GEN1, cycle={"steps": 5})
    cycle = run.cycles[0]
    assert not any(values.flags.owndata for values in cycle.fields.values())
    for name, values in {**cycle.fields, "bump_loads": cycle.bump_loads}.items():
        assert not values.flags.writeable, name
        with pytest.raises(ValueError):
            values[0] = 1
    # The same place in memory, asked again; it outlives all but the view.
    (again, *_) = run._run.cycles()
    assert cycle.crest_v.ctypes.data == again["fields"]["crest_v"].ctypes.data
    kept, expected = cycle.crest_v, cycle.crest_v.copy()
    del run, cycle, again
    np.testing.assert_array_equal(kept, expected)


def test_names_of_cycles_complete_and_are_told():
    (cycle,) = bumpfoil.run_cycle(GEN1, cycle={"steps": 5, "directions": ["+Y"]}).cycles
    assert {"loop_energy", "force_direct", "crest_v"} <= set(dir(cycle))
    assert cycle.name == "+Y" and cycle.direction == 90.0
    with pytest.raises(AttributeError, match="has no 'loop_enrgy'"):
        cycle.loop_enrgy


def test_sweep_over_friction_in_ten_lines():
    case = bumpfoil.Case(GEN1, cycle={"directions": ["+X"], "steps": 20})
    energies = []
    for coefficient in np.linspace(0.0, 0.4, 5):
        result = bumpfoil.run_cycle(case, friction={"coefficient": coefficient})
        energies.append(result.cycles[0].loop_energy)
    # Nothing rubs, nothing is lost.
    assert abs(energies[0]) < 1e-9 * energies[1]
    assert min(energies[1:]) > 0


def test_path_of_numpy():
    angle = np.linspace(0.0, 4.0 * np.pi, 81)
    positions = np.column_stack([10e-6 * np.cos(angle), -45e-6 + 5e-6 * np.sin(angle)])
    result = bumpfoil.run_path(GEN1, positions)
    (cycle,) = result.cycles
    # The first increment is the assembly at the centre.
    np.testing.assert_allclose(np.column_stack([cycle.x, cycle.y])[1:], positions, rtol=0, atol=1e-18)  # m: roundings
    assert cycle.dissipated_energy[-1] > 0
    loads = np.array([[0.0, -50.0], [10.0, -50.0]])
    (cycle,) = bumpfoil.run_path(GEN1, loads=loads).cycles
    # The load is met to what load control promises of it.
    np.testing.assert_allclose(np.column_stack([cycle.force_x, cycle.force_y])[1:], loads, rtol=0, atol=1e-4)


def objects(rows):
    """An array whose entries are what is given, whatever that is."""
    array = np.empty((len(rows), len(rows[0])), dtype=object)
    for i, row in enumerate(rows):
        for j, entry in enumerate(row):
            array[i, j] = entry
    return array


def test_paths_of_quantities():
    units = pytest.importorskip("pint").UnitRegistry()
    positions, loads = np.array([[0.0, -30.0], [5.0, -40.0]]), np.array([[0.0, -50.0], [10.0, -50.0]])
    quantities = lambda values, unit: [  # noqa: E731
        values * units(unit),
        [row * units(unit) for row in values],
        [[number * units(unit) for number in row] for row in values],
        objects([[number * units(unit) for number in row] for row in values]),
        xarray.DataArray(values * units(unit)),
    ]
    points = lambda result: result.case.to_dict()["path"]["points"]  # noqa: E731
    expected = points(bumpfoil.run_path(GEN1, 1e-6 * positions))
    for given in quantities(positions, "um"):
        np.testing.assert_allclose(points(bumpfoil.run_path(GEN1, given)), expected, rtol=1e-14)
    expected = points(bumpfoil.run_path(GEN1, loads=loads))
    for given in quantities(1e-3 * loads, "kN"):
        assert points(bumpfoil.run_path(GEN1, loads=given)) == expected


def test_paths_that_are_none():
    units = pytest.importorskip("pint").UnitRegistry()
    points = [[0.0, -30.0]]
    for positions, loads, told in [
        (points * units.N, None, "positions = .*is not in m"),
        (None, points * units.um, "loads = .*is not in N"),
        ([["0 um", "-30 um"]], None, "positions = '0 um': is a text"),
        ([0.0, -30e-6], None, r"positions: has the shape \(2,\)"),
        ([[0.0], [1.0, 2.0]], None, "positions: is not an array of numbers"),
        (points, points, "both positions and loads"),
    ]:
        with pytest.raises(bumpfoil.CaseError, match=told):
            bumpfoil.run_path(GEN1, positions, loads)


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_paths_and_limits_of_running_bearings():
    case = {"speeds": ["45000 rpm"], "loads": [["20 N", "0 N"], ["60 N", "0 N"]]}
    result = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=case, film=COARSE)
    assert {state["path"] for state in result.summary["states"]} == {"load_ramp"}
    assert result.summary["spreads"] == result.summary["limits"] == []
    result = bumpfoil.run_equilibrium(
        EXAMPLES / "running.toml", all_paths=True, limits=True, equilibrium=case, film=COARSE | {"h_lift_off": "8 um"}
    )
    assert {state["path"] for state in result.summary["states"]} == {"load_ramp", "speed_ramp", "position_ray", "cold_start"}
    assert len(result.summary["spreads"]) == 2
    assert {limit["kind"] for limit in result.summary["limits"]} == {"lift_off_speed", "load_capacity"}
    with pytest.raises(bumpfoil.CaseError, match="h_lift_off"):
        bumpfoil.run_equilibrium(EXAMPLES / "running.toml", limits=True, equilibrium=case)


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_coefficients_of_running_bearings_over_frequency():
    case = {"loads": [["20 N", "0 N"]], "speeds": ["45000 rpm", "30000 rpm"]}
    for frequencies in ({"frequencies": ["750 Hz", "200 Hz"]}, {}):
        result = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=case | frequencies, film=COARSE)
        data = result.to_xarray()
        data = data.assign_coords(state=data.speed.values).sortby(["state", "frequency"])
        tables = tomllib.loads(result.files["coefficients.toml"].decode())["bearing"]
        assert [table["contacts"] for table in tables] == ["stuck", "slipping"]
        for table, end in zip(tables, ["_stuck", ""]):
            element = table["element"]
            assert data.frequency.values.tolist() == element["frequency"]
            assert data.state.values.tolist() == element["speed"] == table["synchronous"]["speed"]
            for name in ("kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"):
                assert data[f"{name}_at_frequency{end}"].dims == ("state", "frequency")
                np.testing.assert_array_equal(data[f"{name}_at_frequency{end}"], element[name])
            if not frequencies:
                np.testing.assert_array_equal(data[f"kyx_whirl{end}"], table["synchronous"]["kyx"])
        rows = result.to_dataframe("coefficients")
        assert len(rows) == 2 * max(1, len(frequencies.get("frequencies", [])))


def test_several_threads_at_once():
    coefficients = [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35]
    run = lambda coefficient: bumpfoil.run_cycle(GEN1, friction={"coefficient": coefficient}, cycle={"steps": 20})  # noqa: E731
    alone = [run(coefficient) for coefficient in coefficients]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(run, coefficients * 2))
    for one, other in zip(alone * 2, together):
        for a, b in zip(one.cycles, other.cycles):
            assert a.force_direct.tobytes() == b.force_direct.tobytes()
            assert a.normal_force_top_bump.tobytes() == b.normal_force_top_bump.tobytes()
        assert other.files["cycle.csv"] == one.files["cycle.csv"]


def test_other_threads_go_on_meanwhile():
    """The lock of the interpreter is released while a run goes on."""
    running = threading.Thread(target=bumpfoil.run_cycle, args=(GEN1,), kwargs={"cycle": {"steps": 4000}})
    begin = last = time.monotonic()
    longest = 0.0
    running.start()
    while running.is_alive():
        now = time.monotonic()
        longest, last = max(longest, now - last), now
    # This loop would stand still as long as the run takes.
    assert longest < 0.5 * (time.monotonic() - begin)


def test_memory_is_steady():
    """Of 500 runs, to be quick; 10,000 in 99 s were tried once, and memory stayed at 23,794 pages."""
    case = bumpfoil.Case(GEN1, cycle={"directions": ["+X"], "steps": 5})

    def run(times):
        for _ in range(times):
            result = bumpfoil.run_cycle(case, friction={"coefficient": 0.2})
            assert result.cycles[0].crest_v.shape == (11, 26)
        assert result.files

    for _ in range(10):
        run(5)  # what is kept for later is kept by then
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(10):
        run(50)
    # Of each of 500 results some 40 kB of fields alone would be lost, and 200 kB of each of 10 sets of files.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 1500  # kB


def test_progress_is_told_and_can_stop_the_run():
    told = []
    bumpfoil.run_cycle(GEN1, progress=told.append)
    assert told == sorted(told) and told[-1] == 1.0
    case = bumpfoil.Case(GEN1, cycle={"steps": 20000})
    with pytest.warns(bumpfoil.RunWarning) as warned:
        result = bumpfoil.run_cycle(case, progress=lambda fraction: False)
    assert result.status == "interrupted" == result.summary["status"]
    assert len(warned) == 1
    with pytest.raises(ZeroDivisionError):
        bumpfoil.run_cycle(GEN1, progress=lambda fraction: 1 / 0)


def test_progress_is_shown_where_it_is_asked_for(capsys, monkeypatch):
    monkeypatch.setattr("bumpfoil.progress._BEFORE_SHOWN", 0.0)  # s
    bumpfoil.run_cycle(GEN1, progress=True)
    assert "100%" in capsys.readouterr().err
    bumpfoil.run_cycle(GEN1)  # standard error is no terminal
    assert capsys.readouterr().err == ""


def test_interrupted_by_ctrl_c():
    case = bumpfoil.Case(GEN1, cycle={"steps": 60_000})
    # As ever, unless these tests run in the background of a shell without job control.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        bumpfoil.run_cycle(case)
    # The whole run would take twice that at least.
    assert time.monotonic() - begin < 5
