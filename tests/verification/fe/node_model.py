"""Foils of solid elements with contact at their nodes: stiffness from CalculiX, clamped at the weld.

Contacts are of three kinds: "journal", what presses from above, on the top foil or, without one, on the crests;
"crest", between bump foil and top foil; "base", under the flats and the ends of arcs. Gaps are those of the
undeformed foils with the journal on the top foil everywhere.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse

from calculix import plane_stiffness
from foil_mesh import BumpGeometry, mesh_bump_foil, mesh_top_foil
from node_contact import NodeContact

SHAPE = BumpGeometry()
CREST_ELEMENTS = 2  # on either side of a crest that may touch
ON_BASE = 1e-9  # m, what counts as touching the base


@dataclass
class Foils:
    """What is modelled. The defaults make the same assumptions as the program."""

    bumps: int
    weld_flat: float = 0.0  # length of the flat between weld and first arc
    top_foil: bool = True
    top_lead: float = 0.0  # by how much the weld of the top foil stands before that of the bump foil
    radius: float = None  # of the top foil; flat without
    top_moves: bool = False  # tangentially; otherwise friction finds it held
    wide_journal: bool = False  # touches all nodes near a crest, not only the one above it
    upright_kinks: bool = True
    arc_elements: int = 12
    flat_elements: int = 8


@dataclass
class NodeModel:
    K: sparse.csc_matrix
    normal: sparse.csr_matrix
    tangential: sparse.csr_matrix
    gap: np.ndarray
    along: np.ndarray  # place of every contact, from the weld
    kind: np.ndarray
    bump: np.ndarray  # -1 at the base
    rubs: np.ndarray  # whether a contact has friction

    def contacts(self, friction):
        return NodeContact(self.K, self.normal, self.tangential, np.where(self.rubs, friction, 0.0))

    def loads(self, state, kind):
        """Forces of one kind of contact, summed over each bump, N."""
        of_kind = self.kind == kind
        return np.bincount(self.bump[of_kind], state.normal[of_kind])


class ContactRows:
    """Contacts, collected one by one."""

    def __init__(self):
        self.records = []

    def add(self, kind, bump, along, gap, normal, tangential):
        """`normal` and `tangential` are pairs of unknowns and coefficients; the latter may be None."""
        self.records.append((kind, bump, along, gap, normal, tangential))

    def matrix(self, which, columns):
        rows = [record[which] or ([], []) for record in self.records]
        row = np.repeat(np.arange(len(rows)), [len(places) for places, _ in rows])
        place = np.concatenate([places for places, _ in rows]).astype(int)
        value = np.concatenate([values for _, values in rows])
        return sparse.csr_matrix((value, (row, place)), shape=(len(rows), columns))

    def column(self, which):
        return np.array([record[which] for record in self.records])


def top_foil_stations(along, crests, arc_elements):
    """Corners of the top foil: opposite those of the bump foil near crests, six more between two crests.

    @param along  places of the sections of the bump foil, from the weld of the top foil
    """
    reach = (CREST_ELEMENTS + 0.5) * SHAPE.chord / (2 * arc_elements)
    corners = along[::2]
    stations = [0.0]
    for crest in crests:
        near = corners[np.abs(corners - crest) < reach]
        stations += [*np.linspace(stations[-1], near[0], 8)[1:-1], *near]
    return np.array([*stations, *np.linspace(stations[-1], crests[-1] + SHAPE.pitch / 2, 8)[1:]])


def build(folder, foils):
    """Meshes, stiffness and contacts."""
    bump_foil = mesh_bump_foil(SHAPE, foils.bumps, foils.arc_elements, foils.flat_elements, foils.weld_flat,
                               upright_kinks=foils.upright_kinks)
    along = bump_foil.position + foils.weld_flat
    crests = foils.weld_flat + SHAPE.chord / 2 + SHAPE.pitch * np.arange(foils.bumps)
    K = plane_stiffness(folder, "bump_foil", bump_foil)
    clamped = bump_foil.clamped
    if foils.top_foil:
        stations = top_foil_stations(along + foils.top_lead, crests + foils.top_lead, foils.arc_elements)
        top_foil = mesh_top_foil(stations, SHAPE.thickness, foils.radius)
        K = sparse.block_diag([K, plane_stiffness(folder, "top_foil", top_foil)]).tocsc()
        clamped = np.concatenate([clamped, top_foil.clamped + len(bump_foil.nodes)])

    rows = ContactRows()
    top_of_bump = SHAPE.rise + SHAPE.thickness / 2
    steps = np.arange(-2 * CREST_ELEMENTS, 2 * CREST_ELEMENTS + 1)
    for bump, crest in enumerate(crests):
        centre = np.argmin(np.abs(along - crest))
        for step in steps:
            below = bump_foil.upper[centre + step]
            u, v = 2 * below, 2 * below + 1
            sag = top_of_bump - bump_foil.nodes[below, 1]
            if not foils.top_foil:
                rows.add("journal", bump, along[centre + step], sag, ([v], [-1.0]), ([u], [1.0]))
                continue
            section = np.argmin(np.abs(top_foil.position - foils.top_lead - crest)) + step
            place = top_foil.position[section]
            angle = place / foils.radius if foils.radius else 0.0
            sin, cos = np.sin(angle), np.cos(angle)
            outer = 2 * (len(bump_foil.nodes) + top_foil.lower[section]) + np.array([0, 1])
            inner = 2 * (len(bump_foil.nodes) + top_foil.upper[section]) + np.array([0, 1])
            if step == 0 or foils.wide_journal:
                rows.add("journal", bump, place, 0.0, (inner, [sin, -cos]), None)
            slip = ([u, *outer], [1.0, -cos, -sin]) if foils.top_moves else ([u], [1.0])
            rows.add("crest", bump, place, sag, ([v, *outer], [-1.0, -sin, cos]), slip)
    on_base = np.abs(bump_foil.nodes[bump_foil.lower, 1] + SHAPE.thickness / 2) < ON_BASE
    for section in np.flatnonzero(on_base)[1:]:  # the first is clamped
        node = bump_foil.lower[section]
        rows.add("base", -1, along[section], 0.0, ([2 * node + 1], [1.0]), ([2 * node], [1.0]))

    columns = K.shape[0]
    free = np.setdiff1d(np.arange(columns), np.concatenate([2 * clamped, 2 * clamped + 1]))
    return NodeModel(K[free][:, free], rows.matrix(4, columns)[:, free], rows.matrix(5, columns)[:, free],
                     gap=rows.column(3), along=rows.column(2), kind=rows.column(0), bump=rows.column(1),
                     rubs=np.array([record[5] is not None for record in rows.records]))
