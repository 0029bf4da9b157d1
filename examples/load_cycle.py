"""A downward load of 400 N is applied to the journal and removed. The journal is free to move sideways."""

import bumpfoil
import matplotlib.pyplot as plt

bearing = bumpfoil.Case(bumpfoil.template("gen1")).to_dict()
bearing["cycle"] = {"directions": ["-Y"], "load": "400 N", "steps": 50}
cycle = bumpfoil.run_cycle(bearing).cycles[0]

for increment in range(0, len(cycle.x), 25):
    load, x, y = cycle.force_direct[increment], cycle.x[increment], cycle.y[increment]
    print(f"{load:.1f} N: {1e6 * x:.3f} um, {1e6 * y:.3f} um")
print(f"loop {1e3 * cycle.loop_energy:.4g} mJ, loss factor {cycle.loss_factor:.4g}")

axes = plt.subplots(layout="constrained")[1]
axes.plot(1e6 * cycle.x, 1e6 * cycle.y)
axes.set(xlabel="x (µm)", ylabel="y (µm)", title="way of the journal under 0 to 400 N and back")
axes.figure.savefig("load_cycle.svg")
