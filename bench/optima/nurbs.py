"""A curve of a shipped program by its arc length, with three derivatives: nothing of it shared with Kerf's own curves."""
import re

import numpy as np

KNOT_LINE = re.compile(r"^(?:G6\.2 P(?P<order>\d+) )?K(?P<knot>\S+)(?: X(?P<x>\S+) Y(?P<y>\S+))?(?: Z(?P<z>\S+))?(?: R(?P<r>\S+))?")
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


class Nurbs:
    """C(u) with its control points (n x 3, mm), weights, degree and knots."""

    def __init__(self, points_mm, weights, degree, knots):
        self.homogeneous = np.column_stack([points_mm * weights[:, None], weights])
        self.degree = degree
        self.knots = knots
        spans = np.unique(knots[degree : len(knots) - degree])
        self.u = np.concatenate([np.linspace(a, b, 400, endpoint=False) for a, b in zip(spans[:-1], spans[1:])] + [spans[-1:]])
        self.s_mm = np.concatenate([[0.0], np.cumsum(self._lengths_mm(self.u[:-1], self.u[1:]))])
        self.length_mm = self.s_mm[-1]

    @staticmethod
    def of_program(path):
        """The G6.2 of a program with a knot a line."""
        knots, points, weights = [], [], []
        degree = None
        for line in path.read_text().splitlines():
            word = KNOT_LINE.match(line)
            if not word:
                continue
            degree = int(word["order"]) - 1 if word["order"] else degree
            knots.append(float(word["knot"]))
            if word["x"]:
                points.append([float(word["x"]), float(word["y"]), float(word["z"] or 0.0)])
                weights.append(float(word["r"] or 1.0))
        return Nurbs(np.array(points), np.array(weights), degree, np.array(knots))

    def derivatives(self, u):
        """C, C', C'', C''' by u."""
        points, degree, knots = self.homogeneous, self.degree, self.knots
        of = []
        for _ in range(4):
            of.append(de_boor(points, degree, knots, u) if degree >= 0 else np.zeros((len(u), 4)))
            if degree > 0:
                width = knots[degree + 1 : degree + len(points)] - knots[1 : len(points)]
                points = degree * np.diff(points, axis=0) / np.where(width > 0, width, 1.0)[:, None]
                knots = knots[1:-1]
            degree -= 1
        a, w = [d[:, :3] for d in of], [d[:, 3:] for d in of]
        c = a[0] / w[0]
        c1 = (a[1] - w[1] * c) / w[0]
        c2 = (a[2] - 2 * w[1] * c1 - w[2] * c) / w[0]
        c3 = (a[3] - 3 * w[1] * c2 - 3 * w[2] * c1 - w[3] * c) / w[0]
        return c, c1, c2, c3

    def by_arc_length(self, s_mm):
        """q', q'', q''' by s."""
        _, c1, c2, c3 = self.derivatives(self._parameter(s_mm))
        dot = lambda x, y: (x * y).sum(axis=1)[:, None]
        v = np.sqrt(dot(c1, c1))
        q1 = c1 / v
        q2 = c2 / v**2 - c1 * dot(c1, c2) / v**4
        q3 = c3 / v**3 - (3 * c2 * dot(c1, c2) + c1 * (dot(c2, c2) + dot(c1, c3))) / v**5 + 4 * c1 * dot(c1, c2) ** 2 / v**7
        return q1, q2, q3

    def _lengths_mm(self, a, b):
        middle, half = 0.5 * (a + b), 0.5 * (b - a)
        return half * sum(w * np.linalg.norm(self.derivatives(middle + half * x)[1], axis=1) for x, w in zip(NODES, WEIGHTS))

    def _parameter(self, s_mm):
        i = np.clip(np.searchsorted(self.s_mm, s_mm, side="right") - 1, 0, len(self.u) - 2)
        low, high = self.u[i], self.u[i + 1]
        u = low + (s_mm - self.s_mm[i]) / (self.s_mm[i + 1] - self.s_mm[i]) * (high - low)
        for _ in range(4):
            too_far_mm = self.s_mm[i] + self._lengths_mm(low, u) - s_mm
            u = np.clip(u - too_far_mm / np.linalg.norm(self.derivatives(u)[1], axis=1), low, high)
        return u


def de_boor(points, degree, knots, u):
    span = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, len(points) - 1)
    d = [points[span - degree + j] for j in range(degree + 1)]
    for level in range(1, degree + 1):
        for j in range(degree, level - 1, -1):
            low, high = knots[span - degree + j], knots[span + 1 + j - level]
            share = ((u - low) / np.where(high > low, high - low, 1.0))[:, None]
            d[j] = (1 - share) * d[j - 1] + share * d[j]
    return d[degree]
