"""The push of the reference bearing to the weld, without friction, as one dense system of equations.

Independent of the library but for the constants of the truss. The stiffness of the top foil may be taken with the sign
that [Arghir2019, Eq. 5] prints.
"""

import numpy as np

BUMPS = 26
RADIUS = 19.05e-3
LENGTH = 38.1e-3
PITCH = 4.572e-3
CLEARANCE = 31.8e-6
THICKNESS = 0.102e-3
MODULUS = 214e9 / (1 - 0.29**2)

THETA = (np.arange(BUMPS) + 0.5) * PITCH / RADIUS


def bump_foil_stiffness(truss):
    """Four unknowns per bump: u and v of the crest, u and v of the foot after it [Arghir2019, Eq. 7]."""
    c, s = np.cos(truss["theta_d_rad"]), np.sin(truss["theta_d_rad"])
    K = np.zeros((4 * BUMPS, 4 * BUMPS))

    def add_spring(name, terms):
        elongation = np.zeros(4 * BUMPS)
        for unknown, factor in terms:
            if unknown >= 0:  # before the first bump is the weld
                elongation[unknown] += factor
        K[:] += truss[f"{name}_N_per_m"] * np.outer(elongation, elongation)

    for crest in range(0, 4 * BUMPS, 4):
        foot, foot_before = crest + 2, crest - 2
        add_spring("k1", [(crest, c), (crest + 1, -s), (foot_before, -c), (foot_before + 1, s)])
        add_spring("k1", [(foot, c), (crest, -c), (crest + 1, -s), (foot + 1, s)])
        add_spring("k2", [(foot, 1), (foot_before, -1)])
        add_spring("k3" if crest else "k4", [(crest, 1), (crest - 4, -1)])
    return K


def top_foil_stiffness():
    """Of a clamped circular beam under radial loads at the crests."""
    low, high = np.minimum.outer(THETA, THETA), np.maximum.outer(THETA, THETA)
    stiffness = MODULUS * LENGTH * THICKNESS**3 / 12
    return np.linalg.inv(
        RADIUS**3 / stiffness * (low * np.cos(high - low) / 2 - np.cos(high) * np.sin(low) / 2)
    )


def push_to_weld(truss, displacement, sign=1):
    """Force (N), loads of the journal over the bumps (N) and closed contacts, from a state that contradicts nothing.

    @param sign  of the stiffness of the top foil: -1 as Eq. 5 is printed
    """
    unknowns = 5 * BUMPS
    K = np.zeros((unknowns, unknowns))
    K[: 4 * BUMPS, : 4 * BUMPS] = bump_foil_stiffness(truss)
    K[4 * BUMPS :, 4 * BUMPS :] = sign * top_foil_stiffness()

    # Gaps: journal and top foil, top foil and crest, foot and sleeve.
    gap = np.concatenate([CLEARANCE - displacement * np.cos(THETA), np.zeros(2 * BUMPS)])
    G = np.zeros((3 * BUMPS, unknowns))
    for i in range(BUMPS):
        G[i, 4 * BUMPS + i] = 1
        G[BUMPS + i, [4 * i + 1, 4 * BUMPS + i]] = 1, -1
        G[2 * BUMPS + i, 4 * i + 3] = -1
    closed = np.concatenate([gap[:BUMPS] < 0, gap[:BUMPS] < 0, np.ones(BUMPS, dtype=bool)])

    for _ in range(100):
        force = np.zeros(3 * BUMPS)
        system = np.block([[K, -G[closed].T], [G[closed], np.zeros((closed.sum(), closed.sum()))]])
        solution = np.linalg.solve(system, np.concatenate([np.zeros(unknowns), -gap[closed]]))
        force[closed] = solution[unknowns:]
        # Tensions and penetrations beyond rounding.
        wrong = (force < -1e-7) | (~closed & (gap + G @ solution[:unknowns] < -1e-12))
        if not wrong.any():
            return force[:BUMPS] @ np.cos(THETA), force[:BUMPS], closed
        closed ^= wrong
    raise AssertionError("no state without contradiction was found")
