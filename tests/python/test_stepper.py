"""Foils taken from state to state go where those of run_path go; states are kept, gone back to and copied."""

import copy
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import bumpfoil
from conftest import EXAMPLES

GEN1 = EXAMPLES / "gen1.toml"
ANGLE = np.linspace(0.0, 3.0, 13)
POSITIONS = np.column_stack([10e-6 * np.cos(ANGLE), -45e-6 + 5e-6 * np.sin(ANGLE)])
LOADS = np.column_stack([10 * np.cos(ANGLE), -60 + 20 * np.sin(ANGLE)])


def assert_same(state, cycle, increment):
    """The fields are the same to the last bit: gaps and loads, too, are those of the same places."""
    assert state.converged
    # The path comes to a place by a fraction of its leg, so that the place itself may differ by a rounding.
    np.testing.assert_allclose(state.force, [cycle.force_x[increment], cycle.force_y[increment]], rtol=1e-9)
    assert state.fields.keys() == cycle.fields.keys()
    for name in ("crest_u", "crest_v", "foot_u", "normal_force_top_bump", "friction_force_bump_sleeve"):
        scale = np.abs(cycle.fields[name]).max()
        np.testing.assert_allclose(state.fields[name], cycle.fields[name][increment], rtol=0, atol=1e-10 * scale)
    np.testing.assert_array_equal(state.fields["state_bump_sleeve"], cycle.state_bump_sleeve[increment])
    np.testing.assert_allclose(state.elastic_energy, cycle.elastic_energy[increment], rtol=1e-9)


def test_positions_are_those_of_a_path():
    (cycle,) = bumpfoil.run_path(GEN1, POSITIONS).cycles
    stepper = bumpfoil.Stepper(GEN1)
    assert_same(stepper.state, cycle, 0)
    for increment, position in enumerate(POSITIONS, start=1):
        state = stepper.advance(position=position)
        assert state is stepper.state
        assert_same(state, cycle, increment)
    assert stepper.state.dissipated_energy > 0


def test_loads_are_those_of_a_path():
    (cycle,) = bumpfoil.run_path(GEN1, loads=LOADS).cycles
    stepper = bumpfoil.Stepper(GEN1)
    for increment, load in enumerate(LOADS, start=1):
        state = stepper.advance(load=load)
        np.testing.assert_allclose(state.force, load, rtol=0, atol=1e-4)  # N: what load control promises
        # Two searches may end anywhere within that.
        np.testing.assert_allclose(state.position, [cycle.x[increment], cycle.y[increment]], rtol=0, atol=1e-11)


def test_states_are_gone_back_to():
    stepper = bumpfoil.Stepper(GEN1, position=(0, -40e-6))
    begin = stepper.state
    forth = [stepper.advance(position=position).force for position in POSITIONS]
    assert not np.array_equal(forth[0], stepper.state.force)
    stepper.state = begin
    again = [stepper.advance(position=position).force for position in POSITIONS]
    np.testing.assert_array_equal(forth, again)


def test_copies_go_their_own_ways_in_threads():
    stepper = bumpfoil.Stepper(GEN1)
    stepper.advance(position=(0, -45e-6))
    others = [copy.copy(stepper) for _ in range(4)]
    run = lambda other: [other.advance(position=position).force for position in POSITIONS]  # noqa: E731
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(run, others))
    np.testing.assert_array_equal(together, [run(stepper)] * 4)


def test_fields_are_views_that_cannot_be_written():
    state = bumpfoil.Stepper(GEN1, position=(0, -40e-6)).state
    assert state.fields["crest_v"].shape == (26,)
    for values in [*state.fields.values(), state.force]:
        with pytest.raises(ValueError):
            values[...] = 0
    assert not state.fields["crest_v"].flags.owndata


def test_loads_on_the_top_foil_do_work():
    """Without friction, and with all contacts closed, foils are linear: Clapeyron's theorem."""
    stepper = bumpfoil.Stepper(GEN1, friction={"coefficient": 0})
    loads = np.full(26, 2.0)
    state = stepper.advance(top_load=loads)
    assert np.all(state.fields["state_top_bump"] > 0) and np.all(state.fields["state_bump_sleeve"] > 0)
    np.testing.assert_allclose(state.elastic_energy, 0.5 * loads @ state.fields["top_displacement"], rtol=1e-9)
    np.testing.assert_array_equal(state.force, 0)  # nothing touches the journal
    # They stay until others come.
    assert stepper.advance(position=(0, 1e-6)).elastic_energy == pytest.approx(state.elastic_energy, rel=1e-12)
    assert stepper.advance(top_load=0 * loads).elastic_energy == pytest.approx(0, abs=1e-12 * state.elastic_energy)


def test_tangents_are_slopes_and_those_of_a_path():
    positions = [(0, -30e-6), (0, -45e-6), (0, -46e-6)]
    stepper = bumpfoil.Stepper(GEN1)
    for position in positions:
        stepper.advance(position=position)
    begin, (further, stuck) = stepper.state, stepper.tangents()
    rise = stepper.advance(position=(0, -46e-6 - 1e-9)).force - begin.force
    # A difference of forces of some 100 N over a nanometre: roundings are 1e-12 of them.
    np.testing.assert_allclose(rise / -1e-9, further[:, 1], rtol=0, atol=1e-5 * np.abs(further).max())
    (cycle,) = bumpfoil.run_path(GEN1, positions).cycles
    for tangent, end in ((further, ""), (stuck, "_stuck")):
        of_path = [[cycle.series[f"k{row}{column}{end}"][-1] for column in "xy"] for row in "xy"]
        np.testing.assert_allclose(tangent, of_path, rtol=0, atol=1e-9 * np.abs(tangent).max())


def test_quantities_are_converted():
    units = pytest.importorskip("pint").UnitRegistry()
    bearing, told = bumpfoil.Stepper(GEN1), bumpfoil.Stepper(GEN1)
    for number, given in (
        ({"position": (0, -40e-6)}, {"position": (0, -40) * units.um}),
        ({"position": (0, -45e-6)}, {"position": [0 * units.m, -0.045 * units.mm]}),
        ({"load": (0, -60)}, {"load": (0, -0.06) * units.kN}),
        ({"top_load": np.full(26, 2.0)}, {"top_load": np.full(26, 2000) * units.mN}),
    ):
        state, other = bearing.advance(**number), told.advance(**given)
        np.testing.assert_allclose(other.force, state.force, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(other.position, state.position, rtol=1e-9)
    begin = bumpfoil.Stepper(GEN1, position=(0, -40) * units.um, top_load=np.full(26, 2000) * units.mN).state
    np.testing.assert_array_equal(begin.force, bumpfoil.Stepper(GEN1, (0, -40e-6), np.full(26, 2.0)).state.force)
    for wrong in ({"position": (0, 1) * units.N}, {"load": (0, 1) * units.m}, {"top_load": np.full(26, 1) * units.Pa}):
        with pytest.raises(bumpfoil.CaseError, match="is not in (m|N)"):
            told.advance(**wrong)
    with pytest.raises(bumpfoil.CaseError, match="position = '0 um': is a text"):
        told.advance(position=("0 um", "-30 um"))


def test_what_cannot_be_is_told():
    stepper = bumpfoil.Stepper(GEN1)
    before = stepper.state
    with pytest.raises(bumpfoil.CaseError, match="both a position and a load"):
        stepper.advance(position=(0, 0), load=(1, 0))
    for wrong in ({"position": 0.0}, {"position": [[0, 0]]}, {"load": [1, 2, 3]}, {"top_load": np.ones((26, 1))}):
        with pytest.raises(bumpfoil.CaseError, match=r"is an array of the shape \(.*\); give (two|one)"):
            stepper.advance(**wrong)
    with pytest.raises(bumpfoil.CaseError, match="load: is zero"):
        stepper.advance(load=(0, 0))
    with pytest.raises(bumpfoil.CaseError, match="no list of 26 forces"):
        stepper.advance(top_load=[1.0])
    with pytest.warns(bumpfoil.RunWarning, match="the load is not met before") as warned:
        failed = stepper.advance(load=(1e9, 0))
    assert warned[0].filename == __file__
    assert failed.status == "load_out_of_reach" and not failed.converged and failed.fields == {}
    assert stepper.state is before
    assert np.isnan(failed.force).all()
