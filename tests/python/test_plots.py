"""Pictures show what results hold."""

import re

import matplotlib
import numpy as np
import pytest

matplotlib.use("agg")

import bumpfoil  # noqa: E402
from conftest import EXAMPLES  # noqa: E402

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
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["open", "stick", "slip forward", "slip backward"]


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_coefficients():
    result = bumpfoil.run_vibration(EXAMPLES / "vibration.toml", vibration={"steps": 4, "amplitudes": ["1 um", "2 um"]})
    lines = drawn(result.plot_coefficients())
    table = result.to_dataframe("coefficients")
    first = table[(table.load_y_N == -50) & (table.amplitude_m == 1e-6)].iloc[0]
    np.testing.assert_allclose(lines["kxx, (0, -50) N"][0], [1, 1e-6 * first.kxx_N_per_m], rtol=1e-12)


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_coefficients_of_running_bearings():
    case = {"speeds": ["30000 rpm", "45000 rpm"], "loads": [["20 N", "0 N"], ["50 N", "0 N"]]}
    result = bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=case)
    ax = result.plot_coefficients()
    table = result.to_dataframe("coefficients")
    fast = table[(table.load_x_N == 50) & (table.speed_rad_per_s > 4000)].iloc[0]
    line = drawn(ax)["kyy, (50, 0) N"]
    np.testing.assert_allclose(line[1], [45000, 1e-6 * fast.kyy_stuck_N_per_m], rtol=1e-12)
    assert ax.get_xlabel() == "speed (rpm)"
    # Over the frequency where there are several, which case files may have in any order.
    several = {"loads": [["20 N", "0 N"]], "frequencies": ["500 Hz", "100 Hz"]}
    line = drawn(bumpfoil.run_equilibrium(EXAMPLES / "running.toml", equilibrium=several).plot_coefficients())["kxx"]
    np.testing.assert_allclose(line[:, 0], [100, 500], rtol=1e-12)
    # Of positions without loads over the displacement.
    words = (EXAMPLES / "running.toml").read_text(encoding="utf-8")
    words = re.sub(r"^loads = .*$", 'positions = [["5 um", "0 um"], ["8 um", "6 um"]]', words, flags=re.MULTILINE)
    words = words.replace('path = "load_ramp"', 'path = "position_ray"')
    ax = bumpfoil.run_equilibrium(words).plot_coefficients()
    np.testing.assert_allclose(drawn(ax)["kxx"][:, 0], [5, 10], rtol=1e-12)
    assert ax.get_xlabel() == "displacement (µm)"


def test_drawn_on_given_axes(result):
    import matplotlib.pyplot as plt

    ax = plt.subplots()[1]
    assert result.plot_loops(ax=ax) is ax
