"""The effect of friction: push tests with coefficients from 0 to 0.5, on all cores."""

import bumpfoil
import matplotlib.pyplot as plt
import numpy as np

friction = np.linspace(0, 0.5, 6)
case = bumpfoil.Case(bumpfoil.template("gen1"), cycle={"directions": ["+X"], "steps": 50})
pushes = bumpfoil.run_sweep(case, {"friction.coefficient": friction}).to_xarray().isel(direction=0)

for number, coefficient in enumerate(friction):
    push = pushes.isel(friction_coefficient=number)
    print(f"{coefficient:g}: {push.loaded_stiffness / 1e6:.4g} MN/m, loss factor {push.loss_factor:.4g}")

axes = plt.subplots(2, sharex=True, layout="constrained")[1]
axes[0].plot(friction, pushes.loaded_stiffness / 1e6, "o-")
axes[0].set_ylabel("structural stiffness (MN/m)")
axes[1].plot(friction, pushes.loss_factor, "o-")
axes[1].set(xlabel="coefficient of friction", ylabel="loss factor")
axes[0].figure.savefig("sweep.svg")
