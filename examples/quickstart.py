import bumpfoil

bearing = bumpfoil.Case(bumpfoil.template("gen1")).to_dict()
bearing["friction"] = {"top_bump": 0.1, "bump_sleeve": 0.2}
for cycle in bumpfoil.run_cycle(bearing).cycles:
    print(f"{cycle.max_force:g} N, loop {1e3 * cycle.loop_energy:g} mJ")
