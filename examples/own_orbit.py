"""Your own orbit, here a figure of eight about a point below the centre: forces, and friction loss."""

import bumpfoil
import matplotlib.pyplot as plt
import numpy as np

angle = 2 * np.pi * np.arange(201) / 100  # twice round
orbit = np.column_stack([8e-6 * np.sin(angle), -45e-6 + 4e-6 * np.sin(2 * angle)])  # m
path = bumpfoil.run_path(bumpfoil.Case(bumpfoil.template("gen1")), orbit).cycles[0]

dissipated = path.dissipated_energy
for increment in (1, 101, 201):  # 0 is the assembly, at the centre of the bearing
    force = path.force_x[increment], path.force_y[increment]
    print(f"{force[0]:.2f} N, {force[1]:.2f} N, dissipated {1e6 * dissipated[increment]:.2f} uJ")

axes = plt.subplots(1, 2, layout="constrained", figsize=(8, 4))[1]
axes[0].plot(1e6 * path.x[1:], 1e6 * path.y[1:])
axes[0].set(xlabel="x (µm)", ylabel="y (µm)", title="way of the journal")
axes[1].plot(path.force_x[1:], path.force_y[1:])
axes[1].set(xlabel="x (N)", ylabel="y (N)", title="applied force")
axes[0].figure.savefig("own_orbit.svg")
