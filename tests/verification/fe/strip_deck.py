"""Decks of flat strips of bumps between plates, with the contact of CalculiX itself: surface to surface, penalty."""

from dataclasses import dataclass

import numpy as np

from calculix import AXIAL_LENGTH, MATERIAL, MM, lines
from foil_mesh import BumpGeometry, mesh_bump_foil, mesh_top_foil

TAIL = 0.25e-3  # flat after the last arc: surfaces touch at points inside elements, not at corners
CREST_REACH = 0.3e-3  # from a crest, where it may touch
PLATE = 0.5e-3  # thickness of the plates, which do not deform
STIFFNESS = 1e7  # MPa/mm, pressure over overlap
STICK_SLOPE = 1e5  # MPa/mm, shear stress over elastic slip


@dataclass
class Strip:
    """One run: pressed by a plate to the compression and released."""

    bumps: int
    friction: float
    large: bool = False  # displacements
    top_foil: bool = False
    compression: float = 20e-6
    increments: int = 20  # each way
    arc_elements: int = 12
    flat_elements: int = 8

    @property
    def name(self):
        return (f"strip_{self.bumps}_f{self.friction:g}" + ("_top" if self.top_foil else "")
                + ("_large" if self.large else "_small")).replace(".", "p")


class Deck:
    """Nodes, elements and surfaces, numbered as they come."""

    def __init__(self):
        self.nodes, self.elements, self.cards = [], [], []

    def add(self, nodes, elements, kind, elset):
        """Adds a mesh; returns the number of its first node and its first element."""
        first_node, first_element = len(self.nodes) + 1, len(self.elements) + 1
        self.nodes += list(nodes)
        for element in elements:
            self.elements.append((kind, elset, element + first_node))
        return first_node, first_element

    def surface(self, name, elements, edge):
        self.cards.append(f"*SURFACE, NAME={name}\n" + "".join(f"{e}, S{edge}\n" for e in elements))

    def node_set(self, name, numbers):
        self.cards.append(f"*NSET, NSET={name}\n" + lines(numbers, 8))

    def contact(self, lower, upper, friction):
        """Contact of surface `lower` with `upper`, the first being the one that is checked."""
        name = f"I{lower}{upper}"
        law = f"*FRICTION\n{friction}, {STICK_SLOPE:g}\n" if friction > 0 else ""
        self.cards.append(f"*SURFACE INTERACTION, NAME={name}\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n"
                          f"{STIFFNESS:g}\n{law}*CONTACT PAIR, INTERACTION={name}, TYPE=SURFACE TO SURFACE\n"
                          f"{lower}, {upper}\n")

    def text(self):
        out = ["*NODE, NSET=ALL\n"]
        out += [f"{k}, {x / MM:.11e}, {y / MM:.11e}, 0.\n" for k, (x, y) in enumerate(self.nodes, 1)]
        for number, (kind, elset, element) in enumerate(self.elements, 1):
            out.append(f"*ELEMENT, TYPE={kind}, ELSET={elset}\n" + lines([number, *element]))
        out.append(MATERIAL)
        for elset in dict.fromkeys(elset for _, elset, _ in self.elements):
            out.append(f"*SOLID SECTION, ELSET={elset}, MATERIAL=METAL\n{AXIAL_LENGTH / MM}\n")
        return "".join(out + self.cards)


def plates(spans, bottom, top):
    """One rectangle for each span (low, high)."""
    nodes = [(x, y) for low, high in spans for x, y in ((low, bottom), (high, bottom), (high, top), (low, top))]
    return np.array(nodes), np.arange(4 * len(spans)).reshape(-1, 4)


def make_deck(strip):
    """The deck of a strip: pressed and released, total force and force on the plate above each bump per increment."""
    shape = BumpGeometry()
    deck = Deck()
    foil = mesh_bump_foil(shape, strip.bumps, strip.arc_elements, strip.flat_elements, tail=TAIL)
    first_node, first = deck.add(foil.nodes, foil.quads, "CPE8R", "BUMPFOIL")
    clamped = list(foil.clamped + first_node)
    crests = shape.pitch * np.arange(strip.bumps) + shape.chord / 2
    centre = foil.position[1::2]
    near_crest = np.abs(centre[:, None] - crests).min(axis=1) < CREST_REACH
    on_flat = np.abs(centre[:, None] - crests).min(axis=1) > shape.chord / 2
    deck.surface("CREST", first + np.flatnonzero(near_crest), 3)
    deck.surface("UNDER", first + np.flatnonzero(on_flat), 1)

    length = strip.bumps * shape.pitch
    spans = [(n * shape.pitch - 0.1e-3, (n + 1) * shape.pitch - 0.1e-3) for n in range(strip.bumps)]
    base_node, base = deck.add(*plates(spans, -shape.thickness / 2 - PLATE, -shape.thickness / 2), "CPE4", "BASE")
    deck.surface("SLEEVE", range(base, base + strip.bumps), 3)
    deck.contact("UNDER", "SLEEVE", strip.friction)

    top = shape.rise + shape.thickness / 2
    upper = "CREST"
    if strip.top_foil:
        stations = np.unique(np.concatenate(
            # Its weld is half a pitch before the first crest.
            [np.linspace(-shape.flat / 2, length - shape.flat / 2, 4 * strip.bumps + 1)]
            + [crest + np.linspace(-CREST_REACH, CREST_REACH, 9) for crest in crests]).round(9))
        flat = mesh_top_foil(stations, shape.thickness)
        node, element = deck.add(flat.nodes + [0, top + shape.thickness / 2], flat.quads, "CPE8R", "TOPFOIL")
        clamped += list(flat.clamped + node)
        close = np.abs(flat.position[1::2][:, None] - crests).min(axis=1) < CREST_REACH
        deck.surface("OUTER", element + np.flatnonzero(close), 1)
        # The plate does not reach towards the weld: there it would press on the clamped end.
        close &= flat.position[1::2] > crests[0] - CREST_REACH / 8
        deck.surface("INNER", element + np.flatnonzero(close), 3)
        deck.contact("CREST", "OUTER", strip.friction)
        top += shape.thickness
        upper = "INNER"
        spans = [(crest - CREST_REACH * 1.5, crest + CREST_REACH * 1.5) for crest in crests]
    plate_node, plate = deck.add(*plates(spans, top, top + PLATE), "CPE4", "PLATE")
    deck.surface("JOURNAL", range(plate, plate + strip.bumps), 1)
    deck.contact(upper, "JOURNAL", 0.0 if strip.top_foil else strip.friction)

    deck.node_set("CLAMPED", clamped)
    deck.node_set("BASE", range(base_node, base_node + 4 * strip.bumps))
    deck.node_set("PLATE", range(plate_node, plate_node + 4 * strip.bumps))
    for bump in range(strip.bumps):
        deck.node_set(f"BUMP{bump + 1}", range(plate_node + 4 * bump, plate_node + 4 * bump + 4))
    fixed = "*BOUNDARY\nCLAMPED, 1, 2\nBASE, 1, 2\nPLATE, 1, 1\n"
    step = 1.0 / strip.increments
    for place in (-strip.compression / MM, 0.0):
        fixed += (f"*STEP, INC=2000{', NLGEOM' if strip.large else ''}\n*STATIC\n{step:g}, 1., 1e-7, {step:g}\n"
                  f"*BOUNDARY\nPLATE, 2, 2, {place:.11e}\n")
        fixed += "".join(f"*NODE PRINT, NSET=BUMP{bump + 1}, TOTALS=ONLY\nRF\n" for bump in range(strip.bumps))
        fixed += "*END STEP\n"
    return deck.text() + fixed
