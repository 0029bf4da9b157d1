"""A hundred bearings whose bump heights scatter by 10 um: scatter of force and clearance."""

import bumpfoil
import matplotlib.pyplot as plt

case = bumpfoil.Case(
    bumpfoil.template("gen1"),
    solver={"name": "events"},
    cycle={"directions": ["+X"], "steps": 50},
    montecarlo={"samples": 100, "seed": 1, "bump_height": {"distribution": "normal", "std": "10 um"}},
)
bearings = bumpfoil.run_montecarlo(case).to_xarray().isel(direction=0)
nominal = bumpfoil.run_cycle(case).cycles[0]

quantities = {"max_force": ("maximum force", 1, "N"), "clearance_10N": ("clearance at 10 N", 1e6, "µm")}
axes = plt.subplots(1, 2, layout="constrained", figsize=(8, 4))[1]
for (name, (words, size, unit)), ax in zip(quantities.items(), axes):
    values = size * bearings[name]
    perfect = size * nominal.quantities[name]
    print(f"{words}: {perfect:.4g} {unit} without scatter; mean {values.mean():.4g}, std {values.std(ddof=1):.3g} {unit}")
    ax.hist(values, bins=15, color="0.7", edgecolor="black")
    ax.axvline(perfect, linestyle="--", color="black")
    ax.set(xlabel=f"{words} ({unit})", ylabel="bearings")
axes[0].figure.savefig("tolerance_study.svg")
