"""A running bearing whose rotor is the user's goes where the program takes the same rotor."""

import copy

import numpy as np
import pytest

import bumpfoil
from conftest import EXAMPLES

ROTOR = EXAMPLES / "rotor.toml"
COARSE = {"film": {"columns_per_pitch": 4, "rows": 4}}
SPEED = -1000.0
LOAD = (0.0, -9.81)


@pytest.fixture(scope="module")
def begun():
    return bumpfoil.RunningStepper(ROTOR, speed=SPEED, load=LOAD, **COARSE)


@pytest.fixture
def bearing(begun):
    return begun.copy()


def test_it_begins_in_equilibrium(bearing):
    state = bearing.state
    assert state.converged and state.time == 0 and state.speed == SPEED
    np.testing.assert_allclose(state.force, LOAD, atol=1e-6)
    (found,) = bumpfoil.run_equilibrium(
        ROTOR, equilibrium={"speeds": [SPEED], "loads": [list(LOAD)], "paths": "one"}, **COARSE
    ).data["x"]
    assert state.position[0] == pytest.approx(found, rel=1e-9)
    assert state.film_thickness == state.fields["film_thickness"].min() > 0
    assert state.fields["pressure"].max() > 101325
    assert state.fields["bump_load"].sum() > 5
    assert state.power > 0


def test_the_tangent_is_the_derivative_of_a_step(bearing):
    bearing.advance(50e-6, position=bearing.state.position + [2e-7, 1e-7])
    start = bearing.state
    place, h = start.position + [1e-7, -2e-7], 1e-10

    def force(position):
        bearing.state = start
        return bearing.advance(40e-6, position=position).force

    found = np.column_stack([(force(place + h * e) - force(place - h * e)) / (2 * h) for e in np.eye(2)])
    force(place)
    # Central differences of so small steps: rounding of the force, 1e-9 N, over 2e-10 m.
    np.testing.assert_allclose(bearing.tangent(), found, rtol=1e-3, atol=1e-4 * np.abs(found).max())


def test_a_rotor_of_the_user_moves_as_that_of_the_program():
    """A mass that is kicked, by the same formula of BDF2, from the same equilibrium."""
    mass, steps, duration = 1.0, 60, 2e-3
    dt = 2 * np.pi / abs(SPEED) / 40
    theirs = bumpfoil.run_transient(
        ROTOR,
        rotor={"mass": 2 * mass, "unbalance": []},
        transient={
            "speed": {"to": SPEED, "time": steps * dt},
            "steps_per_revolution": 40,
            "pulse": {"force": [6.0, -4.0], "begin": 0.0, "duration": duration},
        },
        **COARSE,
    ).data
    bearing = bumpfoil.RunningStepper(ROTOR, speed=SPEED, load=LOAD, equilibrium={"path": "cold_start", "speeds": [SPEED], "loads": [LOAD]}, **COARSE)
    place, velocity = bearing.state.position, np.zeros(2)
    before, velocity_before, ours = place, velocity, [place]
    for step in range(1, steps + 1):
        time = step * dt
        kick = np.sin(np.pi * time / duration) * np.array([3.0, -2.0]) if time <= duration else np.zeros(2)
        span, now = (dt, 1.0) if step == 1 else (2 * dt / 3, 4 / 3)
        start, trial = bearing.state, place
        for iteration in range(20):
            bearing.state = start
            force = bearing.advance(dt, position=trial).force
            rate = (trial - now * place - (1 - now) * before) / span
            residual = mass * (rate - now * velocity - (1 - now) * velocity_before) / span + force - LOAD - kick
            if np.abs(residual).max() < 1e-7:
                break
            trial = trial - np.linalg.solve(mass / span**2 * np.eye(2) + bearing.tangent(), residual)
        assert iteration < 10  # the tangent is that of the step
        before, velocity_before, place, velocity = place, velocity, trial, rate
        ours.append(place)
    found = np.column_stack([theirs["x"][:, 0], theirs["y"][:, 0]])
    assert np.ptp(found, axis=0).min() > 1e-6
    # The searches for equilibrium leave friction in states 16 nm apart, which changes the stiffness by a thousandth; the
    # steps end at changes of 1e-6 of the clearance. Implicit Euler would end 400 nm away.
    np.testing.assert_allclose(np.array(ours) - ours[0], found - found[0], rtol=0, atol=1e-8)


def test_states_are_gone_back_to_and_copied(bearing):
    begin = bearing.state
    other = copy.copy(bearing)
    places = begin.position + 2e-7 * np.column_stack([np.sin(np.arange(4.0)), np.cos(np.arange(4.0))])
    forth = [bearing.advance(50e-6, position=place).force for place in places]
    bearing.state = begin
    again = [bearing.advance(50e-6, position=place).force for place in places]
    np.testing.assert_array_equal(forth, again)
    np.testing.assert_array_equal(forth[0], other.advance(50e-6, position=places[0]).force)


def test_it_is_led_by_a_load_and_a_speed(bearing):
    state = bearing.advance(1e-4, load=(1.0, -12.0), speed=1.02 * SPEED)
    np.testing.assert_allclose(state.force, (1.0, -12.0), atol=1e-6)
    assert state.speed == 1.02 * SPEED and state.time == 1e-4


def test_a_step_that_fails_leaves_the_state(bearing):
    before = bearing.state
    with pytest.warns(bumpfoil.RunWarning, match="the step failed"):
        state = bearing.advance(1e-6, position=(0.0, -1e-3))
    assert not state.converged and bearing.state is before


@pytest.mark.parametrize(
    ("dt", "held", "words"),
    [
        (1e-5, {}, "are missing"),
        (1e-5, {"position": (0, 0), "load": (0, 1)}, "are both given"),
        (0.0, {"position": (0, 0)}, "no length of a step"),
        (1e-5, {"position": (np.nan, 0)}, "not finite"),
        (1e-5, {"load": (1, np.inf)}, "not finite"),
        (1e-5, {"position": (0, 0), "speed": np.inf}, "not finite"),
    ],
)
def test_what_is_no_step_is_refused(bearing, dt, held, words):
    with pytest.raises(bumpfoil.CaseError, match=words):
        bearing.advance(dt, **held)
