"""A small drawing library for pictures with formulas: an SVG, and axes with a scale in it. The same bytes everywhere."""
import math

INK, GREY, LIGHT = "#222222", "#777777", "#d8d8d8"
BLUE, RED, GREEN, ORANGE, VIOLET = "#1f6fb4", "#c0392b", "#2a8a4a", "#d07a00", "#7d4fa8"


def number(value):
    return f"{round(value, 1) + 0.0:.1f}".removesuffix(".0")


class Picture:
    """Elements of an SVG, in the order in which they are drawn."""

    def __init__(self, width, height, title):
        self.lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
                      'font-family="DejaVu Sans, Verdana, sans-serif" font-size="13">',
                      f"<title>{title}</title>", f'<rect width="{width}" height="{height}" fill="white"/>']

    def line(self, points, colour=INK, width=1.5, dash="", fill="none"):
        shape = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self.lines.append(f'<polyline points="{shape}" fill="{fill}" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"'
                          + (f' stroke-dasharray="{dash}"' if dash else "") + "/>")

    def dot(self, x, y, colour=INK, radius=3.0, hollow=False):
        self.lines.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" fill="{"white" if hollow else colour}" '
                          f'stroke="{colour}"/>')

    def text(self, x, y, words, colour=INK, anchor="start", size=13):
        self.lines.append(f'<text x="{number(x)}" y="{number(y)}" fill="{colour}" text-anchor="{anchor}" font-size="{size}">{words}</text>')

    def arrow(self, begin, end, colour=INK, width=1.5):
        self.line([begin, end], colour, width)
        angle = math.atan2(end[1] - begin[1], end[0] - begin[0])
        barbs = [(end[0] - 9 * math.cos(angle + turn), end[1] - 9 * math.sin(angle + turn)) for turn in (0.35, -0.35)]
        self.line([barbs[0], end, barbs[1]], colour, width)

    def save(self, folder, name):
        (folder / name).write_text("\n".join(self.lines + ["</svg>"]) + "\n", encoding="utf-8")


class Axes:
    """A rectangle of a picture with a scale in each direction."""

    def __init__(self, picture, place, across, up):
        self.picture, self.place, self.across, self.up = picture, place, across, up

    def at(self, x, y):
        left, top, width, height = self.place
        return (left + (x - self.across[0]) / (self.across[1] - self.across[0]) * width,
                top + height - (y - self.up[0]) / (self.up[1] - self.up[0]) * height)

    def frame(self, xs, ys, below="", beside=""):
        left, top, width, height = self.place
        for y in ys:
            px = self.at(self.across[0], y)[1]
            self.picture.line([(left, px), (left + width, px)], LIGHT, 1)
            self.picture.text(left - 6, px + 4, f"{y:g}", GREY, "end", 11)
        for x in xs:
            px = self.at(x, self.up[0])[0]
            self.picture.line([(px, top + height), (px, top + height + 4)], GREY, 1)
            self.picture.text(px, top + height + 16, f"{x:g}", GREY, "middle", 11)
        self.picture.line([(left, top), (left, top + height), (left + width, top + height)], GREY, 1)
        self.picture.text(left + width / 2, top + height + 33, below, INK, "middle", 12)
        self.picture.text(left, top - 8, beside, INK, "start", 12)

    def curve(self, function, colour, begin=None, end=None, count=60, **style):
        begin = self.across[0] if begin is None else begin
        end = self.across[1] if end is None else end
        steps = [begin + (end - begin) * k / count for k in range(count + 1)]
        self.picture.line([self.at(x, function(x)) for x in steps], colour, **style)

    def points(self, points, colour, **style):
        self.picture.line([self.at(x, y) for x, y in points], colour, **style)

    def dot(self, x, y, colour=INK, **style):
        self.picture.dot(*self.at(x, y), colour, **style)
