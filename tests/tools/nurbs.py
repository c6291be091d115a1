"""A rational B-spline by the Cox-de Boor recurrence on its basis functions, written from the definition and slow on purpose."""
import bisect
import json
import math

# Gauss-Legendre, eight points on [-1, 1].
NODES = [(0.1834346424956498, 0.3626837833783620), (0.5255324099163290, 0.3137066458778873),
         (0.7966664774136267, 0.2223810344533745), (0.9602898564975363, 0.1012285362903763)]
GAUSS = [(-x, w) for x, w in NODES] + NODES


class Nurbs:
    def __init__(self, data):
        self.degree, self.knots = data["degree"], data["knots"]
        self.points = [tuple(p) + (0.0,) * (3 - len(p)) for p in data["control_points"]]
        self.weights = data.get("weights") or [1.0] * len(self.points)
        self.first, self.last = self.knots[self.degree], self.knots[-self.degree - 1]
        self.distinct = sorted(set(self.knots))

    @classmethod
    def load(cls, path):
        with open(path, encoding="utf-8") as handle:
            return cls(json.load(handle))

    def span(self, u):
        return min(bisect.bisect_right(self.knots, u), len(self.points)) - 1

    def basis(self, span, u, degree):
        """The degree + 1 basis functions that do not vanish on the span."""
        values = [1.0]
        for p in range(1, degree + 1):
            grown = [0.0] * (p + 1)
            for k, value in enumerate(values):
                low, high = self.knots[span - p + 1 + k], self.knots[span + 1 + k]
                grown[k] += value * (high - u) / (high - low)
                grown[k + 1] += value * (u - low) / (high - low)
            values = grown
        return values

    def evaluate(self, u):
        """Position and first derivative by the parameter."""
        u = min(max(u, self.first), self.last)
        span, p = self.span(u), self.degree
        values, lower = self.basis(span, u, p), [0.0, *self.basis(span, u, p - 1), 0.0]
        sums, slopes = [0.0] * 4, [0.0] * 4
        for k, value in enumerate(values):
            i = span - p + k
            slope = 0.0
            if self.knots[i + p] > self.knots[i]:
                slope += p * lower[k] / (self.knots[i + p] - self.knots[i])
            if self.knots[i + p + 1] > self.knots[i + 1]:
                slope -= p * lower[k + 1] / (self.knots[i + p + 1] - self.knots[i + 1])
            for axis, coordinate in enumerate((*self.points[i], 1.0)):
                sums[axis] += value * self.weights[i] * coordinate
                slopes[axis] += slope * self.weights[i] * coordinate
        position = [c / sums[3] for c in sums[:3]]
        return position, [(d - slopes[3] * c) / sums[3] for d, c in zip(slopes[:3], position)]

    def length(self, low, high):
        """Arc length by Gauss-Legendre between the knots; exact to rounding for the short steps of a tick."""
        begin, end = bisect.bisect_right(self.distinct, low), bisect.bisect_left(self.distinct, high)
        cuts, total = [low, *self.distinct[begin:end], high], 0.0
        for a, b in zip(cuts, cuts[1:]):
            centre, half = (a + b) / 2, (b - a) / 2
            total += half * sum(w * math.hypot(*self.evaluate(centre + half * x)[1]) for x, w in GAUSS)
        return total

    def nearest(self, position, guess, low):
        """The parameter of the nearest point at or after `low`, by Newton from the guess; the distance."""
        u, gap = min(max(guess, low), self.last), math.inf
        for _ in range(12):
            here, slope = self.evaluate(u)
            gap = math.dist(here, position)
            step = sum((p - h) * d for p, h, d in zip(position, here, slope)) / sum(d * d for d in slope)
            next_u = min(max(u + step, low), self.last)
            if abs(next_u - u) <= 1e-15 * (self.last - self.first):
                break
            u = next_u
        return u, gap
