#!/usr/bin/env python3
"""Draws the pictures of docs/math.md from closed forms, without the program.

    draw_math_pictures.py [FOLDER]

FOLDER is where the pictures go (default: docs/pictures of this checkout). The same bytes everywhere; a test holds the committed
pictures against a fresh run. Python standard library only.
"""
import json
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
from math_drawing import BLUE, GREEN, GREY, INK, ORANGE, RED, VIOLET, Axes, Picture  # noqa: E402


# --- Profiles: phi, phi', phi'' of x in [0, 1/2]; the second half mirrors them.

def mirrored(first_half):
    def shape(x):
        if x <= 0.5:
            return first_half(x)
        phi, slope, bend = first_half(1.0 - x)
        return 1.0 - phi, slope, -bend
    return shape


def s_curve(share):
    peak = 1.0 / (1.0 - share)

    def first_half(x):
        if x < share:
            return peak * x * x / share / 2, peak * x / share, peak / share
        return peak * (x - share / 2), peak, 0.0
    return mirrored(first_half)


def sine(x):
    angle = math.pi * (x - 0.5)
    return 0.5 * (1 + math.sin(angle)), 0.5 * math.pi * math.cos(angle), -0.5 * math.pi ** 2 * math.sin(angle)


def quintic(x):
    return x ** 3 * (10 - 15 * x + 6 * x * x), 30 * (x * (1 - x)) ** 2, 60 * x * (1 - x) * (1 - 2 * x)


def sine_series(r):
    def shape(x):
        c, s = math.cos(2 * math.pi * x), math.sin(2 * math.pi * x)
        d = 1 - 2 * r * c + r * r
        phi = x - (1 - r) / (2 * math.pi * r) * math.atan2(r * s, 1 - r * c)
        return phi, (1 + r) * (1 - c) / d, 2 * math.pi * (1 + r) * (1 - r) ** 2 * s / d ** 2
    return shape


def sigmoid(s):
    def logistic(x):
        return 1 / (1 + math.exp(-x))
    c = 2 * logistic(s) - 1

    def middle(x):
        f = logistic(2 * s * x - s)
        return (f - logistic(-s)) / c, 2 * s * f * (1 - f) / c, 4 * s * s * f * (1 - f) * (1 - 2 * f) / c
    p, q, _ = middle(1 / 3)
    b1, b2 = 9 * q - 54 * p, 27 * p - 3 * q

    def first_half(x):
        return (b1 * x ** 3 + b2 * x * x, 3 * b1 * x * x + 2 * b2 * x, 6 * b1 * x + 2 * b2) if x < 1 / 3 else middle(x)
    return mirrored(first_half)


def duration(shape, change, limits):
    """T = max(a* dv / A, sqrt(j* dv / J)), with the peaks looked for on a fine grid."""
    values = [shape(k / 3000) for k in range(3001)]
    return max(max(v[1] for v in values) * change / limits[0], math.sqrt(max(abs(v[2]) for v in values) * change / limits[1]))


def fastest(family, low, high, change, limits):
    return min((family(low + (high - low) * k / 200) for k in range(201)), key=lambda shape: duration(shape, change, limits))


def s_curve_duration(change, limits):
    a, j = limits
    return change / a + a / j if change > a * a / j else 2 * math.sqrt(change / j)


def draw_profiles(folder):
    change, limits = 100.0, (2000.0, 50000.0)
    share = limits[0] / limits[1] / s_curve_duration(change, limits)
    laws = [("trapezoid", lambda x: (x, 1.0, 0.0), GREY, change / limits[0]),
            ("s-curve", s_curve(share), BLUE, s_curve_duration(change, limits))]
    for name, shape, colour in (("sigmoid", fastest(sigmoid, 1.7, 3.3112, change, limits), GREEN), ("sine", sine, RED),
                                ("quintic", quintic, ORANGE),
                                ("sine-series", fastest(sine_series, 0.1231, 0.6, change, limits), VIOLET)):
        laws.append((name, shape, colour, duration(shape, change, limits)))
    picture = Picture(760, 640, "Feedrate, acceleration and jerk of the profiles under the same limits")
    rows = [("v [mm/s]", change, [0, 50, 100], (0, 110)), ("a [mm/s²]", change, [0, 1000, 2000], (0, 2250)),
            ("j [mm/s³]", change, [-50000, 0, 50000], (-56000, 56000))]
    for row, (label, scale, marks, span) in enumerate(rows):
        axes = Axes(picture, (70, 40 + 195 * row, 530, 145), (0, 120), span)
        axes.frame([0, 20, 40, 60, 80, 100, 120], marks, "t [ms]" if row == 2 else "", label)
        for name, shape, colour, time in laws:
            if name == "trapezoid" and row == 2:
                continue
            pieces = [(0.0, 1.0)]
            if row > 0:  # acceleration has corners where the pieces of a law meet, and jerk jumps
                cuts = {"s-curve": [share, 1 - share], "sigmoid": [1 / 3, 2 / 3]}.get(name, [])
                pieces = list(zip([0.0] + cuts, cuts + [1.0]))
            points = [(0, 0)] if row == 2 or name == "trapezoid" and row == 1 else []
            for begin, end in pieces:
                steps = 2 if name in ("s-curve", "trapezoid") and row > 0 else 48 // len(pieces)
                inside = [begin + (end - begin) * min(max(k / steps, 1e-9), 1 - 1e-9) for k in range(steps + 1)]
                points += [(1e3 * time * x, scale * shape(x)[row] / time ** row) for x in inside]
            points += [(1e3 * time, 0)] if row == 2 or name == "trapezoid" and row == 1 else []
            axes.points(points, colour, width=1.8)
    for k, (name, _, colour, time) in enumerate(laws):
        y = 60 + 38 * k
        picture.line([(615, y - 4), (640, y - 4)], colour, 2.5)
        picture.text(646, y, name)
        picture.text(646, y + 15, f"{1e3 * time:.1f} ms", GREY, size=11)
    picture.text(615, 330, "0 to 100 mm/s", size=12)
    picture.text(615, 347, "A = 2000 mm/s²", size=12)
    picture.text(615, 364, "J = 50 000 mm/s³", size=12)
    picture.text(615, 470, "the trapezoid's", GREY, size=11)
    picture.text(615, 484, "jerk is unbounded", GREY, size=11)
    picture.save(folder, "profiles.svg")


# --- Curves

def bezier(points, weights, x):
    """Point and derivative of a rational Bezier curve at x in [0, 1]."""
    n = len(points) - 1

    def value(values, degree):
        return sum(math.comb(degree, i) * x ** i * (1 - x) ** (degree - i) * v for i, v in enumerate(values))
    columns = [[w * p[axis] for p, w in zip(points, weights)] for axis in (0, 1)] + [list(weights)]
    at = [value(c, n) for c in columns]
    slope = [n * value([b - a for a, b in zip(c, c[1:])], n - 1) for c in columns]
    place = (at[0] / at[2], at[1] / at[2])
    return place, tuple((slope[k] - place[k] * slope[2]) / at[2] for k in (0, 1))


def draw_arc_length(folder):
    points, weights = [(0, 0), (8, 44), (30, 52), (78, 40)], [1, 1, 2, 1]
    count = 4000
    speeds = [math.hypot(*bezier(points, weights, k / count)[1]) for k in range(count + 1)]
    lengths = [0.0]
    for a, b in zip(speeds, speeds[1:]):
        lengths.append(lengths[-1] + 0.5 * (a + b) / count)
    total = lengths[-1]

    def u_of(s):
        k = next(i for i, length in enumerate(lengths) if length >= s - 1e-12)
        return k / count if k == 0 else (k - 1 + (s - lengths[k - 1]) / (lengths[k] - lengths[k - 1])) / count
    picture = Picture(760, 290, "A curve by its parameter and by arc length")
    left = Axes(picture, (50, 40, 330, 190), (0, 80), (0, 50))
    left.frame([0, 20, 40, 60, 80], [0, 25, 50], "x [mm]", "y [mm]")
    left.points([bezier(points, weights, k / 60)[0] for k in range(61)], GREY)
    for k in range(11):
        left.dot(*bezier(points, weights, k / 10)[0], RED, radius=4.5, hollow=True)
        left.dot(*bezier(points, weights, u_of(total * k / 10))[0], BLUE, radius=2.6)
    picture.dot(205, 180, RED, 4.5, True)
    picture.text(216, 184, "equal steps of u", size=12)
    picture.dot(205, 200, BLUE, 2.6)
    picture.text(216, 204, "equal steps of s", size=12)
    right = Axes(picture, (450, 40, 280, 190), (0, 110), (0, 1))
    right.frame([0, 25, 50, 75, 100], [0, 0.5, 1], "s [mm]", "u")
    top = [total * k / 60 for k in range(61)]
    right.points([(s, u_of(s)) for s in top], INK)
    for k in range(10):  # Chebyshev-Lobatto points of u
        x = 0.5 - 0.5 * math.cos(math.pi * k / 9)
        right.dot(lengths[round(x * count)], x, GREEN, radius=3.5)
    picture.text(594, 184, "ten pairs (s, u)", GREEN, size=12)
    picture.text(594, 200, "at Chebyshev points of u", GREEN, size=12)
    picture.save(folder, "arc-length.svg")


def draw_chord(folder):
    picture = Picture(760, 300, "Chord error of a tick")
    radius, centre = 250.0, (240.0, 285.0)
    half = 0.62

    def on(angle, r=radius):
        return centre[0] + r * math.sin(angle), centre[1] - r * math.cos(angle)
    picture.line([on(-0.8 + 1.6 * k / 60) for k in range(61)], BLUE, 2)
    begin, end, top, foot = on(-half), on(half), on(0), on(0, radius * math.cos(half))
    picture.line([begin, end], RED, 2)
    picture.line([begin, centre, end], GREY, 1, "4 3")
    picture.line([centre, top], GREY, 1, "4 3")
    picture.line([foot, top], GREEN, 2.5)
    picture.dot(*begin)
    picture.dot(*end)
    picture.dot(*centre, GREY)
    picture.text(*[v + d for v, d in zip(top, (8, 30))], "δ", GREEN, size=15)
    picture.text(150, 102, "L = v Ts", RED, "middle")
    picture.text(begin[0] - 10, begin[1] - 6, "tick n", INK, "end", 12)
    picture.text(end[0] + 10, end[1] - 6, "tick n + 1", INK, "start", 12)
    picture.text(*[v + d for v, d in zip(on(0.42, 150), (12, 8))], "ρ", GREY, size=15)
    picture.text(centre[0] + 6, 175, "ρ - δ", GREY, size=13)
    axes = Axes(picture, (510, 40, 220, 200), (0, 10), (0, 250))
    axes.frame([0, 2, 4, 6, 8, 10], [0, 50, 100, 150, 200, 250], "radius ρ [mm]", "v [mm/s], Ts = 1 ms")
    for tolerance, colour, name in ((1e-3, ORANGE, "δ = 1 µm"), (5e-4, BLUE, "0.5 µm"), (1e-4, GREEN, "0.1 µm")):
        def speed(rho, d=tolerance):
            return 2e3 * math.sqrt(max(2 * rho * d - d * d, 0.0))
        axes.points([(10 * (k / 50) ** 2, speed(10 * (k / 50) ** 2)) for k in range(51) if speed(10 * (k / 50) ** 2) <= 250], colour)
        x = 4.6 if tolerance == 1e-3 else 7.6
        picture.text(axes.at(x, 0)[0], axes.at(0, speed(x))[1] - 8, name, colour, "end", 12)
    picture.save(folder, "chord.svg")


# --- The butterfly's ceiling by the closed form of a constant radius

def spline(data):
    degree, knots = data["degree"], data["knots"]
    points = [(w * p[0], w * p[1], w) for p, w in zip(data["control_points"], data["weights"])]

    def evaluate(control, degree_now, span_knots, u, k):
        d = [list(control[k - degree_now + j]) for j in range(degree_now + 1)]
        for r in range(1, degree_now + 1):
            for j in range(degree_now, r - 1, -1):
                low, high = span_knots[k - degree_now + j], span_knots[j + 1 + k - r]
                share = (u - low) / (high - low)
                d[j] = [(1 - share) * a + share * b for a, b in zip(d[j - 1], d[j])]
        return d[degree_now]
    rows, degrees, all_knots = [points], [degree], [knots]
    for _ in range(2):
        control, p, t = rows[-1], degrees[-1], all_knots[-1]
        rows.append([[p * (b - a) / (t[i + p + 1] - t[i + 1]) if t[i + p + 1] > t[i + 1] else 0.0
                      for a, b in zip(control[i], control[i + 1])] for i in range(len(control) - 1)])
        degrees.append(p - 1)
        all_knots.append(t[1:-1])

    def derivatives(u):
        values = []
        for control, p, t in zip(rows, degrees, all_knots):
            k = max(i for i in range(p, len(control)) if t[i] <= u)
            values.append(evaluate(control, p, t, u, k))
        f, f1, f2 = values
        c = [f[i] / f[2] for i in (0, 1)]
        c1 = [(f1[i] - c[i] * f1[2]) / f[2] for i in (0, 1)]
        c2 = [(f2[i] - 2 * c1[i] * f1[2] - c[i] * f2[2]) / f[2] for i in (0, 1)]
        return c, c1, c2
    return derivatives


def butterfly_ceiling(count=8000, tolerance=5e-4, period=1e-3, cap=100.0):
    """[(s, v)] at equal steps of u."""
    derivatives = spline(json.loads((ROOT / "tests/programs/curves/butterfly.json").read_text(encoding="utf-8")))
    samples, s, before = [], 0.0, None
    for k in range(count + 1):
        _, c1, c2 = derivatives(k / count)
        speed = math.hypot(*c1)
        s += 0.0 if before is None else 0.5 * (before + speed) / count
        before = speed
        curvature = abs(c1[0] * c2[1] - c1[1] * c2[0]) / speed ** 3
        v = cap if curvature < 1e-12 else min(cap, 2 / period * math.sqrt(max(2 * tolerance / curvature - tolerance ** 2, 0.0)))
        samples.append((s, v))
    return samples


def turning_points(samples, noise=0.01):
    """Ends, peaks, valleys and ends of plateaus: where a rise, a fall or a level stretch becomes another one."""
    found = [0]
    direction = None
    for k in range(1, len(samples)):
        change = samples[k][1] - samples[k - 1][1]
        now = 0 if abs(change) < 1e-9 else (1 if change > 0 else -1)
        if direction is not None and now != direction:
            found.append(k - 1)
        direction = now
    found.append(len(samples) - 1)
    return found


def thinned(points, tolerance):
    """Points of which a line through those that stay misses none by more than the tolerance in v."""
    if len(points) < 3:
        return points
    (x0, y0), (x1, y1) = points[0], points[-1]
    off = [abs(y - y0 - (y1 - y0) * (x - x0) / (x1 - x0 or 1)) for x, y in points]
    worst = max(range(len(points)), key=off.__getitem__)
    if off[worst] <= tolerance:
        return [points[0], points[-1]]
    return thinned(points[:worst + 1], tolerance)[:-1] + thinned(points[worst:], tolerance)


def draw_breaking_points(folder):
    samples = butterfly_ceiling()
    breaking = turning_points(samples)
    picture = Picture(760, 310, "Breaking points of the butterfly's velocity limit curve")
    axes = Axes(picture, (55, 40, 680, 200), (0, 384), (0, 110))
    axes.frame([0, 50, 100, 150, 200, 250, 300, 350], [0, 50, 100], "s [mm]",
               f"allowed feedrate [mm/s]; chord tolerance 0.5 µm, Ts 1 ms, F 100 mm/s: {len(breaking)} points without screening")
    axes.points(thinned(samples, 0.4), BLUE, width=1.3)
    valleys = 0
    for n, k in enumerate(breaking):
        is_valley = 0 < n < len(breaking) - 1 and samples[k][1] < min(samples[breaking[n - 1]][1], samples[breaking[n + 1]][1])
        valleys += is_valley
        axes.dot(*samples[k], RED if is_valley else INK, radius=3.2, hollow=not is_valley)
    picture.dot(440, 294, RED, 3.2)
    picture.text(450, 298, f"valleys ({valleys}): velocity segments end here", size=12)
    picture.dot(100, 294, INK, 3.2, True)
    picture.text(110, 298, "both ends, and ends of level stretches", size=12)
    picture.save(folder, "breaking-points.svg")


# --- The adjustment

def law_over_way(begin, end, limits, count=30):
    """[(s, v)] of the S-curve between two feedrates."""
    change = abs(end - begin)
    if change == 0:
        return [(0.0, begin)]
    time = s_curve_duration(change, limits)
    share = min(limits[0] / limits[1] / time, 0.5)
    shape, points, s = s_curve(share), [], 0.0
    fine = 20
    for k in range(count * fine + 1):
        v = begin + (end - begin) * shape(k / (count * fine))[0]
        if k:
            s += 0.5 * (v + before) * time / (count * fine)
        before = v
        if k % fine == 0:
            points.append((s, v))
    return points


def way(begin, end, limits):
    return 0.5 * (begin + end) * s_curve_duration(abs(end - begin), limits)


def bisect(function, low, high):
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) <= 0 else (low, middle)
    return low


def draw_adjustment(folder):
    limits = (1000.0, 20000.0)
    picture = Picture(760, 342, "The four situations of the adjustment")
    cases = [("ACC + CF: the cruise gets shorter", [(0, 10), (0.8, 60), (6, 60)]),
             ("CF + DEC: the same from the end", [(0, 60), (5.2, 60), (6, 10)]),
             ("ACC + DEC: the peak comes down", [(0, 10), (2, 100), (4, 20)]),
             ("ACC + CF + DEC: both take from the cruise", [(0, 20), (0.8, 70), (10.4, 70), (11.4, 10)])]
    for k, (title, ceiling) in enumerate(cases):
        axes = Axes(picture, (55 + 370 * (k % 2), 35 + 155 * (k // 2), 300, 85), (0, 12), (0, 115))
        axes.frame([0, 4, 8, 12], [0, 50, 100], "s [mm]" if k > 1 else "", "v [mm/s]" if k % 2 == 0 else "")
        picture.text(axes.place[0] + 300, axes.place[1] - 8, title, INK, "end", 12)
        length, begin, end = ceiling[-1][0], ceiling[0][1], ceiling[-1][1]
        wanted = max(v for _, v in ceiling)
        peak = min(wanted, bisect(lambda v, b=begin, e=end, n=length: way(b, v, limits) + way(v, e, limits) - n, max(begin, end), 200))
        axes.points(ceiling, GREY, dash="4 3", width=1.2)
        for point in ceiling:
            axes.dot(*point, INK, radius=3, hollow=True)
        up, down = law_over_way(begin, peak, limits), law_over_way(peak, end, limits)
        axes.points(up, BLUE, width=2)
        axes.points([(up[-1][0], peak), (length - down[-1][0], peak)], GREEN, width=2)
        axes.points([(length - down[-1][0] + s, v) for s, v in down], RED, width=2)
    picture.line([(60, 328), (85, 328)], GREY, 1.2, "4 3")
    picture.dot(72.5, 328, INK, 3, True)
    picture.text(92, 332, "limit", size=12)
    for x, colour, words in ((160, BLUE, "ACC"), (235, GREEN, "CF"), (300, RED, "DEC")):
        picture.line([(x, 328), (x + 25, 328)], colour, 2)
        picture.text(x + 32, 332, words, size=12)
    picture.text(385, 332, "S-curves, A = 1000 mm/s², J = 20 000 mm/s³", GREY, size=12)
    picture.save(folder, "adjustment.svg")


# --- Junctions

def draw_junction(folder):
    picture = Picture(760, 300, "A junction passed at constant feedrate")
    corner, turn, step = (170.0, 70.0), math.radians(50), 52.0
    out = (math.cos(turn), math.sin(turn))
    picture.line([(30, corner[1]), corner, (corner[0] + 200 * out[0], corner[1] + 200 * out[1])], BLUE, 2)
    ticks = [(corner[0] - step * (k + 0.5), corner[1]) for k in (1, 0)] + \
            [(corner[0] + step * (k + 0.5) * out[0], corner[1] + step * (k + 0.5) * out[1]) for k in (0, 1, 2)]
    for place in ticks:
        picture.dot(*place)
    picture.line([ticks[1], ticks[2]], RED, 1.6)
    middle = tuple(0.5 * (a + b) for a, b in zip(ticks[1], ticks[2]))
    picture.line([middle, corner], GREEN, 2)
    picture.text(corner[0] + 8, corner[1] - 6, "v Ts |Δt| / 4", GREEN, size=12)
    picture.text(112, 104, "v Ts", RED, "end", 12)
    picture.line([(138, 94), (116, 100)], RED, 0.8)
    base = (50.0, 200.0)
    for direction, colour, name, place in (((1, 0), INK, "t before", (-4, -8)), (out, INK, "t after", (8, 8))):
        end = (base[0] + 90 * direction[0], base[1] + 90 * direction[1])
        picture.arrow(base, end, colour)
        picture.text(end[0] + place[0], end[1] + place[1], name, colour, size=12)
    picture.arrow((base[0] + 90, base[1]), (base[0] + 90 * out[0], base[1] + 90 * out[1]), RED)
    picture.text(base[0] + 84, base[1] + 40, "Δt", RED, size=13)
    axes = Axes(picture, (420, 40, 310, 175), (-4.5, 4.5), (0, 1.05))
    axes.frame([-3, -1.5, 0, 1.5, 3], [0, 0.25, 0.5, 0.75, 1], "t / Ts from the junction", "what differences of positions see")

    def hat(x):
        return max(1 - abs(x), 0.0)

    def quadratic(x):
        x = abs(x)
        return 0.75 - x * x if x < 0.5 else (0.5 * (1.5 - x) ** 2 if x < 1.5 else 0.0)
    axes.points([(x, hat(x)) for x in (-1, 0, 1)], BLUE, width=2)
    axes.curve(quadratic, RED, -1.5, 1.5, 60, width=2)
    left, top = axes.at(-3, 1.0)
    right, bottom = axes.at(3, 0.0)
    picture.line([(left, bottom), (left, top + 25), (right, top + 25), (right, bottom)], GREY, 1, "4 3")
    picture.text(left + 6, top + 44, "constant: v", GREY, size=12)
    picture.text(left + 6, top + 59, "constant", GREY, size=12)
    picture.text(axes.at(0.35, 0)[0], axes.at(0, 0.9)[1] - 4, "second", BLUE, size=12)
    picture.text(axes.at(1.0, 0)[0], axes.at(0, 0.32)[1], "third", RED, size=12)
    picture.save(folder, "junction.svg")


# --- Blends

def draw_blend(folder):
    turn, tolerance = math.radians(90), 0.05
    reach = 8 * tolerance / (2 * math.sin(turn / 2))
    out = (math.cos(turn), math.sin(turn))

    def place(w):
        return (-reach * (1 - w) ** 3 + reach * w ** 3 * out[0], reach * w ** 3 * out[1])

    def curvature(w):
        a, b = (1 - w) ** 2, w ** 2
        speed = 3 * reach * math.sqrt(a * a + 2 * math.cos(turn) * a * b + b * b)
        return 18 * reach ** 2 * w * (1 - w) * math.sin(turn) / speed ** 3
    picture = Picture(760, 320, "The blend of a corner")
    axes = Axes(picture, (60, 40, 310, 230), (-0.35, 0.12), (-0.3, 0.05))
    flipped = [(x, -y) for x, y in map(place, [k / 60 for k in range(61)])]
    axes.points([(-0.34, 0), (0, 0), (0, -0.295)], GREY, width=2)
    axes.points([(-reach, 0), (0, 0), (0, 0), (0, -reach)], ORANGE, width=1, dash="3 3")
    axes.points(flipped, BLUE, width=2.2)
    for point in ((-reach, 0), (0, -reach)):
        axes.dot(*point, ORANGE)
    axes.dot(0, 0, ORANGE, radius=4.5, hollow=True)
    half = place(0.5)
    axes.points([(0, 0), (half[0], -half[1])], GREEN, width=2)
    axes.dot(half[0], -half[1], GREEN)
    picture.text(*axes.at(0.012, -0.02), "d |tB - tA| / 8 = P", GREEN, size=12)
    picture.text(*axes.at(0.012, 0.012), "C, twice a control point", ORANGE, size=12)
    picture.text(*axes.at(-0.15, 0.014), "d", ORANGE, "middle", 13)
    picture.text(*axes.at(0.012, -0.16), "d", ORANGE, size=13)
    picture.text(*axes.at(-0.34, -0.03), "tA", GREY, size=13)
    picture.text(*axes.at(-0.03, -0.29), "tB", GREY, size=13)
    picture.text(*axes.at(-0.2, -0.09), "r(w)", BLUE, size=13)
    picture.text(60, 300, "P = 0.05 mm, a turn of 90 degrees: d = 0.283 mm", GREY, size=12)
    right = Axes(picture, (495, 40, 240, 210), (0, 1), (0, 16))
    right.frame([0, 0.25, 0.5, 0.75, 1], [0, 5, 10, 15], "w", "curvature [1/mm]")
    right.curve(curvature, BLUE, count=120, width=2)
    right.dot(0.5, curvature(0.5), GREEN)
    picture.text(right.at(0.5, 0)[0], right.at(0, curvature(0.5))[1] - 10, "8 sin / (3 d cos²) of half the turn", GREEN, "middle", 12)
    picture.save(folder, "blend.svg")


# --- The compressor

def solve(matrix, right):
    """Gauss with pivots; right sides are tuples."""
    n = len(matrix)
    rows = [list(m) + list(r) for m, r in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k, i=i: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, n):
            factor = rows[k][i] / rows[i][i]
            rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    for i in reversed(range(n)):
        for k in range(i + 1, n):
            rows[i][n:] = [a - rows[i][k] * b for a, b in zip(rows[i][n:], rows[k][n:])]
        rows[i][n:] = [a / rows[i][i] for a in rows[i][n:]]
    return [row[n:] for row in rows]


def basis(knots, degree, index, u):
    if degree == 0:
        last = knots[index + 1] == knots[-1] and u == knots[-1]
        return 1.0 if knots[index] <= u < knots[index + 1] or last and knots[index] < u else 0.0
    value = 0.0
    if knots[index + degree] > knots[index]:
        value += (u - knots[index]) / (knots[index + degree] - knots[index]) * basis(knots, degree - 1, index, u)
    if knots[index + degree + 1] > knots[index + 1]:
        value += (knots[index + degree + 1] - u) / (knots[index + degree + 1] - knots[index + 1]) * basis(knots, degree - 1, index + 1, u)
    return value


def draw_compressor(folder):
    places = [(0.25 * k, 1.0 * math.sin(0.62 * 0.25 * k) * math.exp(-0.03 * k)) for k in range(41)]
    run = [(x, round(y / 0.05) * 0.05) for x, y in places]  # coarse decimals, so that they can be seen
    w = [0.0]
    for a, b in zip(run, run[1:]):
        w.append(w[-1] + math.dist(a, b))
    breaks = [w[0], w[10], w[20], w[30], w[40]]
    knots = [breaks[0]] * 5 + breaks + [breaks[-1]] * 5
    count = len(breaks) + 4
    weights = [0.5 * ((w[min(k + 1, 40)] - w[k]) + (w[k] - w[max(k - 1, 0)])) for k in range(41)]
    rows = [[basis(knots, 5, i, u) for i in range(count)] for u in w]
    matrix = [[sum(m * r[i] * r[j] for m, r in zip(weights, rows)) for j in range(count)] for i in range(count)]
    right = [tuple(sum(m * r[i] * p[axis] for m, r, p in zip(weights, rows, run)) for axis in (0, 1)) for i in range(count)]
    for index, point in ((0, run[0]), (count - 1, run[-1])):  # the ends are pinned
        matrix[index] = [1.0 if j == index else 0.0 for j in range(count)]
        right[index] = point
    coefficients = solve(matrix, right)

    def curve(u):
        values = [basis(knots, 5, i, u) for i in range(count)]
        return tuple(sum(b * c[axis] for b, c in zip(values, coefficients)) for axis in (0, 1))
    picture = Picture(760, 380, "Short lines and the spline that stands for them")
    axes = Axes(picture, (50, 35, 690, 170), (-0.2, 10.2), (-0.6, 1.2))
    axes.frame([0, 2, 4, 6, 8, 10], [-0.5, 0, 0.5], "x [mm]", "y [mm]")
    axes.points(run, GREY, width=1)
    for point in run:
        axes.dot(*point, GREY, radius=1.8)
    fine = [w[-1] * k / 120 for k in range(121)]
    axes.points([curve(u) for u in fine], BLUE, width=2)
    for u in breaks:
        axes.dot(*curve(u), RED, radius=3.4)
    picture.text(330, 62, "lines of the program, their ends on multiples of 0.05 mm", GREY, size=12)
    picture.text(330, 80, "spline of degree 5 by least squares, its ends pinned", BLUE, size=12)
    picture.text(330, 98, "ends of its spans, at vertices", RED, size=12)

    def away(u):
        k = min(max(i for i in range(41) if w[i] <= u), 39)
        share = (u - w[k]) / (w[k + 1] - w[k])
        return math.dist(curve(u), [(1 - share) * a + share * b for a, b in zip(run[k], run[k + 1])])
    below = Axes(picture, (50, 275, 690, 65), (0, w[-1]), (0, 0.06))
    below.frame([0, 2, 4, 6, 8, 10], [0, 0.025, 0.05], "w [mm], length of the lines", "|C(w) - P(w)| [mm]")
    below.points([(u, away(u)) for u in [w[-1] * k / 240 for k in range(241)]], INK, width=1)
    below.points([(0, 0.05), (w[-1], 0.05)], RED, width=1.2, dash="5 3")
    picture.text(735, below.at(0, 0.05)[1] - 5, "tolerance Q", RED, "end", 11)
    picture.save(folder, "compressor.svg")


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (draw_profiles, draw_arc_length, draw_chord, draw_breaking_points, draw_adjustment, draw_junction, draw_blend,
                 draw_compressor):
        draw(folder)


if __name__ == "__main__":
    main()
