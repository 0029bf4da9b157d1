"""Names, units and meanings of what result files hold: variables have their own, those of columns and keys follow from their names."""

import re

SUFFIXES = {
    "_N_m_s_per_rad": "N m s/rad",
    "_N_m_per_rad": "N m/rad",
    "_N_s_per_rad": "N s/rad",
    "_N_per_rad": "N/rad",
    "_N_s_per_m": "N s/m",
    "_m3_per_s": "m3/s",
    "_rad_per_s": "rad/s",
    "_N_per_m": "N/m",
    "_kg": "kg",
    "_N_m": "N m",
    "_N_s": "N s",
    "_deg": "degree",
    "_rad": "rad",
    "_Pa": "Pa",
    "_N": "N",
    "_m": "m",
    "_J": "J",
    "_s": "s",
    "_W": "W",
}

# Keys whose values have keys of their own names: those of the case, its files, its quantities.
NAMED_BY_RUNS = {
    "case": ("table",),
    "files": ("file",),
    "statistics": ("direction", "quantity"),
    "bump_loads": ("direction",),
    "sensitivities": ("direction", "quantity", "tolerance"),
    "points[].values": ("key",),
}
LISTED_ELSEWHERE = ("case", "points[].cycles[]", "states[].last_state", "points[].states[].last_state")
# What no variable of the same name says.
MEANINGS = {
    "schema": "name and version of the format",
    "xxh3_128": "checksum of this file, with 32 zeros in its place",
    "command": "command of the program",
    "version": "version of the program",
    "commit": "commit of the sources that the program was built from",
    "solver": "solver of the contact problem",
    "status": "`complete`, `failed` or `interrupted`",
    "run_id": "32 hexadecimal digits, new for every run and the same in all its files",
    "files": "the files beside this one, by their names",
    "files.<file>.bytes": "size",
    "files.<file>.xxh3_128": "checksum, as `xxhsum -H2` prints it",
    "case": "keys of the case file by their tables, with all options applied, SI",
    "warnings": "choices of the program that the case leaves open, and results outside the validity range of the model, with advice",
    "reason": "what happened, in words; null if nothing failed",
    "cycles": "one object per direction; of a strip per cycle, of a path one alone",
    "cycles[].failed_increment": "number of the increment that failed; null if none did",
    "cycles[].failed_displacement_m": "displacement that this increment should have reached",
    "cycles[].max_stress_top_foil_at": "where and when the largest stress of the top foil acts",
    "cycles[].max_stress_bump_foil_at": "where and when the largest stress of the bump foil acts",
    "place": "`weld`, `crest`, `foot`, or `arc` between crest and foot",
    "cycles[].max_stress_top_foil_at.bump": "bump, counted through all pads; null at the weld",
    "cycles[].max_stress_bump_foil_at.bump": "bump, counted through all pads; null at the weld",
    "cycles[].loop_energies_J": "loop energies of all cycles; the last is shown",
    "cycles[].clearances": "where the direct force first reaches each of the forces of `cycle.clearance_forces`",
    "clearance_5N_m": "displacement at which the direct force first reaches 5 N; a key for each of these forces",
    "clearance_10N_m": "the same for 10 N",
    "cycles[].clearances[].force_N": "the force",
    "cycles[].clearances[].displacement_m": "the displacement; null if it is never reached",
    "cycles[].orbits": "one object per orbit",
    "cycles[].orbits[].energy_J": "closed integral of force over displacement",
    "cycles[].orbits[].force_defect_N": "difference of the forces at both ends",
    "cycles[].orbits[].position_defect_m": "distance of the positions at both ends",
    "loads": "one object per static load",
    "loads[].status": "how the ramp to the static load ended",
    "loads[].pad_forces_x_N": "part of the static load along X carried by each pad",
    "loads[].pad_forces_y_N": "part of the static load along Y carried by each pad",
    "states[].pad_forces_x_N": "part of the force along X carried by the film of each pad",
    "states[].pad_forces_y_N": "part of the force along Y carried by the film of each pad",
    "loads[].stuck": "tangent of the static load, full stick",
    "loads[].further": "tangent of the static load, sliding contacts keep sliding",
    "vibrations": "one object per load, direction (of orbits sense) and amplitude",
    "vibrations[].loop_energies_J": "energies of all loops; the last is shown",
    "coefficients": "one object per load, amplitude and frequency",
    "states": "one object per state",
    "states[].name": "path, where the state was reached from, speed, and load or position",
    "states[].motions": "one object per frequency of small motions, with stiffness and damping there",
    "states[].last_state": "for a state that was not found: all quantities of the last state found on its path, with its speed and clearance",
    "spreads": "per speed and load that several paths led to, the minimum and maximum of every quantity",
    "limits": "one object per limit",
    "limits[].kind": "`lift_off_speed` or `load_capacity`",
    "limits[].status": "how the search for the limit ended",
    "limits[].load_N": "load capacity",
    "limits[].speed_rad_per_s": "lift-off speed",
    "limits[].bounded_by": "criterion that states beyond the limit violate: `film_thickness`, `stability` or `end_of_path`",
    "limits[].stable": "whether the state `thick` is stable with the journal held",
    "limits[].thick": "last state on the path that is stable with a film of `film.h_lift_off` or more",
    "limits[].thin": "its neighbour beyond the limit",
    "limits[].unstable": "one object per range of states on the path that are unstable with the journal held",
    "limits[].unstable[].from_load_N": "smallest load of the range",
    "limits[].unstable[].to_load_N": "largest load of the range",
    "limits[].unstable[].from_speed_rad_per_s": "lowest speed of the range",
    "limits[].unstable[].to_speed_rad_per_s": "highest speed of the range",
    "limits[].unknown": "states on the path whose stability is not known; they count as stable",
    "swept_command": "command that was run at every point",
    "sampled_command": "command that was run for each bearing",
    "axes": "one object per swept key",
    "axes[].key": "key of the case file",
    "axes[].name": "the same with underscores, the name in `sweep.nc`",
    "axes[].title": "title of the key",
    "axes[].unit": "unit of `values`",
    "axes[].values": "the values, SI",
    "axes[].written": "the values as written on the command line",
    "points": "one object per combination, the last key fastest",
    "points[].status": "`complete`, `failed` or `interrupted`",
    "points[].values": "values of the swept keys",
    "points[].cycles": "as `cycles` of the command, without the loads of single bumps and feet",
    "seed": "seed of the ensemble",
    "samples_due": "requested samples",
    "samples": "available samples",
    "statistics": "by direction and quantity",
    "count": "samples in which it is defined",
    "undefined": "samples in which it is not defined",
    "mean": "mean",
    "std": "standard deviation",
    "standard_error": "standard error of the mean",
    "mean_interval_95": "95 % interval of the mean",
    **{f"p{percent}": f"{percent} % percentile" for percent in (1, 5, 25, 50, 75, 95, 99)},
    "bump_loads": "by direction, of the load of each bump at full displacement",
    "bump_loads.<direction>.mean_N": "mean",
    "bump_loads.<direction>.std_N": "standard deviation",
    "sensitivities": "by direction, quantity and tolerance partial rank correlations",
    "yield": "of all limits together",
    "limit": "the limit as given",
    "interval_95": "Wilson's 95 % interval of the fraction that passes",
    "frequency_rad_per_s": "frequency of small motions",
    "passed": "samples that meet it",
    "failed": "every cycle that did not converge",
    "failures": "what failed, and why: one sentence each",
    "end_status": "how the march ended",
    "revolutions": "whole revolutions of the rotor",
    "energy": "terms of the energy balance of all whole revolutions",
    "energy.entrained_J": "work of the turning journals on the gas that they drag along",
    "energy.supplied_J": "work of gas that enters at edges above ambient pressure",
    "energy.forces_J": "work of weight, unbalance, pulses and base on the rotor",
    "energy.rubbing_J": "work of the friction of asperities on the motion of the rotor",
    "energy.dissipated_J": "dissipated by the flow of the films under pressure gradients",
    "energy.friction_J": "dissipated by friction of the foils",
    "energy.damping_J": "dissipated by the damping of the rotor",
    "energy.stored_J": "change of the kinetic energy and of the energy stored in films, foils and asperities",
    "energy.defect_J": "sum of the magnitudes of the defects of single revolutions",
    "rubs": "one object per interval in which asperities of a bearing carry more than a hundredth of the weight on it",
    "rubs[].bearing": "bearing, from 1",
    "rubs[].begin_s": "start",
    "rubs[].end_s": "end",
    "rubs[].asperity_load_N": "maximum load on the asperities",
    "onsets": "speeds at which a motion starts or stops to grow",
    "onsets[].contacts": "`sliding`: slipping contacts keep sliding; `stuck`: full stick",
    "onsets[].by_coefficients": "according to synchronous coefficients",
    "onsets[].begins": "the motion grows at higher speeds",
    "onsets[].jumps": "the growth rate jumps across zero there, for example where contacts change",
    "onsets[].whirl_ratio": "frequency of the whirl over the speed of rotation",
    "speeds": "one object per speed",
    "speeds[].status": "how the search for the equilibrium ended",
    "speeds[].motions": "the motions found there",
    "speeds[].motions[].mode": "number of the motion, the same from speed to speed",
    "speeds[].motions[].contacts": "`sliding` or `stuck`",
    "speeds[].responses": "one object per kind and station",
    "speeds[].responses[].kind": "`linear_sliding`, `linear_stuck` or `orbit`",
    "speeds[].responses[].station": "name of the station on the rotor",
    "stations": "names of the stations on the rotor, bearings first",
    "peaks": "speeds at which the largest orbit of all stations has a maximum",
    "peaks[].kind": "`linear_sliding`, `linear_stuck` or `orbit`",
    "peaks[].station": "station with the largest orbit",
    "reduction_error": "largest error of a natural frequency of the reduced shaft in the range of interest",
    "station": "name of the station on the rotor",
    "parameters": "one object per fitted parameter",
    "parameters[].key": "key of the case file",
    "parameters[].unit": "its SI unit; 1 of a plain number",
    "parameters[].start": "given start",
    "parameters[].correlations": "with all parameters, in their order; null where it is not known",
    "parameters[].profile": "best minima with the parameter held, on request",
    "data": "one object per measured loop or table",
    "data[].experiment": "experiment: `cycle`, `strip`, `vibration` or `equilibrium`",
    "data[].points": "number of measured values; of a loop, parts of equal arc length in which it has readings",
    "data[].axis": "abscissa of its curves",
    "data[].axis_unit": "its SI unit",
    "data[].series": "names of its curves",
    "data[].quantities": "measured quantities",
    "data[].quantities[].title": "title for display",
    "data[].quantities[].unit": "its SI unit; 1 of a plain number",
    "series": "curve that the value belongs to",
    "quantity": "measured quantity",
    "unit": "SI unit of the quantity; 1 of a plain number",
    "axis": "abscissa of the curve",
    "axis_unit": "its SI unit",
    "ended_by": "how the optimisation ended",
    "optimised_command": "command that was run at every point",
    "point_count": "points that were evaluated",
    "keys": "one object per optimised key",
    "keys[].key": "key of the case file",
    "keys[].unit": "its SI unit; 1 of a plain number",
    "keys[].start": "value that the first search starts from",
    "keys[].active_bound": "`lower` or `upper` where the best value lies at a bound",
    "aims": "one object per aim",
    "aims[].quantity": "quantity of the result",
    "aims[].unit": "its SI unit",
    "aims[].maximise": "whether it is maximised; otherwise minimised",
    "aims[].best_value": "at the best point",
    "limits[].quantity": "quantity of the result",
    "limits[].unit": "its SI unit",
    "limits[].bound": "of the quantity",
    "limits[].value": "of the quantity at the best point",
    "limits[].margin": "of the best point to the bound",
    "friction_coefficient": "value of the key; a column per key",
    "loss_factor": "value of the first aim; a column per aim, by its quantity",
    "max_force_N": "the same of the second",
    "limit_1_max_force_N": "value of the quantity of the first limit; a column per limit",
    "limits[].active": "whether the limit is met by less than 1 % of its bound",
    "front": "numbers of the points of the front, from the best of the first aim on",
    "searches": "one object per search",
    "searches[].aim": "quantity that it optimised",
    "searches[].evaluations": "points that it evaluated",
    "searches[].ended_by": "`tolerance`, `evaluations` or `round-off`",
    "minima": "minima that are nearly as deep as the best, which is the first",
    "minima[].fitted_values": "of the parameters, in their order",
}


def parted(name):
    """Name and unit of a column or key."""
    for suffix, unit in SUFFIXES.items():
        if name.endswith(suffix):
            return name[: -len(suffix)], unit
    return name, ""


def meanings_of(dataset):
    return {name: dataset[name].attrs["long_name"] for name in dataset.variables}


def rows_of_variables(dataset):
    for name in [*dataset.coords, *dataset.data_vars]:
        attributes = dataset[name].attrs
        meaning = attributes["long_name"].replace("|", "\\|")
        if "flag_meanings" in attributes:
            pairs = zip(attributes["flag_values"], attributes["flag_meanings"].split())
            meaning += ": " + ", ".join(f"{value} `{word}`" for value, word in pairs)
        yield f"`{name}`", ", ".join(dataset[name].dims), attributes.get("units", ""), meaning


def told(name, meanings):
    """The first one that is known."""
    found = next((meaning for meaning in meanings if meaning), None)
    if not found:
        raise LookupError(f"{name}: no variable of this name says what it means, and MEANINGS does not either")
    return found


def at_frequency(name, meanings):
    """What a coefficient of small motions means, which those of all frequencies say, or the one at whirl_frequency."""
    ways = (re.sub("^([kc][xyab]{2})", rf"\1_{way}", name) for way in ("at_frequency", "whirl"))
    found = next((meanings[way] for way in ways if way in meanings), "")
    return found.replace("whirl_frequency", "the frequency")


def rows_of_columns(columns, meanings):
    of_motions = "frequency_rad_per_s" in columns
    for column in columns:
        name, unit = parted(column)
        of_row = f"increment_{name}" if "increment" in columns else name  # a cycle has a status, too
        ways = [meanings.get(way) for way in (of_row, name, f"total_{name}")]
        here = at_frequency(name, meanings) if of_motions else ""
        yield f"`{column}`", unit, told(column, [here, *ways, MEANINGS.get(column)])


def keys_in(value, path="", named=()):
    """Paths of all keys, and their names; `[]` stands for each of a list, <words> for what is called as the run is."""
    if isinstance(value, list):
        for inner in value:
            yield from keys_in(inner, f"{path}[]")
    elif isinstance(value, dict) and path not in LISTED_ELSEWHERE:
        for key, inner in value.items():
            further = f"{path}.<{named[0]}>" if named else f"{path}.{key}".lstrip(".")
            if not named:
                yield further, key
            yield from keys_in(inner, further, named[1:] if named else NAMED_BY_RUNS.get(further, ()))


def rows_of_keys(summary, meanings):
    for path, key in dict(keys_in(summary)).items():
        name, unit = parted(key)
        own = MEANINGS.get(path) or MEANINGS.get(path.removeprefix("points[]."))
        if "motions[]." in path:
            own = own or at_frequency(name, meanings)
        yield f"`{path}`", unit, told(path, [own, meanings.get(name), meanings.get(f"total_{name}"), MEANINGS.get(key)])
