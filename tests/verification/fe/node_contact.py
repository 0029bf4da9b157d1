"""Unilateral contact with Coulomb friction at points of elastic bodies, on their condensed compliance.

A small solver of its own, for comparison: dense, slow and with nothing in common with the library's. A contact c has
the gap g = g0 + normal_c x and the tangential place s = tangential_c x; its compression p >= 0 acts on x as
normal_c' p and its friction as tangential_c' t.
"""

from dataclasses import dataclass

import numpy as np
import scipy.linalg
import scipy.sparse as sparse
import scipy.sparse.linalg

OPEN, STICK, FORWARD, BACKWARD = range(4)


@dataclass
class State:
    """Forces (N), gaps and places (m) of all contacts."""

    mode: np.ndarray
    normal: np.ndarray
    friction: np.ndarray
    gap: np.ndarray
    place: np.ndarray


class NotConverged(Exception):
    pass


class NodeContact:
    """Contacts on a stiffness matrix whose clamped unknowns are left out.

    @param K           stiffness, N/m, sparse
    @param normal      contacts x unknowns, sparse
    @param tangential  the same; an empty row where a contact has no friction
    @param friction    coefficient of each contact
    """

    def __init__(self, K, normal, tangential, friction):
        B = sparse.vstack([normal, tangential]).tocsc()
        factors = scipy.sparse.linalg.splu(K.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                                           options={"SymmetricMode": True})
        compliance = B @ factors.solve(B.T.toarray())
        self.W = (compliance + compliance.T) / 2
        self.friction = np.asarray(friction, dtype=float)
        self.count = len(self.friction)
        self.solves = 0

    def unstressed(self):
        zero = np.zeros(self.count)
        return State(np.full(self.count, OPEN), zero, zero, zero, zero)

    def solve_modes(self, gap0, place0, mode):
        """Forces, gaps and places when the modes are known."""
        n = self.count
        closed, stuck = np.flatnonzero(mode != OPEN), np.flatnonzero((mode == STICK) & (self.friction > 0))
        # Unknown are the compressions of closed contacts, which bring the friction of slipping ones, and the friction
        # of stuck ones.
        sign = np.where(mode == FORWARD, -1.0, np.where(mode == BACKWARD, 1.0, 0.0))
        drag = (sign * self.friction)[closed]
        rows = np.concatenate([closed, n + stuck])
        reached = np.hstack([self.W[np.ix_(rows, closed)] + self.W[np.ix_(rows, n + closed)] * drag,
                             self.W[np.ix_(rows, n + stuck)]])
        unknown = scipy.linalg.solve(reached, np.concatenate([-gap0[closed], place0[stuck]]))
        force = np.zeros(2 * n)
        force[closed] = unknown[: len(closed)]
        force[n + closed] = drag * unknown[: len(closed)]
        force[n + stuck] = unknown[len(closed):]
        moved = self.W @ force
        self.solves += 1
        return State(mode, force[:n], force[n:], gap0 + moved[:n], moved[n:])

    def errors(self, state, place0):
        """By how much each contact contradicts its mode, as forces, and the mode that it should have instead."""
        mode, f = state.mode, self.friction
        scale = max(1.0, state.normal.max())
        stiffness = 1.0 / self.W.diagonal()[: self.count]
        slip = state.place - place0
        error, better = np.zeros(self.count), mode.copy()

        def mark(where, size, new):
            error[where], better[where] = size[where], new[where] if np.ndim(new) else new

        tension = (mode != OPEN) & (state.normal < -1e-7 * scale)
        mark(tension, -state.normal, OPEN)
        closing = np.where((f == 0) | (slip == 0), STICK, np.where(slip > 0, FORWARD, BACKWARD))
        mark((mode == OPEN) & (state.gap < -1e-11), -state.gap * stiffness, closing)
        bound = f * state.normal
        excess = (mode == STICK) & (f > 0) & ~tension & (np.abs(state.friction) > bound + 1e-7 * scale)
        mark(excess, np.abs(state.friction) - bound, np.where(state.friction < 0, FORWARD, BACKWARD))
        wrong = ~tension & (((mode == FORWARD) & (slip < -1e-11)) | ((mode == BACKWARD) & (slip > 1e-11)))
        mark(wrong, np.abs(slip) * stiffness, STICK)
        return error, better

    def increment(self, gap0, before, rounds=300):
        """State under new gaps of the unloaded bodies; slips count from the state before."""
        mode = before.mode.copy()
        seen = set()
        chance = np.random.default_rng(1)
        # One contact at a time, the worst first: all at once would run in circles. Where this does too, chance leads
        # out of them.
        for _ in range(rounds):
            state = self.solve_modes(gap0, before.place, mode)
            error, better = self.errors(state, before.place)
            if not error.any():
                return state
            chosen = np.argmax(error)
            if mode.tobytes() in seen:
                chosen = chance.choice(np.flatnonzero(error))
            seen.add(mode.tobytes())
            mode = mode.copy()
            mode[chosen] = better[chosen]
        raise NotConverged

    def advance(self, gap_start, gap_end, before, depth=0):
        """One increment, halved as often as needed. Returns the state and the number of solved increments."""
        try:
            return self.increment(gap_end, before), 1
        except (NotConverged, np.linalg.LinAlgError):
            if depth == 12:
                raise NotConverged from None
        middle = (gap_start + gap_end) / 2
        state, first = self.advance(gap_start, middle, before, depth + 1)
        state, second = self.advance(middle, gap_end, state, depth + 1)
        return state, first + second
