"""One bearing, four models of its bump foil: the truss, the frame with small and with large displacements, and the Le Lez
(2007) model."""

import bumpfoil
import matplotlib.pyplot as plt

models = {
    "truss": {"model": "truss"},
    "frame": {"model": "frame"},
    "frame, large displacements": {"model": "frame", "geometry": "nonlinear"},
    "Le Lez (2007)": {"model": "former"},
}
axes = plt.subplots(layout="constrained")[1]
for (name, bump_foil), line in zip(models.items(), ("-", "--", "-.", ":")):
    cycle = {"directions": ["+X"], "amplitude": "60 um", "steps": 30}
    push = bumpfoil.run_cycle(bumpfoil.template("gen1"), bump_foil=bump_foil, cycle=cycle).cycles[0]
    print(f"{name}: {push.max_force:.1f} N, loop {1e3 * push.loop_energy:.3f} mJ")
    axes.plot(1e6 * push.displacement, push.force_direct, line, label=name)
axes.set(xlabel="displacement (µm)", ylabel="force (N)")
axes.legend(frameon=False)
axes.figure.savefig("model_comparison.svg")
