"""Rotors of ROSS in cases. ROSS is no package of Debian: a stand-in has its matrices, unknowns and signs."""

import json
from types import SimpleNamespace

import numpy as np
import pytest

import bumpfoil
from conftest import COARSE, EXAMPLES

SHAFT = {"length": 0.24, "outer_diameter": 0.03, "youngs_modulus": 210e9, "poisson_ratio": 0.3, "density": 7800.0}
DISK = {"at": 0.23, "mass": 0.3, "transverse_inertia": 1e-4, "polar_inertia": 2e-4}
BEARINGS = (0.04, 0.2)
RUN = {"stability": {"speeds": ["11000 rpm", "15000 rpm"]}, "film": COARSE}


def beam(length):
    """Mass of translation and of rotation, and stiffness of a Timoshenko beam in one plane: its unknowns are the
    displacement and the rotation of the cross-section at both ends. By polynomials that are integrated exactly.
    """
    d, nu = SHAFT["outer_diameter"], SHAFT["poisson_ratio"]
    area, second = np.pi / 4 * d**2, np.pi / 64 * d**4
    bending = SHAFT["youngs_modulus"] * second
    shear = 6 * (1 + nu) / (7 + 6 * nu) * area * SHAFT["youngs_modulus"] / (2 * (1 + nu))
    phi = 12 * bending / (shear * length**2)
    poly = np.polynomial.Polynomial
    displacement = [poly(p) for p in ([1 + phi, -phi, -3, 2], [0, length * (1 + phi / 2), -length * (2 + phi / 2), length],
                                      [0, phi, 3, -2], [0, -length * phi / 2, length * (phi / 2 - 1), length])]
    rotation = [poly(p) for p in ([0, -6 / length, 6 / length], [1 + phi, -4 - phi, 3], [0, 6 / length, -6 / length], [0, phi - 2, 3])]

    def integrals(factors):
        return np.array([[(a * b).integ()(1.0) for b in factors] for a in factors]) * length / (1 + phi) ** 2

    strain = [u.deriv() / length - r for u, r in zip(displacement, rotation)]
    mass = SHAFT["density"] * area * integrals(displacement)
    inertia = SHAFT["density"] * second * integrals(rotation)
    stiffness = bending / length**2 * integrals([r.deriv() for r in rotation]) + shear * integrals(strain)
    return mass, inertia, stiffness


def ross_rotor(width=6):
    """A rotor with the attributes of one of ROSS: x, y, (z,) alpha, beta(, theta) at each node, beta = dx/dz and
    alpha = -dy/dz less shear. Nodes are those of [[rotor.shaft]]: 60 elements at least, at bearings and disks.
    """
    positions = [*np.linspace(0, 0.04, 11), *np.linspace(0.04, 0.2, 41)[1:], *np.linspace(0.2, 0.23, 9)[1:], *np.linspace(0.23, 0.24, 4)[1:]]
    size = width * len(positions)
    M, C, G, K = (np.zeros((size, size)) for _ in range(4))
    alpha = 3 if width == 6 else 2
    sign = np.array([1.0, -1.0, 1.0, -1.0])
    for e, length in enumerate(np.diff(positions)):
        mass, inertia, stiffness = beam(length)
        at = width * e
        x = [at, at + alpha + 1, at + width, at + width + alpha + 1]
        y = [at + 1, at + alpha, at + width + 1, at + width + alpha]
        for places, signs in ((x, np.ones(4)), (y, sign)):
            M[np.ix_(places, places)] += np.outer(signs, signs) * (mass + inertia)
            K[np.ix_(places, places)] += np.outer(signs, signs) * stiffness
        G[np.ix_(x, y)] += 2 * inertia * sign
        G[np.ix_(y, x)] -= 2 * sign[:, None] * inertia
        if width == 6:  # axial motion and torsion are something, and coupled with nothing
            for unknown in (2, 5):
                ends = [at + unknown, at + width + unknown]
                M[np.ix_(ends, ends)] += np.eye(2)
                K[np.ix_(ends, ends)] += 1e9 * np.array([[1.0, -1.0], [-1.0, 1.0]])
    node = int(np.argmin(np.abs(np.array(positions) - DISK["at"])))
    at = width * node
    for unknown, inertia in ((0, "mass"), (1, "mass"), (alpha, "transverse_inertia"), (alpha + 1, "transverse_inertia")):
        M[at + unknown, at + unknown] += DISK[inertia]
    G[at + alpha, at + alpha + 1] += DISK["polar_inertia"]
    G[at + alpha + 1, at + alpha] -= DISK["polar_inertia"]
    return SimpleNamespace(
        M0=M, C0=C, G0=G, K0=K, number_dof=width, nodes=list(range(len(positions))), nodes_pos=positions,
        disk_elements=[SimpleNamespace(n=node)],
    )


def nodes_of(rotor):
    return [int(np.argmin(np.abs(np.array(rotor.nodes_pos) - z))) for z in BEARINGS]


@pytest.mark.parametrize("width", [4, 6])
def test_onset_is_that_of_the_same_shaft_in_pieces(width, tmp_path):
    rotor = ross_rotor(width)
    bumpfoil.write_ross_rotor(rotor, tmp_path / "rotor.json", nodes_of(rotor))
    without_mass = (EXAMPLES / "rotor.toml").read_text().replace('mass = "2 kg"', "#").replace("[[rotor.unbalance]]\namount", "[[rotor.unbalance]]\nat = 0.23\namount")
    (tmp_path / "case.toml").write_text(without_mass)
    by_matrices = bumpfoil.run_stability(tmp_path / "case.toml", rotor={"matrices": "rotor.json"}, **RUN)
    in_pieces = bumpfoil.run_stability(tmp_path / "case.toml", rotor={"shaft": [SHAFT], "disk": [DISK], "bearings": list(BEARINGS)}, **RUN)
    (onset, *_), (expected, *_) = by_matrices.summary["onsets"], in_pieces.summary["onsets"]
    assert onset["speed_rad_per_s"] == pytest.approx(expected["speed_rad_per_s"], rel=1e-9)
    assert onset["whirl_ratio"] == pytest.approx(expected["whirl_ratio"], rel=1e-9)
    names = ["bearing", "station"]
    held = by_matrices.summary["case"]["rotor"]["matrix"]
    assert [[one["name"] for one in held[name]] for name in names] == [["bearing 1", "bearing 2"], ["begin", "disk 1", "end"]]


def test_what_is_no_rotor_is_refused(tmp_path):
    with pytest.raises(TypeError, match="expected a rotor of ROSS 2, which has M0; found dict"):
        bumpfoil.write_ross_rotor({}, tmp_path / "none.json", [0, 1])
    rotor = ross_rotor()
    with pytest.raises(ValueError, match="has no node 99; it has 0 to 61"):
        bumpfoil.write_ross_rotor(rotor, tmp_path / "none.json", [10, 99])
    rotor.nodes = rotor.nodes[:-1]
    with pytest.raises(ValueError, match="supports with a mass of their own"):
        bumpfoil.write_ross_rotor(rotor, tmp_path / "none.json", [10, 50])
    rotor = ross_rotor()
    rotor.K0[0, 5] = 1e9
    with pytest.raises(ValueError, match="K0 couples lateral motion"):
        bumpfoil.write_ross_rotor(rotor, tmp_path / "none.json", [10, 50])
    assert not (tmp_path / "none.json").exists()


def test_stations_are_those_that_are_named(tmp_path):
    rotor = ross_rotor()
    bumpfoil.write_ross_rotor(rotor, tmp_path / "rotor.json", nodes_of(rotor), stations={"wheel": 58})
    written = json.loads((tmp_path / "rotor.json").read_text())
    assert written["station"] == [{"name": "wheel", "z": pytest.approx(0.23), "x": 232, "y": 233}]
    assert len(written["M"]) == 248
