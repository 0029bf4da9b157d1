"""A bearing with measured bump heights, compared with the nominal one."""

from pathlib import Path

import bumpfoil
import matplotlib.pyplot as plt

cycle = {"directions": ["+X"], "steps": 50}
(measured,) = bumpfoil.run_cycle(Path(__file__).with_name("measured.toml"), cycle=cycle).cycles
(drawn,) = bumpfoil.run_cycle(bumpfoil.template("gen1"), cycle=cycle).cycles

axes = plt.subplots(1, 2, layout="constrained", figsize=(8, 4))[1]
for name, push, line in (("as drawn", drawn, "-"), ("as measured", measured, "--")):
    print(f"{name}: {push.max_force:.1f} N, first contact {1e6 * push.first_contact:.1f} um")
    axes[0].plot(1e6 * push.displacement, push.force_direct, line, label=name)
    axes[1].plot(range(1, 27), push.bump_loads, "o" + line, markersize=4, label=name)
axes[0].set(xlabel="displacement (µm)", ylabel="force (N)")
axes[0].legend(frameon=False)
axes[1].set(xlabel="bump, counted from the weld", ylabel="load at full displacement (N)")
axes[0].figure.savefig("measured_heights.svg")
