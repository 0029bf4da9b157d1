"""What the checks need of CalculiX: decks, runs, and the stiffness matrix of a foil.

Decks are in N and mm. CalculiX reads 20 characters of a number and no more.
"""

import os
import subprocess
from pathlib import Path

import numpy as np
import scipy.sparse as sparse

YOUNGS_MODULUS = 214e9
POISSON_RATIO = 0.29
AXIAL_LENGTH = 38.1e-3

MM = 1e-3
MATERIAL = f"""*MATERIAL, NAME=METAL
*ELASTIC
{YOUNGS_MODULUS * MM**2}, {POISSON_RATIO}
*DENSITY
7.85e-9
"""


def run(folder, name, deck):
    """Runs CalculiX on a deck, on one thread and out of the way of others; returns its output."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.inp").write_text(deck, encoding="utf-8")
    done = subprocess.run(["nice", "ccx", name], cwd=folder, env=dict(os.environ, OMP_NUM_THREADS="1"),
                          capture_output=True, text=True)
    (folder / f"{name}.log").write_text(done.stdout + done.stderr, encoding="utf-8")
    return done.stdout


def lines(numbers, per_line=12):
    """Numbers as the data lines of a card."""
    words = [str(number) for number in numbers]
    return ",\n".join(", ".join(words[i:i + per_line]) for i in range(0, len(words), per_line)) + "\n"


def extruded_deck(mesh, width):
    """One layer of C3D20R bricks that may not move axially. Returns the deck and, per brick node, its plane node."""
    count = len(mesh.nodes)
    corners = mesh.corners
    middle = {corner: 2 * count + k for k, corner in enumerate(corners)}
    plane_node = np.concatenate([np.arange(count), np.arange(count), corners])
    z = np.concatenate([np.zeros(count), np.full(count, width), np.full(len(corners), width / 2)])
    deck = ["*NODE, NSET=ALL\n"]
    xy = mesh.nodes / MM
    deck += [f"{k + 1}, {xy[n, 0]:.11e}, {xy[n, 1]:.11e}, {z[k] / MM:.6e}\n" for k, n in enumerate(plane_node)]
    deck.append("*ELEMENT, TYPE=C3D20R, ELSET=FOIL\n")
    for number, quad in enumerate(mesh.quads, 1):
        bricks = [*quad[:4], *(quad[:4] + count), *quad[4:], *(quad[4:] + count), *(middle[c] for c in quad[:4])]
        deck.append(lines([number, *(n + 1 for n in bricks)]))
    deck.append(MATERIAL + "*SOLID SECTION, ELSET=FOIL, MATERIAL=METAL\n*BOUNDARY\nALL, 3, 3\n")
    return "".join(deck), plane_node


def plane_stiffness(folder, name, mesh):
    """Stiffness of a foil in plane strain over the axial length, N/m; unknowns u, v of every node. Nothing clamped.

    CalculiX stores the matrix of the bricks; here both faces and the nodes between are made to move alike.
    """
    width = 1e-4
    deck, plane_node = extruded_deck(mesh, width)
    run(folder, name, deck + "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n*END STEP\n")
    entries = np.loadtxt(Path(folder) / f"{name}.sti")
    dofs = (Path(folder) / f"{name}.dof").read_text().split()
    row, column = entries[:, 0].astype(int) - 1, entries[:, 1].astype(int) - 1
    half = sparse.coo_matrix((entries[:, 2], (row, column)), shape=(len(dofs),) * 2).tocsr()
    whole = half + half.T - sparse.diags(half.diagonal())
    node, direction = np.array([[int(part) for part in dof.split(".")] for dof in dofs]).T
    unknown = 2 * plane_node[node - 1] + direction - 1
    tie = sparse.coo_matrix((np.ones(len(dofs)), (np.arange(len(dofs)), unknown)),
                            shape=(len(dofs), 2 * len(mesh.nodes)))
    return (tie.T @ whole @ tie * (AXIAL_LENGTH / width / MM)).tocsc()
