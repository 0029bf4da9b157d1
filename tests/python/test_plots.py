"""Pictures show what results hold."""

import re

import matplotlib
import numpy as np
import pytest

matplotlib.use("agg")

import bumpfoil  # noqa: E402
from conftest import COARSE, EXAMPLES  # noqa: E402

GEN1 = EXAMPLES / "gen1.toml"


@pytest.fixture(scope="module")
def result():
    return bumpfoil.run_cycle(GEN1, cycle={"steps": 10})


def drawn(ax):
    """Lines by their labels; the picture is drawn, too."""
    ax.figure.canvas.draw()
    return {line.get_label(): line.get_xydata() for line in ax.lines}


def test_loops(result):
    lines = drawn(result.plot_loops())
    assert list(lines) == ["+X", "−X", "+Y", "−Y"]
    cycle = result.cycles[2]
    np.testing.assert_array_equal(lines["+Y"], np.column_stack([1e6 * cycle.displacement, cycle.force_direct]))


def test_bump_loads(result):
    lines = drawn(result.plot_bump_loads())
    np.testing.assert_array_equal(lines["−Y"], np.column_stack([np.arange(1, 27), result.cycles[3].bump_loads]))


def test_foils(result):
    cycle = result.cycles[0]
    np.testing.assert_array_equal(drawn(cycle.plot_foils())["crest"][:, 1], 1e6 * cycle.crest_v[10])
    np.testing.assert_array_equal(drawn(cycle.plot_foils(5))["top foil"][:, 1], 1e6 * cycle.top_displacement[5])


def test_contacts(result):
    cycle = result.cycles[0]
    ax = cycle.plot_contacts("top_bump")
    ax.figure.canvas.draw()
    np.testing.assert_array_equal(ax.collections[0].get_array().ravel(), cycle.state_top_bump.ravel())
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "open", "stick", "slip forward", "slip backward", "largest displacement",
    ]  # fmt: skip
    assert list(ax.lines[0].get_ydata()) == [10, 10]


def ticks(ax):
    ax.figure.canvas.draw()
    return dict(zip((text.get_text() for text in ax.get_xticklabels()), ax.get_xticks()))


@pytest.mark.parametrize("loaded", [False, True])
def test_pads_stand_apart(loaded, tmp_path):
    """Lines break between pads, and bumps are counted from the weld of theirs."""
    case = bumpfoil.Case(EXAMPLES / "three_pads.toml").to_dict()
    case["pad"][2]["bump_foil"].update(bumps=7, length="4 mm")
    result = bumpfoil.run_cycle(case, cycle={"steps": 4})
    if loaded:
        result.save(tmp_path)
        result = bumpfoil.load(tmp_path)
    cycle = result.cycles[0]
    assert cycle.bump_pad.tolist() == [1] * 8 + [2] * 8 + [3] * 7
    assert cycle.foot_pad.tolist() == cycle.bump_pad.tolist()
    assert result.data["bump_pad"].tolist() == cycle.bump_pad.tolist()
    at = [*range(1, 9), np.nan, *range(10, 18), np.nan, *range(19, 26)]
    for ax, values in (
        (result.plot_bump_loads(), cycle.bump_loads),
        (cycle.plot_foils(), 1e6 * cycle.top_displacement[4]),
    ):
        x, y = ax.lines[0].get_data()
        np.testing.assert_array_equal(x, at)
        np.testing.assert_array_equal(y, np.insert(values, [8, 16], np.nan))
        assert [line.get_xdata()[0] for line in ax.lines if len(line.get_xdata()) == 2] == [9, 18]
        assert ticks(ax) == {"1.1": 1, "1.4": 4, "1.7": 7, "2.1": 10, "2.4": 13, "2.7": 16, "3.1": 19, "3.4": 22}
        assert ax.get_xlabel() == "pad.bump, counted from the weld"
    ax = cycle.plot_contacts("top_bump")
    assert ticks(ax) == {"1.1": 1, "1.4": 4, "2.1": 9, "2.4": 12, "3.1": 17, "3.4": 20}
    np.testing.assert_array_equal(ax.collections[0].get_array().ravel(), cycle.state_top_bump.ravel())


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_coefficients():
    result = bumpfoil.run_vibration(EXAMPLES / "vibration.toml", vibration={"steps": 4, "amplitudes": ["1 um", "2 um"]})
    lines = drawn(result.plot_coefficients())
    table = result.to_dataframe("coefficients")
    first = table[(table.load_y_N == -50) & (table.amplitude_m == 1e-6)].iloc[0]
    np.testing.assert_allclose(lines["kxx, (0, −50) N"][0], [1, 1e-6 * first.kxx_N_per_m], rtol=1e-12)


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_coefficients_of_running_bearings():
    case = {"speeds": ["30000 rpm", "45000 rpm"], "loads": [["20 N", "0 N"], ["50 N", "0 N"]]}
    result = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=case, film=COARSE)
    ax = result.plot_coefficients()
    table = result.to_dataframe("coefficients")
    fast = table[(table.load_x_N == 50) & (table.speed_rad_per_s > 4000)].iloc[0]
    line = drawn(ax)["kyy, (50, 0) N"]
    np.testing.assert_allclose(line[1], [45000, 1e-6 * fast.kyy_stuck_N_per_m], rtol=1e-12)
    assert ax.get_xlabel() == "speed (rpm)"
    # Over the frequency where there are several, which case files may have in any order.
    several = {"loads": [["20 N", "0 N"]], "frequencies": ["500 Hz", "100 Hz"]}
    running = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=several, film=COARSE)
    line = drawn(running.plot_coefficients())["kxx"]
    np.testing.assert_allclose(line[:, 0], [100, 500], rtol=1e-12)
    # Of positions without loads over the displacement.
    words = (EXAMPLES / "running.toml").read_text(encoding="utf-8")
    words = re.sub(r"^loads = .*$", 'positions = [["5 um", "0 um"], ["8 um", "6 um"]]', words, flags=re.MULTILINE)
    words = words.replace('path = "load_ramp"', 'path = "position_ray"')
    ax = bumpfoil.run_equilibrium(words, film=COARSE).plot_coefficients()
    np.testing.assert_allclose(drawn(ax)["kxx"][:, 0], [5, 10], rtol=1e-12)
    assert ax.get_xlabel() == "displacement (µm)"


def test_drawn_on_given_axes(result):
    import matplotlib.pyplot as plt

    ax = plt.subplots()[1]
    assert result.plot_loops(ax=ax) is ax


@pytest.fixture(scope="module")
def sweep():
    over = {"friction.coefficient": [0.0, 0.1, 0.2], "cycle.amplitude": ["60 um", "80 um"]}
    return bumpfoil.run_sweep(GEN1, over, cycle={"steps": 5, "directions": ["+X", "-Y"]})


@pytest.fixture(scope="module")
def ensemble():
    return bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=6, cycle={"steps": 5, "directions": ["+X", "-Y"]})


def test_sweeps(sweep):
    ax = sweep.plot_sweep("loop_energy")
    lines = drawn(ax)
    assert list(lines) == [f"cycle.amplitude {size} m, {name}" for size in ("6e-05", "8e-05") for name in ("+X", "−Y")]
    energy = sweep.to_xarray().loop_energy[:, 1, 0]
    np.testing.assert_array_equal(lines["cycle.amplitude 8e-05 m, +X"], np.column_stack([[0, 0.1, 0.2], energy]))
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("friction.coefficient", "loop energy (J)")
    with pytest.raises(ValueError, match="has no 'loop_enrgy' over .*; it has .*loop_energy"):
        sweep.plot_sweep("loop_enrgy")


def test_ensembles(ensemble):
    ax = ensemble.plot_ensemble("loss_factor")
    ax.figure.canvas.draw()
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["+X", "−Y"]
    samples = ensemble.data["loss_factor"]
    for patch, column in zip(ax.patches, samples.T):
        counted, edges = np.histogram(column, np.histogram_bin_edges(samples, 3))  # the root of 6, and one more
        assert set(counted) <= set(patch.get_xy()[:, 1]) and set(edges) <= set(patch.get_xy()[:, 0])


def test_what_a_result_has_not_is_told(result, sweep, ensemble):
    from bumpfoil import figures

    path = bumpfoil.run_path(GEN1, [(1e-5, 0), (5e-5, 0)])
    strip = bumpfoil.run_strip(EXAMPLES / "strip.toml").cycles[0]
    for draw, told in [
        (sweep.plot_loops, "of sweep has no loops to draw; it has quantities over keys"),
        (ensemble.plot_bump_loads, "of montecarlo has no bump loads to draw; it has distributions"),
        (path.plot_bump_loads, "of path has no bump loads to draw; it has loops"),
        (result.plot_coefficients, "of cycle has no coefficients to draw; it has loops, bump loads"),
        (result.plot_ensemble, "of cycle has no distributions"),
        (ensemble.plot_sweep, "of montecarlo has no quantities over keys"),
        (lambda: figures.loops(sweep), "of sweep has no loops"),
        (lambda: figures.bump_loads(path), "of path has no bump loads"),
        (lambda: figures.ensemble(result), "of cycle has no distributions"),
        (lambda: figures.coefficients(ensemble), "of montecarlo has no coefficients"),
        (lambda: figures.foils(strip), "cycle 1: has no .*gap_journal_top to draw; it has"),
        (lambda: strip.plot_contacts("journal_top"), "has no state_journal_top to draw; it has state_top_bump, state_bump_sleeve$"),
        (lambda: result.to_dataframe("coefficients"), "of cycle has no table 'coefficients'; it has cycle$"),
        (lambda: ensemble.to_dataframe("cycle"), "of montecarlo has no table 'cycle'; it has montecarlo$"),
    ]:
        with pytest.raises(ValueError, match=told):
            draw()
    assert [ax.get_title() for ax in figures.contacts(strip).axes] == ["top foil on bump", "bump on sleeve"]
