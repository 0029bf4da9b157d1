"""Coefficients of the foils for a rotor code, and their use: the unbalance response of a rigid rotor.

The foils are at rest, under 50 N downwards; in a running bearing they are in series with the gas film."""

import bumpfoil
import matplotlib.pyplot as plt
import numpy as np

vibration = {"loads": [["0 N", "-50 N"]], "motion": "orbit", "amplitudes": ["1 um"], "steps": 25}
case = bumpfoil.Case(bumpfoil.template("gen1"), vibration={**vibration, "frequencies": ["100 Hz"]})
(row,) = bumpfoil.run_vibration(case).to_dataframe("coefficients").itertuples()
stiffness = np.array([[row.kxx_N_per_m, row.kxy_N_per_m], [row.kyx_N_per_m, row.kyy_N_per_m]])
damping = np.array([[row.cxx_N_s_per_m, row.cxy_N_s_per_m], [row.cyx_N_s_per_m, row.cyy_N_s_per_m]])
loss = row.frequency_rad_per_s * damping  # of friction, the same at every frequency

mass, unbalance = 5.0, 5e-6  # kg on this bearing, kg m
response = []
for frequency in range(50, 501, 50):  # Hz
    speed = 2 * np.pi * frequency
    forces = unbalance * speed**2 * np.array([1, -1j])
    response.append(abs(np.linalg.solve(stiffness + 1j * loss - speed**2 * mass * np.eye(2), forces)))
    x, y = 1e6 * response[-1]
    print(f"{frequency} Hz: {x:.3f} um, {y:.3f} um")

axes = plt.subplots(layout="constrained")[1]
axes.plot(range(50, 501, 50), 1e6 * np.array(response), "o-", label=["x", "y"])
axes.set(xlabel="speed (Hz)", ylabel="amplitude (µm)", title="5 kg with 5 g mm of unbalance, on the foils alone")
axes.legend(frameon=False)
axes.figure.savefig("coefficients.svg")
