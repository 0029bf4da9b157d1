"""Rotors of ROSS as files that a case names."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Displacements along x and y and the rotations alpha and beta of a node, among its unknowns by their number.
_LATERAL = {4: (0, 1, 2, 3), 6: (0, 1, 3, 4)}
# Of the largest entry: what is left of a coupling that is none.
_NO_COUPLING = 1e-12


def write_ross_rotor(
    rotor: Any, path: str | os.PathLike[str], bearings: Sequence[int], stations: Mapping[str, int] | None = None
) -> None:
    """Writes a rotor of ROSS 2 as the file that `rotor.matrices` of a case names.

    Shaft, disks and point masses are taken as they are, with the damping of the shaft; bearings and seals of the rotor
    are left out, since the case has its own. Axial motion and torsion are dropped. The speed of a case is positive from
    x to y, as in ROSS.

    Parameters
    ----------
    rotor : ross.Rotor
        With 4 or 6 unknowns per node. Its attributes M0, C0, G0, K0, nodes, nodes_pos, number_dof, disk_elements are read.
    path : str or path
        File to write. An existing one is replaced.
    bearings : sequence of int
        Nodes of the two bearings.
    stations : mapping of names to int, optional
        Nodes of other places that results describe, or with an unbalance; default: both ends and the disks.

    Raises
    ------
    TypeError
        If it is no rotor of ROSS 2.
    ValueError
        If a node does not exist, or the rotor stands on supports with a mass of their own.
    """
    matrices = {}
    for name in "MCGK":
        if not hasattr(rotor, f"{name}0"):
            raise TypeError(f"expected a rotor of ROSS 2, which has {name}0; found {type(rotor).__name__}")
        matrices[name] = np.asarray(getattr(rotor, f"{name}0"), dtype=float)
    nodes, width = len(rotor.nodes), int(rotor.number_dof)
    if width not in _LATERAL:
        raise ValueError(f"the rotor has {width} unknowns per node, not 4 or 6")
    if len(matrices["M"]) != width * nodes:
        raise ValueError("the rotor has supports with a mass of their own: leave them out, and their point masses")
    kept = np.array([width * node + unknown for node in range(nodes) for unknown in _LATERAL[width]])
    dropped = np.setdiff1d(np.arange(width * nodes), kept)
    lateral: dict[str, NDArray[Any]] = {}
    for name, matrix in matrices.items():
        coupling = max((np.abs(matrix[np.ix_(*two)]).max(initial=0.0) for two in ((kept, dropped), (dropped, kept))), default=0.0)
        if coupling > _NO_COUPLING * np.abs(matrix).max():
            raise ValueError(f"{name}0 couples lateral motion with axial motion or torsion")
        lateral[name] = matrix[np.ix_(kept, kept)]

    places = [int(node) for node in rotor.nodes]

    def place(name: str, node: int) -> dict[str, Any]:
        if node not in places:
            raise ValueError(f"the rotor has no node {node}; it has {places[0]} to {places[-1]}")
        number = places.index(node)
        return {"name": name, "z": float(rotor.nodes_pos[number]), "x": 4 * number, "y": 4 * number + 1}

    if stations is None:
        stations = {"begin": places[0]}
        stations.update({f"disk {i}": int(disk.n) for i, disk in enumerate(rotor.disk_elements, start=1)})
        stations["end"] = places[-1]
    written: dict[str, Any] = {name: matrix.tolist() for name, matrix in lateral.items()}
    written["bearing"] = [place(f"bearing {i}", node) for i, node in enumerate(bearings, start=1)]
    written["station"] = [place(name, node) for name, node in stations.items()]
    with open(path, "w", encoding="utf-8") as file:
        json.dump(written, file)
