"""Figures for print: what a reviewer would send back is not there."""

import itertools

import matplotlib
import numpy as np
import pytest

matplotlib.use("agg")

import bumpfoil  # noqa: E402
from bumpfoil import figures  # noqa: E402
from conftest import COARSE, EXAMPLES  # noqa: E402
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.text import Text  # noqa: E402

MM = 1 / 25.4


def texts(figure):
    return [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]


def hidden(figure):
    """Labels of ticks beyond the limits of an axis, which are not drawn."""
    for ax in figure.axes:
        for axis, along in ((ax.xaxis, 0), (ax.yaxis, 1)):
            low, high = sorted(axis.get_view_interval())
            for label in axis.get_ticklabels():
                if not low - 1e-9 <= label.get_position()[along] <= high + 1e-9:
                    yield label


def inspect(figure, *, width, panels):
    """Size, type, letters, and that nothing lies on or outside of anything else."""
    FigureCanvasAgg(figure).draw()
    assert figure.get_size_inches()[0] == pytest.approx(width * MM)
    assert figure.get_size_inches()[1] <= 220.01 * MM  # a page of 234 mm with a caption of three lines
    assert len(figure.axes) == panels
    beyond = set(hidden(figure))
    drawn = {text: text.get_window_extent() for text in texts(figure) if text not in beyond}
    assert min(text.get_fontsize() for text in drawn) >= 7
    page = figure.bbox.padded(0.5)
    for text, box in drawn.items():
        assert page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1, text
        assert "-" not in text.get_text().replace("mid-surface", "")  # a minus is one
    if panels > 1:
        letters = [text.get_text() for text in drawn if text.get_text().startswith("(") and len(text.get_text()) == 3]
        assert letters == [f"({chr(ord('a') + i)})" for i in range(panels)]
    for ax in figure.axes:
        own = set(ax.findobj(Text))
        for one, other in itertools.combinations([text for text in drawn if text in own], 2):
            assert not drawn[one].overlaps(drawn[other]), (one, other)
    # Of a panel all that belongs to it: labels, ticks, titles.
    boxes = [ax.get_tightbbox(figure.canvas.get_renderer()) for ax in figure.axes]
    boxes += [legend.get_window_extent() for legend in figure.legends]
    for one, other in itertools.combinations(boxes, 2):
        overlap = min(one.x1, other.x1) - max(one.x0, other.x0), min(one.y1, other.y1) - max(one.y0, other.y0)
        assert min(overlap) < 1, (one, other)
    for ax in figure.axes:
        assert ax.get_xlabel() and ax.get_ylabel()
        assert ax.get_legend() is None
    assert len(figure.legends) <= 1


def grey(colour):
    return np.dot(matplotlib.colors.to_rgb(colour), (0.299, 0.587, 0.114))


@pytest.fixture(scope="module")
def result():
    return bumpfoil.run_cycle(EXAMPLES / "measured.toml", cycle={"steps": 20, "directions": ["+X", "-X", "+Y", "-Y"]})


@pytest.mark.parametrize("width, size", [("single", 90), ("double", 190)])
def test_results_of_cycles(result, width, size):
    inspect(figures.loops(result, width=width), width=size, panels=1 if width == "single" else 4)
    inspect(figures.bump_loads(result, width=width), width=size, panels=4)
    inspect(figures.foils(result.cycles[0], width=width), width=size, panels=3)
    inspect(figures.contacts(result.cycles[0], width=width), width=size, panels=3)


def test_pads():
    pads = bumpfoil.run_cycle(EXAMPLES / "three_pads.toml", cycle={"steps": 10, "directions": ["+X"]})
    inspect(figures.bump_loads(pads), width=90, panels=1)
    inspect(figures.contacts(pads.cycles[0]), width=190, panels=3)
    figure = figures.foils(pads.cycles[0])
    inspect(figure, width=190, panels=3)
    for ax in figure.axes:
        assert [text.get_text() for text in ax.get_xticklabels()][::3] == ["1.1", "2.1", "3.1"]
        for label in ("journal", "top foil"):
            (line,) = [line for line in ax.lines if line.get_label() == label]
            assert np.flatnonzero(np.isnan(line.get_ydata())).tolist() == [8, 17]


def test_show_what_results_hold(result):
    cycle = result.cycles[2]
    (line,) = [line for line in figures.loops(result).axes[0].lines if line.get_label() == "+Y"]
    np.testing.assert_array_equal(line.get_xydata(), np.column_stack([1e6 * cycle.displacement, cycle.force_direct]))
    ax = figures.foils(cycle, [20]).axes[0]
    journal = {line.get_label(): line.get_ydata() for line in ax.lines}["journal"]
    clearance = bumpfoil.check(EXAMPLES / "measured.toml").to_dict()["bearing"]["radial_clearance"]
    # Pushed to +Y the journal comes nearest where the foils look at it, as far as it was moved.
    np.testing.assert_allclose(journal.min(), 1e6 * (clearance - cycle.displacement[20]), atol=1.0)
    bars = [patch.get_y() + patch.get_height() for patch in ax.patches]
    np.testing.assert_allclose(np.subtract(journal, bars), 1e6 * (cycle.gap_journal_top + cycle.gap_top_bump)[20], atol=1e-9)


def test_means_read_in_grey():
    cycle = {"steps": 5, "directions": ["+X", "-X", "+Y", "-Y"]}
    ensemble = bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=8, cycle=cycle)
    figure = figures.ensemble(ensemble)
    marks = figure.axes[0].lines
    np.testing.assert_allclose([mark.get_xdata()[0] for mark in marks], ensemble.to_xarray().max_force.mean("sample"))
    (legend,) = figure.legends
    assert [mark.get_marker() for mark in marks] == [line.get_marker() for line in legend.get_lines()[:4]]
    assert len({mark.get_marker() for mark in marks}) == 4


def test_read_in_grey(result):
    states = [grey(patch.get_facecolor()[:3]) for patch in figures.contacts(result.cycles[0]).legends[0].get_patches()]
    assert min(abs(one - other) for one, other in itertools.combinations(states, 2)) > 0.1
    lines = figures.loops(result).axes[0].lines
    assert len({str(line._dash_pattern) for line in lines}) == len(lines) == 4


# Computed once for both widths.
@pytest.fixture(scope="module")
def ensemble():
    return bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", montecarlo={"samples": 8}, cycle={"steps": 10})


@pytest.fixture(scope="module")
def vibration():
    return bumpfoil.run_vibration(EXAMPLES / "vibration.toml", vibration={"steps": 4, "amplitudes": ["1 um", "2 um"]})


@pytest.fixture(scope="module")
def running():
    return bumpfoil.run_equilibrium(EXAMPLES / "running.toml", film=COARSE)


@pytest.fixture(scope="module")
def many():
    states = {"speeds": ["20000 rpm", "30000 rpm", "45000 rpm", "60000 rpm"], "loads": [["10 N", 0], ["20 N", 0]],
              "frequencies": ["200 Hz", "1000 Hz"]}
    return bumpfoil.run_equilibrium(EXAMPLES / "running.toml", film=COARSE, equilibrium=states)


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
@pytest.mark.parametrize("width, size", [("single", 90), ("double", 190)])
def test_ensembles_and_coefficients(ensemble, vibration, running, width, size):
    figure = figures.ensemble(ensemble, width=width)
    inspect(figure, width=size, panels=4)
    assert [text.get_text() for text in figure.legends[0].get_texts()][-1] == "mark: mean"
    assert sum(patch.get_path().vertices.size > 0 for ax in figure.axes for patch in ax.patches) == 4
    inspect(figures.coefficients(vibration, width=width), width=size, panels=4)
    for contacts in ("stuck", "slipping"):
        figure = figures.coefficients(running, width=width, contacts=contacts)
        inspect(figure, width=size, panels=4)
        assert {ax.get_xlabel() for ax in figure.axes} == {"load (N)"}


@pytest.mark.filterwarnings("ignore::bumpfoil.RunWarning")
def test_fitted_loops_and_vibrations():
    true = {"friction": {"coefficient": 0.2}, "solver": {"name": "events"}}
    cycle = {"steps": 40, "directions": ["+X"]}
    motion = {"loads": [[0, -50]], "directions": ["+Y"], "amplitudes": ["1 um", "2 um"], "frequencies": ["1 Hz"], "steps": 4}
    truth = bumpfoil.run_cycle(EXAMPLES / "gen1.toml", cycle=cycle, **true).cycles[0]
    loop = {"displacements": truth.displacement, "forces": truth.force_direct}
    shaken = bumpfoil.run_vibration(EXAMPLES / "gen1.toml", vibration=motion, **true).to_dataframe()
    columns = {"amplitude": shaken.amplitude_m, "direction": np.radians(shaken.direction_deg), "load_y": shaken.load_y_N}
    measured = {"stiffness": shaken.loaded_stiffness_N_per_m, "loss_factor": shaken.loss_factor}
    table = {"experiment": "vibration", "readings": columns | measured, "stiffness_std": "0.1 MN/m", "loss_factor_std": 0.01}
    friction = {"friction.coefficient": {"start": 0.1, "lower": 0.0, "upper": 0.5}}
    result = bumpfoil.fit(EXAMPLES / "gen1.toml", data=[loop, table], parameters=friction, fit={"starts": 1}, vibration=motion, **true)
    (found,) = result.summary["parameters"]
    assert found["fitted_value"] == pytest.approx(0.2, abs=1e-4)
    assert [one["experiment"] for one in result.summary["data"]] == ["cycle", "vibration"]
    figure = figures.fitted(result)
    inspect(figure, width=190, panels=6)
    lines = {line.get_label(): line.get_xydata() for line in figure.axes[0].lines}
    assert len(lines["measured, push"]) + len(lines["measured, pull"]) == np.isfinite(result.data["measured_value"][0]).sum()
    stiffness = figure.axes[2].lines[0].get_xydata()
    np.testing.assert_allclose(stiffness, np.column_stack([1e6 * shaken.amplitude_m, 1e-6 * shaken.loaded_stiffness_N_per_m]))
    assert figure.axes[2].get_ylabel() == "stiffness (MN/m)" and figure.axes[4].get_ylabel() == "loss factor"
    with pytest.raises(ValueError, match="fitted data"):
        figures.fitted(bumpfoil.run_cycle(EXAMPLES / "gen1.toml", cycle={"steps": 2}))


@pytest.mark.parametrize("width, size", [("single", 90), ("double", 190)])
def test_points_of_optimisations(width, size):
    choice = {"command": "cycle", "minimise": "max_force", "evaluations": 30, "tolerance": 0.05, "starts": 1}
    keys = {"friction.coefficient": {"lower": 0.05, "upper": 0.3}, "bearing.radial_clearance": {"lower": "25 um", "upper": "35 um"}}
    cycle = {"steps": 5, "directions": ["+X"]}
    result = bumpfoil.optimise(EXAMPLES / "gen1.toml", keys=keys, optimise={**choice, "limits": ["loss_factor > 0.13"]}, cycle=cycle)
    figure = figures.optimised(result, width=width)
    inspect(figure, width=size, panels=2)
    points = result.to_dataframe()
    for ax, column, factor in zip(figure.axes, ("friction_coefficient", "bearing_radial_clearance_m"), (1, 1e6)):
        drawn = {line.get_label(): line.get_xydata() for line in ax.lines}
        place = factor * points[column].to_numpy()
        for label, shown in (("meets all limits", points.feasible), ("misses a limit", ~points.feasible)):
            assert shown.any()
            np.testing.assert_allclose(drawn[label], np.column_stack([place, points.max_force_N])[shown])
        best = points.iloc[result.summary["best_point"]]
        np.testing.assert_allclose(drawn["best"], [[factor * best[column], best.max_force_N]])
    assert figure.axes[1].get_xlabel() == "bearing.radial_clearance (µm)" and figure.axes[0].get_ylabel() == "max_force (N)"

    both = {**choice, "maximise": "loss_factor", "minimise": "max_force", "front": 1, "evaluations": 100}
    result = bumpfoil.optimise(EXAMPLES / "gen1.toml", keys=keys, optimise=both, cycle=cycle)
    figure = figures.optimised(result, width=width)
    inspect(figure, width=size, panels=3)
    (front,) = [line.get_xydata() for line in figure.axes[2].lines if line.get_label() == "front"]
    along = result.to_dataframe().iloc[result.summary["front"]]
    np.testing.assert_allclose(front, along[["loss_factor", "max_force_N"]])
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["meets all limits", "front", "best"]
    with pytest.raises(ValueError, match="evaluated points"):
        figures.optimised(bumpfoil.run_cycle(EXAMPLES / "gen1.toml", cycle={"steps": 2}))


def test_run_up(running):
    speeds = ["0 rpm", "300 rpm", "4000 rpm", "20000 rpm"]
    rough = bumpfoil.run_equilibrium(EXAMPLES / "running_from_rest.toml", film=COARSE, equilibrium={"speeds": speeds})
    figure = figures.run_up(rough)
    inspect(figure, width=190, panels=2)
    torque, share = ([line.get_ydata() for line in ax.lines] for ax in figure.axes)
    assert len(torque[0]) == 3  # none at rest
    assert torque[0][0] > 20 * torque[0][1]
    assert share[0][0] > 0.3 > 1e-3 > share[0][1]
    with pytest.raises(ValueError, match="no states on asperities"):
        figures.run_up(running)


def test_rotors(running):
    speeds = ["12000 rpm", "13000 rpm", "14000 rpm"]
    rotor = bumpfoil.run_stability(EXAMPLES / "rotor.toml", film=COARSE, stability={"speeds": speeds})
    for contacts in ("sliding", "stuck"):
        figure = figures.campbell(rotor, contacts=contacts)
        inspect(figure, width=190, panels=2)
        frequency, growth = figure.axes
        # Half the speed of rotation, near which the rotor whirls, is drawn as a line.
        half = frequency.lines[-1].get_ydata()
        np.testing.assert_allclose(half, [100.0, 650.0 / 6.0, 700.0 / 6.0], rtol=1e-12)
        np.testing.assert_allclose(frequency.lines[0].get_ydata(), half, rtol=0.1)
        whirl, grown = (line.get_ydata() for line in growth.lines[:2])
        assert len(whirl) == 3
        np.testing.assert_array_equal(grown, whirl[whirl > 0])
    inspect(figures.root_locus(rotor), width=90, panels=1)
    with pytest.raises(ValueError, match="no free motions"):
        figures.campbell(running)
    with pytest.raises(ValueError, match="one of stuck, sliding"):
        figures.campbell(rotor, contacts="slipping")


def test_bode(running):
    speeds = {"from": "6000 rpm", "to": "10000 rpm", "points": 5}
    response = bumpfoil.run_unbalance(EXAMPLES / "rotor.toml", film=COARSE, unbalance={"speeds": speeds})
    figure = figures.bode(response)
    inspect(figure, width=190, panels=2)
    table = response.to_dataframe()
    stuck = table[table.kind == "linear_stuck"]
    np.testing.assert_array_equal(figure.axes[0].lines[0].get_ydata(), 1e6 * stuck.amplitude_x_m)
    turns = (figure.axes[1].lines[0].get_ydata() - stuck.phase_x_deg) / 360.0
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-9)
    with pytest.raises(ValueError, match="no responses to unbalance"):
        figures.bode(running)
    with pytest.raises(ValueError, match="one of bearing 1"):
        figures.bode(response, station="fan")


def test_waterfall_and_revolutions(running):
    speed = {"speed": {"from": "12000 rpm", "to": "11000 rpm", "time": "22 ms"}, "steps_per_revolution": 30, "revolutions_per_spectrum": 2}
    run = bumpfoil.run_transient(EXAMPLES / "rotor.toml", film=COARSE, transient=speed)
    data = run.to_xarray()
    figure = figures.waterfall(run)
    inspect(figure, width=90, panels=1)
    spectra = [line for line in figure.axes[0].lines if len(line.get_xdata()) > 2]
    assert len(spectra) == data.sizes["spectrum"] == 2
    # The fastest is drawn first, and peaks at its frequency of rotation.
    first = spectra[0]
    peak = first.get_xdata()[np.argmax(first.get_ydata())]
    assert peak == pytest.approx(data["spectrum_speed"].max().item() / (2 * np.pi))
    figure = figures.revolutions(run)
    inspect(figure, width=190, panels=4)
    np.testing.assert_array_equal(
        figure.axes[0].lines[0].get_ydata(), 1e6 * data["half_peak_to_peak_x"].isel(station=0).to_numpy()
    )
    for draw in (figures.waterfall, figures.revolutions):
        with pytest.raises(ValueError, match="no revolutions"):
            draw(running)
    with pytest.raises(ValueError, match="one of x, y"):
        figures.waterfall(run, axis="z")


def test_polar_and_orbits(running):
    speeds = {"speeds": ["8000 rpm", "9000 rpm"], "orbits": True, "steps_per_revolution": 30}
    response = bumpfoil.run_unbalance(EXAMPLES / "rotor.toml", film=COARSE, unbalance=speeds)
    table = response.to_dataframe()
    figure = figures.polar(response)
    inspect(figure, width=90, panels=1)
    stuck = table[table.kind == "linear_stuck"]
    line = figure.axes[0].lines[0]
    np.testing.assert_allclose(np.hypot(line.get_xdata(), line.get_ydata()), 1e6 * stuck.amplitude_x_m)
    np.testing.assert_allclose(np.degrees(np.arctan2(line.get_ydata(), line.get_xdata())), stuck.phase_x_deg)
    figure = figures.orbits(response, speed=9000.0)
    inspect(figure, width=90, panels=1)
    (orbit,) = [line for line in figure.axes[0].lines if line.get_label() == "orbit with friction"]
    row = table[(table.kind == "orbit") & (table.speed_rad_per_s > 900.0)].iloc[0]
    # Of two harmonics; friction and film have more, and steps of 12 degrees find no end exactly.
    for numbers, axis in ((orbit.get_xdata(), "x"), (orbit.get_ydata(), "y")):
        assert np.ptp(numbers) / 2 == pytest.approx(1e6 * row[f"half_peak_to_peak_{axis}_m"], rel=0.01)
        assert np.mean(numbers[:-1]) == pytest.approx(1e6 * row[f"mean_{axis}_m"], rel=1e-6)
    largest = response.summary["largest_amplitude_speed_rad_per_s"] * 30.0 / np.pi
    assert figures.orbits(response).axes[0].get_title().endswith(f"{largest:.6g} rpm")
    for draw in (figures.polar, figures.orbits):
        with pytest.raises(ValueError, match="no responses to unbalance"):
            draw(running)


@pytest.mark.parametrize("width, size", [("single", 90), ("double", 190)])
def test_many_curves_fit_on_a_page_and_differ(many, width, size):
    figure = figures.coefficients(many, width=width)
    inspect(figure, width=size, panels=4)
    for ax in figure.axes:
        shown = {(line.get_color(), line.get_marker(), line.get_linestyle(), line.get_markerfacecolor()) for line in ax.lines}
        assert len(shown) == len(ax.lines) == 16
        assert ax.get_position().height * figure.get_size_inches()[1] > 20 * MM
    # An entry for each of two forces and eight lines, and every line looks like its entries.
    (legend,) = figure.legends
    entries = {text.get_text(): mark for text, mark in zip(legend.get_texts(), legend.get_lines())}
    assert len(entries) == 10
    line = figure.axes[0].lines[8]
    assert line.get_linestyle() == entries["Fy: yy, yx"].get_linestyle()
    first = entries["20000 rpm, (10, 0) N"]
    assert (line.get_color(), line.get_marker()) == (first.get_color(), first.get_marker())


@pytest.mark.parametrize("number, panels, narrow", [(10, 4, 4), (11, 8, 4), (12, 8, 0), (13, 12, 0), (14, 12, 0), (15, 2, 2),
                                                    (16, 10, 0)])
def test_paper(studies, number, panels, narrow):
    inspect(figures.paper(studies / f"figure{number}"), width=190, panels=panels)
    if narrow:
        inspect(figures.paper(studies / f"figure{number}", width="single"), width=90, panels=narrow)
    else:
        with pytest.raises(ValueError, match=f"figure{number} .*width=\"double\""):
            figures.paper(studies / f"figure{number}", width="single")


def test_paper_shows_its_tables(studies):
    ax = figures.paper(studies / "figure11").axes[0]
    table = np.genfromtxt(studies / "figure11/loads.csv", delimiter=",", names=True, dtype=None, encoding=None)
    rows = table[(table["run"] == "present-friction") & (table["direction_deg"] == 0)]
    np.testing.assert_allclose(ax.lines[0].get_xydata(), np.column_stack([rows["bump"], rows["bump_load_N"]]))
    with pytest.raises(bumpfoil.FileError, match="contains no figure"):
        figures.paper(studies)


def test_saved_twice_are_the_same_bytes(result, tmp_path):
    first = figures.save(figures.loops(result), tmp_path / "first.of.many")
    second = figures.save(figures.loops(result), tmp_path / "second")
    assert [path.name for path in first] == ["first.of.many.pdf", "first.of.many.svg"]
    assert [path.read_bytes() for path in first] == [path.read_bytes() for path in second]
    assert b"/FontFile2" in first[0].read_bytes() or b"/Type3" not in first[0].read_bytes()


def test_refuse_other_widths(result):
    with pytest.raises(ValueError, match="single, double"):
        figures.loops(result, width="wide")
