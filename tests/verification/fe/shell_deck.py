"""Decks of foils as shells, S8R of CalculiX: surfaces over the sections of a path and places across the width.

z runs from side edge to side edge: rotations that are given at a mid-plane, for half the width, are not what CalculiX
makes of them where it turns shells into bricks. Lengths in m, as in foil_mesh.py.
"""

import re
from pathlib import Path

import numpy as np

from calculix import AXIAL_LENGTH, MATERIAL, MM, run

HALF_WIDTH = AXIAL_LENGTH / 2
ZETA = (0.0, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0)  # z over the half width where displacements are read
ACROSS = (1, 1, 1, 1, 1, 1)  # elements between them on the coarse mesh: short ones in the layer at the edge
GAUSS = list(zip(*np.polynomial.legendre.leggauss(3)))
NUMBERS = re.compile(r"^\s*(\d+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$", re.MULTILINE)


def places_across(refined):
    """z of the corners of elements and of the nodes between them."""
    parts = [np.linspace(low, high, 2 * refined * count, endpoint=False)
             for low, high, count in zip(ZETA, ZETA[1:], ACROSS)]
    half = HALF_WIDTH * np.append(np.concatenate(parts), 1.0)
    return np.concatenate([-half[:0:-1], half])


def shape_functions(x, y):
    """Of the nodes of an element, corners and then sides, anticlockwise; a column each for value and derivatives."""
    corner_x, corner_y = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
    a, b = 1 + corner_x * x, 1 + corner_y * y
    corners = np.array([a * b * (a + b - 3), corner_x * b * (2 * a + b - 3), corner_y * a * (a + 2 * b - 3)]) / 4
    square_x, square_y = 1 - x * x, 1 - y * y
    sides = np.array([[square_x * (1 - y), (1 + x) * square_y, square_x * (1 + y), (1 - x) * square_y],
                      [-2 * x * (1 - y), square_y, -2 * x * (1 + y), -square_y],
                      [-square_x, -2 * y * (1 + x), square_x, -2 * y * (1 - x)]]) / 2
    return np.hstack([corners, sides])


class ShellDeck:
    """Nodes, elements, supports and equations, numbered as they come."""

    def __init__(self, thickness, refined):
        """@param refined  times as many elements as the coarse mesh has across the width"""
        self.thickness, self.z = thickness, places_across(refined)
        self.read_at = len(self.z) // 2 + 2 * refined * np.cumsum((0, *ACROSS))
        self.nodes, self.elements, self.supports, self.equations = [], [], [], []
        self.points, self.loads = {}, {}

    def add_foil(self, path):
        """A foil over the sections of a path (n, 2), every second one between elements, clamped at the first. Returns
        the numbers of its nodes by section and place across; none inside elements: 0."""
        number = np.zeros((len(path), len(self.z)), dtype=int)
        for i, (x, y) in enumerate(path):
            for j, z in enumerate(self.z):
                if i % 2 == 0 or j % 2 == 0:
                    self.nodes.append((x, y, z))
                    number[i, j] = len(self.nodes)
        for i in range(0, len(path) - 2, 2):
            for j in range(0, len(self.z) - 2, 2):
                self.elements.append(number[i + np.array([0, 2, 2, 0, 1, 2, 1, 0]),
                                            j + np.array([0, 0, 2, 2, 0, 1, 2, 1])])
        self.hold(number[0], 1, 6)
        return number

    def hold(self, nodes, first, last):
        self.supports += [(node, first, last) for node in nodes if node]

    def add_point(self, held_at=None):
        """A node of no element, the first of whose displacements stands for one of the foils; may be given."""
        self.nodes.append((0.0, 0.0, -HALF_WIDTH))
        self.points[len(self.nodes)] = held_at
        return len(self.nodes)

    def tie(self, node, direction, point=None):
        """The displacement of a node in a direction of the plane is that of a point, or none."""
        terms = [(node, k + 1, part) for k, part in enumerate(direction) if abs(part) > 1e-9]
        terms.sort(key=lambda term: -abs(term[2]))  # the first is eliminated
        self.equations.append(terms + ([(point, 1, -1.0)] if point else []))

    def press(self, number, pressure):
        """Presses a foil away from the axis at x = y = 0 by a pressure (Pa) of angle from -y, and zeta."""
        wanted = set(number.ravel())
        for element in self.elements:
            if element[0] not in wanted:
                continue
            corners = np.array([self.nodes[node - 1] for node in element])
            for x, weight_x in GAUSS:
                for y, weight_y in GAUSS:
                    shape, by_x, by_y = shape_functions(x, y)
                    place = shape @ corners
                    p = pressure(np.arctan2(place[0], -place[1]) % (2 * np.pi), place[2] / HALF_WIDTH)
                    if p == 0.0:
                        continue
                    area = np.linalg.norm(np.cross(by_x @ corners, by_y @ corners))
                    outward = place[:2] / np.hypot(*place[:2])
                    for node, part in zip(element, shape):
                        load = self.loads.setdefault(node, np.zeros(2))
                        load += part * weight_x * weight_y * area * p * outward

    def text(self):
        out = ["*NODE, NSET=ALL\n"]
        out += [f"{k}, {x / MM:.11e}, {y / MM:.11e}, {z / MM:.11e}\n" for k, (x, y, z) in enumerate(self.nodes, 1)]
        out.append("*ELEMENT, TYPE=S8R, ELSET=FOILS\n")
        out += [f"{k}, " + ", ".join(map(str, element)) + "\n" for k, element in enumerate(self.elements, 1)]
        out.append(MATERIAL + f"*SHELL SECTION, ELSET=FOILS, MATERIAL=METAL\n{self.thickness / MM}\n")
        out += [f"*EQUATION\n{len(terms)}\n" + "".join(f"{n}, {k}, {part:.12g}\n" for n, k, part in terms)
                for terms in self.equations]
        out.append("*BOUNDARY\n" + "".join(f"{node}, {a}, {b}\n" for node, a, b in self.supports))
        out.append("*STEP\n*STATIC\n")
        given = [f"{point}, 1, 1, {value:.12g}\n" for point, value in self.points.items() if value is not None]
        if given:
            out += ["*BOUNDARY\n", *given]
        if self.loads:
            out.append("*CLOAD\n")
            out += [f"{node}, {k + 1}, {part:.12g}\n" for node, load in self.loads.items()
                    for k, part in enumerate(load)]
        return "".join(out)

    def solve(self, folder, name, nodes=()):
        """Runs CalculiX; returns the displacement of every point (mm), and the forces (3) that what is given there and
        equations exert on other nodes (N)."""
        printed = "".join(f"*NSET, NSET={name}\n" + "".join(f"{node},\n" for node in members)
                          for name, members in (("POINTS", self.points), ("HELD", nodes)) if members)
        wanted = "*NODE PRINT, NSET=POINTS\nU\n" + ("*NODE PRINT, NSET=HELD\nRF\n" if nodes else "")
        run(folder, name, self.text().replace("*STEP\n", printed + "*STEP\n", 1) + wanted + "*END STEP\n")
        results = (Path(folder) / f"{name}.dat").read_text()
        displacements, _, forces = results.partition("forces (fx,fy,fz)")
        return ({int(node): float(u) for node, u, _, _ in NUMBERS.findall(displacements)},
                {int(node): np.array(force, dtype=float) for node, *force in NUMBERS.findall(forces)})
