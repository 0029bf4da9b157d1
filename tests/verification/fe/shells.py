"""The top foil on held crests, and nine bumps under it, as shells over the width: what the parabola leaves out."""

import time

import numpy as np

from calculix import MM
from foil_mesh import BumpGeometry
from records import write_records
from shell_deck import HALF_WIDTH, ZETA, ShellDeck

RADIUS = 19.05e-3
SHAPE = BumpGeometry(rise=0.406e-3)  # 0.508 mm over all, less the thickness of the foil
PEAK = 1e5  # Pa
EXTENT = np.pi / 3
TILT = 5e-6  # m over the width
TOP_PER_PITCH, PER_ARC, PER_FLAT = 4, 10, 2  # elements of the coarse mesh
MESHES = (1, 2)


def lobe(centre):
    """PEAK times cos along the foil, over EXTENT, and 1 - zeta^2 over the width."""
    def pressure(theta, zeta):
        part = (theta - centre) / EXTENT
        return PEAK * np.cos(np.pi * part) * (1 - zeta**2) if abs(part) < 0.5 else 0.0
    return pressure


class TopFoil:
    """A top foil on a circle, welded at the angle 0 and free so many pitches behind."""

    def __init__(self, deck, pitches, refined):
        self.per_pitch = 2 * refined * TOP_PER_PITCH
        sections = np.arange(pitches * self.per_pitch + 1)
        theta = sections / self.per_pitch * SHAPE.pitch / RADIUS
        self.outward = np.column_stack([np.sin(theta), -np.cos(theta)])
        self.nodes = deck.add_foil(RADIUS * self.outward)

    def crest(self, bump):
        """Section over a crest."""
        return bump * self.per_pitch - self.per_pitch // 2

    def span(self, bump):
        """Section in the middle behind a crest."""
        return bump * self.per_pitch


def add_bump_foil(deck, bumps, refined, stuck):
    """A bump foil on the line y = 0, clamped in the middle of the flat before its first arc; its feet, both ends of all
    arcs, stay on the line. Returns the nodes under every crest."""
    alpha, radius = SHAPE.half_angle, SHAPE.radius
    half_flat = np.linspace(0, SHAPE.flat / 2, refined * PER_FLAT + 1)
    angle = alpha * np.linspace(-1, 1, 2 * refined * PER_ARC + 1)[1:]
    arc = np.column_stack([SHAPE.chord / 2 + radius * np.sin(angle), radius * (np.cos(angle) - np.cos(alpha))])
    flat = np.column_stack([half_flat, 0 * half_flat])
    path, feet, crests = [flat], [], []
    sections = len(flat)
    for bump in range(bumps):
        start = SHAPE.flat / 2 + bump * SHAPE.pitch
        feet += [sections - 1, sections - 1 + len(arc)]
        crests.append(sections - 1 + len(arc) // 2)
        path.append(arc + [start, 0])
        sections += len(arc)
        if bump + 1 < bumps:
            between = np.linspace(0, SHAPE.flat, 2 * refined * PER_FLAT + 1)[1:]
            path.append(np.column_stack([start + SHAPE.chord + between, 0 * between]))
            sections += len(between)
    nodes = deck.add_foil(np.concatenate(path))
    for foot in feet:
        deck.hold(nodes[foot], 1 if stuck else 2, 3 if stuck else 2)
    return [nodes[crest] for crest in crests]


def read_line(deck, top, section):
    """Points for the radial displacements of a line across the top foil, at ZETA."""
    points = [deck.add_point() for _ in deck.read_at]
    for place, point in zip(deck.read_at, points):
        deck.tie(top.nodes[section, place], top.outward[section], point)
    return points


def values(found, points):
    """What was found at points, or at lines of them."""
    return MM * np.array([[found[point] for point in line] for line in points])


def held_crests(folder, refined):
    """The top foil of the reference bearing whose crests do not move, under a lobe in its middle; two spans."""
    deck = ShellDeck(SHAPE.thickness, refined)
    top = TopFoil(deck, 26, refined)
    for bump in range(1, 27):
        for node in filter(None, top.nodes[top.crest(bump)]):
            deck.tie(node, top.outward[top.crest(bump)])
    deck.press(top.nodes, lobe(np.pi))
    spans = [11, 12, 13, 14, 15]
    lines = [read_line(deck, top, top.span(bump)) for bump in spans]
    displaced, _ = deck.solve(folder, f"shells_held_{refined}")
    return {"elements": len(deck.elements), "spans_after": spans, "span_w_m": values(displaced, lines)}


def nine_bumps(folder, refined, stuck):
    """A top foil bonded to nine bumps, under a lobe over the fifth: crests, and spans between them."""
    deck = ShellDeck(SHAPE.thickness, refined)
    top = TopFoil(deck, 9, refined)
    crests = []
    for bump, under in enumerate(add_bump_foil(deck, 9, refined, stuck), 1):
        section = top.crest(bump)
        points = [deck.add_point() for _ in under]
        for above, below, point in zip(top.nodes[section], under, points):
            deck.tie(above, top.outward[section], point)
            deck.tie(below, (0, -1), point)
        crests.append([points[place] for place in deck.read_at])
    deck.press(top.nodes, lobe(4.5 * SHAPE.pitch / RADIUS))
    spans = [read_line(deck, top, top.span(bump)) for bump in range(1, 9)]
    displaced, _ = deck.solve(folder, f"shells_nine_{'stuck' if stuck else 'sliding'}_{refined}")
    return {"elements": len(deck.elements), "crest_w_m": values(displaced, crests),
            "span_w_m": values(displaced, spans)}


def tilted(folder, refined, stuck):
    """The same foils, bonded to a journal that is tilted towards the fifth crest: moments of all bumps."""
    deck = ShellDeck(SHAPE.thickness, refined)
    top = TopFoil(deck, 9, refined)
    lines = []
    for bump, under in enumerate(add_bump_foil(deck, 9, refined, stuck), 1):
        section = top.crest(bump)
        slope = TILT / (2 * HALF_WIDTH) * np.cos((bump - 5) * SHAPE.pitch / RADIUS)
        for above, below, z in zip(top.nodes[section], under, deck.z):
            point = deck.add_point(slope * z / MM)
            deck.tie(above, top.outward[section], point)
            deck.tie(below, (0, -1), point)
        lines.append([(node, z, np.append(outward, 0.0)) for nodes, outward in (
            (top.nodes[section], top.outward[section]), (under, (0, -1))) for node, z in zip(nodes, deck.z)])
    _, forces = deck.solve(folder, f"shells_tilt_{'stuck' if stuck else 'sliding'}_{refined}",
                           [node for line in lines for node, _, _ in line])
    return {"elements": len(deck.elements),
            "moments_N_m": [sum(z * outward @ forces[node] for node, z, outward in line) for line in lines]}


def measure(folder, file):
    """Runs all cases on both meshes and writes what came out after each."""
    cases = [("held crests", "none", held_crests)]
    cases += [(name, feet, case) for name, case in (("nine bumps", nine_bumps), ("tilt", tilted))
              for feet in ("sliding", "stuck")]
    rows = []
    for name, feet, case in cases:
        for refined in MESHES:
            started = time.monotonic()
            result = case(folder, refined, *([] if feet == "none" else [feet == "stuck"]))
            rows.append({"case": name, "feet": feet, "refined": refined, **result})
            write_records(file, {"source": "CalculiX 2.20", "elements": "S8R", "zeta": ZETA, "peak_pressure_Pa": PEAK,
                                 "extent_rad": EXTENT, "tilt_m": TILT}, rows)
            print(f"shells, {name}, {feet}, mesh {refined}: {result['elements']} elements, "
                  f"{time.monotonic() - started:.0f} s", flush=True)
