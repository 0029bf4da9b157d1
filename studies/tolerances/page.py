"""docs/studies/tolerances.md as text, from the data of ensembles.py: every number on the page comes from there."""

import textwrap

DIRECTIONS = ("+X", "-X", "+Y", "-Y")

#: How the page calls what scatters alone, how much, and what a drawing would have to hold for that.
ALONE = {
    "heights_10um": ("height of each bump", "10 µm", "± 20 µm"),
    "heights_5um": ("height of each bump", "5 µm", "± 10 µm"),
    "radial_clearance": ("radial clearance", "2.5 µm", "± 5 µm"),
    "bump_foil_thickness": ("thickness of the bump foil", "2.5 µm", "± 5 µm"),
    "top_foil_thickness": ("thickness of the top foil", "2.5 µm", "± 5 µm"),
    "bump_length": ("length of the bumps", "25 µm", "± 50 µm"),
    "friction_top_bump": ("friction, top foil on bump", "0.02", "± 0.04"),
    "friction_bump_sleeve": ("friction, bump on sleeve", "0.02", "± 0.04"),
}


def minus(text):
    return text.replace("-", "−")


def number(value, digits=0, scale=1.0):
    return minus(f"{value * scale:.{digits}f}")


def change(value, reference, digits=1):
    """In per cent, with its sign."""
    return minus(f"{100 * (value / reference - 1):+.{digits}f}")


class Data:
    def __init__(self, data):
        self.nominal = data["nominal"]
        self.ensembles = data["ensembles"]

    def bearings(self, ensemble):
        return f"{self.ensembles[ensemble]['samples']:,}"

    def of(self, ensemble, quantity, key="mean", direction="+X"):
        return self.ensembles[ensemble]["directions"][direction]["statistics"][quantity][key]

    def drawn(self, quantity, direction="+X"):
        return self.nominal[direction][quantity]

    def shift(self, ensemble, quantity, direction="+X", digits=1):
        """Of the mean from the bearing as drawn, per cent."""
        return change(self.of(ensemble, quantity, "mean", direction), self.drawn(quantity, direction), digits)

    def spread(self, ensemble, quantity, direction="+X"):
        """Standard deviation, per cent of the bearing as drawn."""
        return number(self.of(ensemble, quantity, "std", direction) / self.drawn(quantity, direction), 1, 100)

    def percentile(self, ensemble, quantity, key):
        """Of a clearance, µm; beyond the push where it was never taken up."""
        value = self.of(ensemble, quantity, key)
        return "never" if value is None else number(value, 1, 1e6)

    def width(self, ensemble, quantity):
        low, high = (self.of(ensemble, quantity, key) for key in ("p5", "p95"))
        return number(high - low, 1, 1e6)

    def squeezed(self, ensemble):
        """Part of the bearings that press on the centred journal, per cent."""
        of_all = self.ensembles[ensemble]
        return number(of_all["squeezed_at_the_centre"] / of_all["samples"], 0, 100)

    def ranks(self, ensemble, quantity, direction):
        """Partial rank correlations with the height of each bump."""
        return self.ensembles[ensemble]["directions"][direction]["sensitivities"][quantity]["bump_height"]

    def leading(self, ensemble, quantity, direction, count=3):
        """Bumps whose height matters most, from 1, with their correlations."""
        ranks = self.ranks(ensemble, quantity, direction)
        order = sorted(range(len(ranks)), key=lambda bump: -abs(ranks[bump]))[:count]
        return ", ".join(f"{bump + 1} ({minus(f'{ranks[bump]:+.2f}')})" for bump in order)


def heights(data):
    rows = []
    for name, digits, scale, quantity in (
        ("maximum force (N)", 0, 1.0, "max_force_N"),
        ("structural stiffness (MN/m)", 2, 1e-6, "loaded_stiffness_N_per_m"),
        ("tangent stiffness, loading (MN/m)", 2, 1e-6, "tangent_stiffness_loading_N_per_m"),
        ("take-up (µm)", 1, 1e6, "take_up_m"),
        ("loop energy (mJ)", 2, 1e3, "loop_energy_J"),
        ("loss factor", 3, 1.0, "loss_factor"),
    ):
        cells = [name, number(data.drawn(quantity), digits, scale)]
        for ensemble in ("heights_10um", "heights_20um"):
            mean, error, std = (data.of(ensemble, quantity, key) for key in ("mean", "standard_error", "std"))
            cells += [
                f"{number(mean, digits, scale)} ± {number(error, digits + 1, scale)}",
                number(std, digits, scale),
                data.shift(ensemble, quantity),
            ]
        rows.append(cells)
    return table(
        ["+X", "as drawn", "10 µm: mean", "std", "change (%)", "20 µm: mean", "std", "change (%)"], rows
    )


def clearances(data):
    rows = []
    for ensemble, scatter in (("heights_5um", "5 µm"), ("heights_10um", "10 µm"), ("heights_20um", "20 µm")):
        for quantity, force in (("clearance_5N_m", "5 N"), ("clearance_10N_m", "10 N")):
            percentiles = [data.percentile(ensemble, quantity, key) for key in ("p5", "p50", "p95")]
            rows.append([scatter, force, number(data.drawn(quantity), 1, 1e6), *percentiles,
                         data.width(ensemble, quantity), data.squeezed(ensemble)])
    return table(
        ["heights", "at", "as drawn (µm)", "5 %", "50 %", "95 %", "95 % minus 5 %", "press on the centred journal (%)"],
        rows,
    )


def directions(data):
    rows = []
    for direction in DIRECTIONS:
        rows.append([minus(direction), *(
            data.shift(ensemble, quantity, direction)
            for ensemble in ("heights_10um", "heights_20um")
            for quantity in ("loaded_stiffness_N_per_m", "max_force_N")
        )])
    return table(["", "10 µm: stiffness (%)", "force (%)", "20 µm: stiffness (%)", "force (%)"], rows)


def bumps(data):
    rows = []
    for direction in DIRECTIONS:
        rows.append([minus(direction), *(
            data.leading("heights_10um", quantity, direction)
            for quantity in ("max_force", "loaded_stiffness", "clearance_5N")
        )])
    return table(["", "maximum force", "structural stiffness", "clearance at 5 N"], rows)


def alone(data):
    rows = []
    for ensemble, (name, deviation, drawing) in ALONE.items():
        rows.append([name, deviation, drawing, *(
            data.spread(ensemble, quantity)
            for quantity in ("max_force_N", "loaded_stiffness_N_per_m", "loop_energy_J", "loss_factor")
        ), data.shift(ensemble, "loaded_stiffness_N_per_m"), data.width(ensemble, "clearance_5N_m")])
    return table(
        ["scattered quantity", "std", "on a drawing", "force (%)", "structural stiffness (%)", "loop energy (%)",
         "loss factor (%)", "mean stiffness (%)", "clearance at 5 N (µm)"],
        rows,
    )


def table(head, rows):
    lines = [head, ["---", *["--:"] * (len(head) - 1)], *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def reflowed(text):
    """Paragraphs to the width of a page; headings, tables and commands as they are."""
    blocks = [
        block if block.startswith(("#", "|", " ")) else textwrap.fill(" ".join(block.split()), 118, break_on_hyphens=False)
        for block in text.split("\n\n")
    ]
    return "\n\n".join(blocks)


def text(of_ensembles):
    data = Data(of_ensembles)
    stiffness, force = "loaded_stiffness_N_per_m", "max_force_N"
    return reflowed(f"""# Which tolerance to pay for

The paper shows twelve bearings with bump heights that scatter by 10 and 20 µm. This page shows
{data.bearings("heights_10um")} for 10 µm and {data.bearings("heights_20um")} for 20 µm, and the effect of the other
tolerances on a drawing. The bearing is the reference bearing with friction 0.1; the journal moves by 79.5 µm; the
solver is `events`. The command

    make tolerances

writes this page from `studies/tolerances/ensembles.json`, which has all numbers. `TOLERANCES="--heights 20000 --others
2000"` runs more bearings. Numbers after ± are standard errors.

## Does the stiffness fall or rise with the scatter of heights?

It falls. Heights are normally distributed and independent; direction +X:

{heights(data)}

The mean structural stiffness changes by {data.shift("heights_10um", stiffness)} % at 10 µm and by
{data.shift("heights_20um", stiffness)} % at 20 µm, while the mean maximum force rises by
{data.shift("heights_10um", force)} and {data.shift("heights_20um", force)} %. Both have the same cause. The tallest
bumps carry load first. The take-up is therefore smaller, and few bumps carry over a longer displacement. At full
displacement nearly all bumps under the journal carry load, as without scatter but from shifted origins. The tangent
stiffness there hardly changes ({data.shift("heights_10um", "tangent_stiffness_loading_N_per_m")} and
{data.shift("heights_20um", "tangent_stiffness_loading_N_per_m")} %). The force is a convex function of the height, so
that tall bumps add more on average than low ones subtract: the force rises slightly, and so does the loop energy
({data.shift("heights_10um", "loop_energy_J")} and {data.shift("heights_20um", "loop_energy_J")} %).

Change of the means from the nominal bearing, in all directions:

{directions(data)}

## How much does the clearance scatter?

Clearance that a push test measures, +X, in µm:

{clearances(data)}

The clearance is the most sensitive quantity. Its median is below nominal, since a push test finds the tallest bump near
the direction of the push. Its range is several times the standard deviation of one height. The last column counts
bearings that press on the centred journal with more than 1 N before the push.

## Which bumps matter?

Bumps whose height has the largest partial rank correlation with the quantity, at 10 µm:

{bumps(data)}

These bumps lie under the journal; bumps 26 and 1 are next to the weld, at −X. The force depends about equally on each
of about ten bumps: measure the mean height over the loaded arc. Tall bumps at the ends of that arc increase the
stiffness. Any tall bump within it reduces the clearance.

## What does each tolerance alone do?

{alone(data)}

Force to loss factor: standard deviations relative to nominal, +X. The last columns are the change of the mean
stiffness, and the range of the clearance at 5 N, 95th minus 5th percentile. Each row has {data.bearings("bump_length")}
bearings, except the first.

Tighten the heights first. At 10 µm they scatter force and stiffness by {data.spread("heights_10um", force)} and
{data.spread("heights_10um", stiffness)} %, reduce the mean stiffness, and widen the clearance to
{data.width("heights_10um", "clearance_5N_m")} µm. At 5 µm these figures are {data.spread("heights_5um", force)} %,
{data.spread("heights_5um", stiffness)} % and {data.width("heights_5um", "clearance_5N_m")} µm. The radial clearance
comes next: held to ± 5 µm it still scatters the force by {data.spread("radial_clearance", force)} % and the loop energy
by {data.spread("radial_clearance", "loop_energy_J")} %. The thickness of the bump foil, held to ± 5 µm, scatters force
and stiffness by {data.spread("bump_foil_thickness", force)} %, and the length of the bumps, held to ± 50 µm, by
{data.spread("bump_length", force)} %. Friction is not a tolerance on a drawing: ± 0.04 about 0.1 scatters the loop
energy by {data.spread("friction_bump_sleeve", "loop_energy_J")} % on the sleeve and by
{data.spread("friction_top_bump", "loop_energy_J")} % under the top foil. The thickness of the top foil does not matter:
± 5 µm scatters the force by {data.spread("top_foil_thickness", force)} %.

Heights may also be correlated along the foil, as from a tilted tool. Correlated over 20 mm, about four pitches, they
scatter the force by {data.spread("heights_10um_correlated", force)} % instead of {data.spread("heights_10um", force)} %
and change the mean stiffness by {data.shift("heights_10um_correlated", stiffness)} % instead of
{data.shift("heights_10um", stiffness)} %. Neighbours of equal height share the load, and their errors no longer cancel.
""").rstrip() + "\n"
