"""The jerk-limited time optimum along a curve, found in another way than Kerf's.

b(s) = v^2 on a grid; with sqrt(b) of the iterate before held, the limits of acceleration and jerk are linear in b, and the
time is convex: a log barrier and Newton's method with a banded matrix, again and again until the time stands still.

At rest j = sqrt(b) b'' / 2 vanishes whatever b'' is, so on an even grid the acceleration may jump there. A motion `from_rest`
has its jerk there, too: the grid becomes finer towards both ends by a tenth a cell, down to 10 nm, and in its first cell
v <= J t^2 / 2 with s = J t^3 / 6. A line then takes L / V + V / A + A / J, its closed form.

Weak: the optimum is a local one. Ticks are not known, only the chord limit's ceiling of v. Limits of axes are kept at the
points of the grid, so what is narrower than a cell may be unseen and the time too short."""
import numpy as np
from scipy.linalg import LinAlgError, solveh_banded

FIRST_CELL_MM = 1e-5
PERIOD_S = 1e-3


class Problem:
    """limits: (V, A, J, chord) in mm and s. on_axes: A and J on each axis instead of along the path."""

    def __init__(self, curve, limits, on_axes, cell_mm, from_rest):
        v_mm_s, self.a_mm_s2, self.j_mm_s3, chord_mm = limits
        self.on_axes = on_axes
        self.s = finer_to_its_ends(curve.length_mm, cell_mm) if from_rest else even(curve.length_mm, cell_mm)
        self.q = curve.by_arc_length(self.s)
        self.ceiling = np.full(len(self.s) - 2, float(v_mm_s) ** 2)
        for share in np.linspace(-0.5, 0.5, 11):  # curvature may have peaks narrower than a cell
            between = self.s[1:-1] + share * np.where(share < 0, np.diff(self.s)[:-1], np.diff(self.s)[1:])
            self.ceiling = np.minimum(self.ceiling, chord_ceiling(curve, between, chord_mm))
        self.weights = np.ones(len(self.s) - 1)  # of a cell's 2 h / (v + v)
        if from_rest:
            self.weights[[0, -1]] = 1.5  # v goes with s^(2/3) there
            for point, end in ((0, 0), (-1, -1)):
                jerk = self.j_mm_s3 / (np.max(np.abs(self.q[0][end])) if on_axes else 1.0)
                launch = (jerk / 2 * (6 * FIRST_CELL_MM / jerk) ** (2 / 3)) ** 2
                self.ceiling[point] = min(self.ceiling[point], launch)
        h, g = np.diff(self.s)[:-1], np.diff(self.s)[1:]
        self.value = np.array([0 * h, 1 + 0 * h, 0 * h])
        self.slope = np.array([-g / (h * (h + g)), (g - h) / (h * g), h / (g * (h + g))])
        self.bend = np.array([2 / (h * (h + g)), -2 / (h * g), 2 / (g * (h + g))])

    def limits(self, b=None):
        """Stencils (3 x points) whose products with b stay between -1 and 1; of the jerk only with the b to hold."""
        root = None if b is None else np.sqrt(b)
        if not self.on_axes:
            along = [0.5 * self.slope / self.a_mm_s2]
            return along if b is None else along + [root * 0.5 * self.bend / self.j_mm_s3]
        found = []
        for q1, q2, q3 in zip(*(q[1:-1].T for q in self.q)):
            if np.any(np.abs(q1) > 1e-9):
                found.append((0.5 * q1 * self.slope + q2 * self.value) / self.a_mm_s2)
                if b is not None:
                    found.append(root * (0.5 * q1 * self.bend + 1.5 * q2 * self.slope + q3 * self.value) / self.j_mm_s3)
        return found

    def time_s(self, b):
        v = np.sqrt(padded(b))
        return (self.weights * 2 * np.diff(self.s) / (v[1:] + v[:-1])).sum()

    def optimum(self, rounds=40):
        """Time and the largest figure over its limit, of acceleration and jerk."""
        b = least_time(self, self.limits())
        before = np.inf
        for _ in range(rounds):
            b = least_time(self, self.limits(b))
            time = self.time_s(b)
            if abs(time - before) < 3e-5 * time:
                break
            before = time
        return time, max(np.max(np.abs(product(stencil, b))) for stencil in self.limits(b))


def chord_ceiling(curve, s_mm, chord_mm):
    """v^2 at which a tick's chord is as far from the curve as it may be."""
    radius = 1 / np.maximum(np.linalg.norm(curve.by_arc_length(s_mm)[1], axis=1), 1e-12)
    return (2 / PERIOD_S) ** 2 * np.maximum(2 * radius * chord_mm - chord_mm**2, 1e-12)


def even(length_mm, cell_mm):
    return np.linspace(0.0, length_mm, round(length_mm / cell_mm) + 1)


def finer_to_its_ends(length_mm, cell_mm):
    s, cell = [0.0], FIRST_CELL_MM
    while cell < cell_mm and s[-1] < length_mm / 2:
        s.append(s[-1] + cell)
        cell *= 1.1
    s = np.array(s)
    middle = np.linspace(s[-1], length_mm - s[-1], int(np.ceil((length_mm - 2 * s[-1]) / cell_mm)) + 1)
    return np.concatenate([s[:-1], middle, (length_mm - s[:-1])[::-1]])


def padded(b):
    return np.concatenate([[0.0], b, [0.0]])


def product(stencil, b):
    b = padded(b)
    return stencil[0] * b[:-2] + stencil[1] * b[1:-1] + stencil[2] * b[2:]


def least_time(problem, stencils):
    """The b of the least time under linear limits, to 2e-4 of it by the barrier's bound."""
    b = inside(problem, stencils)
    weight = 1e3
    while True:
        b = centre(problem, stencils, b, weight)
        if len(b) * (2 + 2 * len(stencils)) < 2e-4 * weight * problem.time_s(b):
            return b
        weight *= 8


def inside(problem, stencils):
    """A slow motion is within every limit, for b = 0 is."""
    shape = np.minimum(np.minimum(problem.s, problem.s[-1] - problem.s)[1:-1] ** (4 / 3), 1.0)
    while np.any(shape >= 0.5 * problem.ceiling) or any(np.any(np.abs(product(c, shape)) >= 0.5) for c in stencils):
        shape = 0.3 * shape
    return shape


def barrier(problem, stencils, b, weight):
    if np.any(b <= 0) or np.any(b >= problem.ceiling):
        return np.inf
    products = [product(c, b) for c in stencils]
    if any(np.any(np.abs(p) >= 1) for p in products):
        return np.inf
    return weight * problem.time_s(b) - np.log(problem.ceiling - b).sum() - sum(np.log1p(-p * p).sum() for p in products)


def centre(problem, stencils, b, weight):
    for _ in range(60):
        gradient, band = newton(problem, stencils, b, weight)
        step = -solve_band(band, gradient)
        fall = -(gradient * step).sum()
        if fall < 1e-6:
            break
        here, share = barrier(problem, stencils, b, weight), 1.0
        while share > 1e-12 and not barrier(problem, stencils, b + share * step, weight) <= here - 0.1 * share * fall:
            share *= 0.5
        if share <= 1e-12:
            break
        b = b + share * step
    return b


def newton(problem, stencils, b, weight):
    """Gradient, and the Hessian's diagonal with the two below it."""
    n = len(b)
    v = np.sqrt(padded(b))
    both = v[1:] + v[:-1]
    first = -2 * problem.weights * np.diff(problem.s) / both**2  # of the time by v, alike for both ends of a cell
    second = -2 * first / both
    by_b = 0.5 / v[1:-1]
    gradient = weight * (first[1:] + first[:-1]) * by_b + 1 / (problem.ceiling - b)
    band = np.zeros((3, n))
    band[0] = weight * ((second[1:] + second[:-1]) * by_b**2 - (first[1:] + first[:-1]) * 0.25 / v[1:-1] ** 3)
    band[0] += 1 / (problem.ceiling - b) ** 2
    band[1, :-1] = weight * second[1:-1] * by_b[1:] * by_b[:-1]
    for c in stencils:
        p = product(c, b)
        push, stiffness = 1 / (1 - p) - 1 / (1 + p), 1 / (1 - p) ** 2 + 1 / (1 + p) ** 2
        gradient[:-1] += (c[0] * push)[1:]
        gradient += c[1] * push
        gradient[1:] += (c[2] * push)[:-1]
        band[0, :-1] += (c[0] ** 2 * stiffness)[1:]
        band[0] += c[1] ** 2 * stiffness
        band[0, 1:] += (c[2] ** 2 * stiffness)[:-1]
        band[1, :-1] += (c[0] * c[1] * stiffness)[1:] + (c[1] * c[2] * stiffness)[:-1]
        band[2, :-2] += (c[0] * c[2] * stiffness)[1:-1]
    return gradient, band


def solve_band(band, right):
    """With the diagonal scaled to ones, and as little added to it as the factorisation needs."""
    scale = 1 / np.sqrt(band[0])
    scaled = np.array([np.ones_like(scale), band[1], band[2]])
    scaled[1, :-1] *= scale[:-1] * scale[1:]
    scaled[2, :-2] *= scale[:-2] * scale[2:]
    added = 0.0
    while True:
        try:
            scaled[0] = 1.0 + added
            return scale * solveh_banded(scaled, right * scale, lower=True)
        except LinAlgError:
            added = max(1e-13, 10 * added)
