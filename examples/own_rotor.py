"""Your own rotor on a running bearing, here a mass on a magnetic damper that is switched on when it whirls."""

from pathlib import Path

import bumpfoil
import matplotlib.pyplot as plt
import numpy as np

MASS, WEIGHT = 1.0, np.array([0.0, -9.81])  # kg and N, on each of two equal bearings
UNBALANCE = 1e-6  # kg m
DAMPING = 400.0  # N s/m, of the damper
speed = 16000 * np.pi / 30  # rad/s: above the onset of whirl of this rotor without the damper
dt = 2 * np.pi / speed / 25

bearing = bumpfoil.RunningStepper(Path(__file__).with_name("rotor.toml"), speed=speed, load=WEIGHT,
                                  film={"columns_per_pitch": 4, "rows": 6})  # a coarse mesh
place, velocity = bearing.state.position, np.zeros(2)
before, velocity_before = place, velocity
orbit = [place]
for step in range(1, 751):
    damping = DAMPING if step > 375 else 0.0
    angle = speed * dt * step
    driving = WEIGHT + UNBALANCE * speed**2 * np.array([np.cos(angle), np.sin(angle)])
    # BDF2, the first step by implicit Euler, with Newton's method for the place at its end.
    span, now = (dt, 1.0) if step == 1 else (2 * dt / 3, 4 / 3)
    place_reference = now * place + (1 - now) * before
    velocity_reference = now * velocity + (1 - now) * velocity_before
    start, trial = bearing.state, place + dt * velocity
    slope = None
    for _ in range(20):
        bearing.state = start
        state = bearing.advance(dt, position=trial)
        rate = (trial - place_reference) / span
        residual = MASS * (rate - velocity_reference) / span + damping * rate + state.force - driving
        if np.abs(residual).max() < 1e-6:
            break
        if slope is None:  # once is enough for a step
            slope = (MASS / span**2 + damping / span) * np.eye(2) + bearing.tangent()
        trial = trial - np.linalg.solve(slope, residual)
    before, velocity_before, place, velocity = place, velocity, trial, rate
    orbit.append(place)

x, y = 1e6 * np.array(orbit).T
for name, part in (("without", x[200:376]), ("with", x[575:])):
    print(f"half peak-to-peak along X {name} the damper: {np.ptp(part) / 2:.2f} um")

axes = plt.subplots(layout="constrained", figsize=(7, 4))[1]
axes.plot(np.arange(len(x)) / 25, x, linewidth=0.7)
axes.set(xlabel="revolutions", ylabel="x of the journal (µm)")
axes.figure.savefig("own_rotor.svg")
