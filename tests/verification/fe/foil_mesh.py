"""Plane meshes of foils: one layer of quadratic quadrilaterals along a path of straight lines and arcs.

A foil is a row of sections; every second one carries the corners of elements, those between the mid-side nodes.
Lengths in m. Node numbers start at 0; calculix.py adds one.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class BumpGeometry:
    """Bumps of the reference bearing [Arghir2019, Table 1], with the rise measured to the mid-surface."""

    pitch: float = 4.572e-3
    chord: float = 3.556e-3
    rise: float = 0.508e-3
    thickness: float = 0.102e-3

    @property
    def radius(self):
        return ((self.chord / 2) ** 2 + self.rise**2) / (2 * self.rise)

    @property
    def half_angle(self):
        return np.arcsin(self.chord / 2 / self.radius)

    @property
    def flat(self):
        return self.pitch - self.chord


@dataclass
class Mesh:
    """Nodes, elements and the nodes of both faces, section after section."""

    nodes: np.ndarray  # (n, 2)
    quads: np.ndarray  # (elements, 8): corners anticlockwise, then mid-sides from the first edge on
    lower: np.ndarray  # node at the lower face of every section
    upper: np.ndarray
    position: np.ndarray  # coordinate of every section along the unwrapped strip

    @property
    def corners(self):
        """Nodes at the corners of elements."""
        return np.unique(self.quads[:, :4])

    @property
    def clamped(self):
        """Nodes of the first section: the weld."""
        return self.quads[0, [0, 3, 7]]

    def sections(self, low, high):
        """Numbers of the sections with low <= position <= high."""
        slack = 1e-9
        return np.flatnonzero((self.position >= low - slack) & (self.position <= high + slack))


def mesh_sections(middle, offset, position):
    """Mesh of a foil from the mid-points of its sections and the vectors from there to the upper face."""
    count = len(middle)
    elements = (count - 1) // 2
    corner_sections = np.arange(0, count, 2)
    nodes = np.concatenate([middle - offset, middle + offset, middle[corner_sections]])
    lower = np.arange(count)
    upper = count + lower
    central = 2 * count + np.arange(elements + 1)
    first = 2 * np.arange(elements)
    quads = np.column_stack(
        [lower[first], lower[first + 2], upper[first + 2], upper[first],
         lower[first + 1], central[1:], upper[first + 1], central[:-1]]
    )
    return Mesh(nodes, quads, lower, upper, position)


def equal_parts(elements):
    """Places of the sections of so many equal elements on a piece of length one, without the first."""
    return np.arange(1, 2 * elements + 1) / (2 * elements)


def graded_parts(elements):
    """The same with short elements at both ends, where a flat is touched."""
    corners = 0.5 * (1 - np.cos(np.pi * np.arange(elements + 1) / elements))
    middles = 0.5 * (corners[:-1] + corners[1:])
    return np.column_stack([middles, corners[1:]]).ravel()


def mesh_bump_foil(shape, bumps, arc_elements, flat_elements, weld_flat=0.0, tail=0.0, upright_kinks=True):
    """A strip of bumps on the line y = 0, the middle of its flats; the first arc begins at x = 0.

    @param arc_elements   elements along half a bump
    @param flat_elements  elements along a flat
    @param weld_flat      length of the flat before the first arc
    @param tail           length of the flat after the last arc
    @param upright_kinks  where arcs and flats meet the section is upright, so that the foil rests on the ends of the
                          middle of its arcs, as in a beam model; otherwise on the bisector, as in a sharply bent sheet
    """
    alpha, radius, half = shape.half_angle, shape.radius, shape.thickness / 2
    tilt = 0.0 if upright_kinks else alpha / 2
    at_kink = half / np.cos(tilt)
    middle, offset = [], []

    def add(x, y, normal_angle, size):
        middle.append((x, y))
        offset.append((size * np.sin(normal_angle), size * np.cos(normal_angle)))

    def add_flat(start, length, elements, last_is_kink):
        for part in graded_parts(elements):
            kink = part == 1.0 and last_is_kink
            add(start + part * length, 0.0, -tilt if kink else 0.0, at_kink if kink else half)

    if weld_flat > 0.0:
        add(-weld_flat, 0.0, 0.0, half)
        add_flat(-weld_flat, weld_flat, flat_elements, True)
    else:
        add(0.0, 0.0, -tilt, at_kink)
    for bump in range(bumps):
        start = bump * shape.pitch
        for part in equal_parts(2 * arc_elements):
            angle = alpha * (2 * part - 1)
            end = part == 1.0
            add(start + shape.chord / 2 + radius * np.sin(angle), radius * (np.cos(angle) - np.cos(alpha)),
                tilt if end else angle, at_kink if end else half)
        last = bump == bumps - 1
        length = tail if last else shape.flat
        if length > 0.0:
            elements = max(1, round(flat_elements * length / shape.flat))
            add_flat(start + shape.chord, length, elements, not last)
    middle = np.array(middle)
    return mesh_sections(middle, np.array(offset), middle[:, 0])


def mesh_top_foil(stations, thickness, radius=None):
    """A smooth foil with corners of elements at the given places along its unwrapped middle.

    Flat on y = 0; with a radius curved, outer face lower: node coordinates are then polar, (-radius * sin, cos) of
    the angle from the weld, so that the foil turns away from y like the unwrapped strip lies below it.
    """
    stations = np.asarray(stations)
    position = np.empty(2 * len(stations) - 1)
    position[::2] = stations
    position[1::2] = (stations[:-1] + stations[1:]) / 2
    if radius is None:
        middle = np.column_stack([position, np.zeros_like(position)])
        normal = np.tile([0.0, 1.0], (len(position), 1))
    else:
        angle = position / radius
        # Inwards is up; at the weld the tangent points along x.
        normal = np.column_stack([-np.sin(angle), np.cos(angle)])
        middle = -radius * normal
    return mesh_sections(middle, thickness / 2 * normal, position)
