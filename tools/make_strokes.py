"""Make the computed parts of data/strokes and data/textures/strokes.

strokes: offset files that are curves. Each is a list of points (along, tangent, normal), or
None for a break; docs/strokes.md has the format.
textures/strokes: what a stroke lays down along its spine, which runs from left to right. Black
inks, white does not. They wrap round at their left and right borders.
"""

import math

from shared import (
    band_noise, blur, normalise, random_numbers, smoothstep, white_noise, write_png,
)

# --- Offset files ------------------------------------------------------------------------------


def write_offsets(path, help_text, length, points):
    lines = ["# Made by tools/make_strokes.py.", f"help {help_text}", f"length {length:g}"]
    for point in points:
        if point is None:
            lines.append("break")
        else:
            # + 0.0: no negative zeros
            lines.append("point " + " ".join(f"{round(number, 2) + 0.0:g}" for number in point))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def wandering():
    """Parabolic arches of differing heights, to the left and to the right in turn."""
    points = []
    start = 0
    for width, height in ((48, 3.2), (36, -2.4), (60, 3.8), (42, -3.4), (54, 2.2), (40, -3.0)):
        for step in range(8):
            t = step / 8
            points.append((start + t * width, 0, 4 * height * t * (1 - t)))
        start += width
    return start, points + [(start, 0, 0)]


def loops():
    """A cycloid with more roll than way: a row of e, each 16 pixels from the next."""
    length, radius = 16, 5
    points = []
    for step in range(25):
        angle = math.tau * step / 24
        points.append((length * step / 24, radius * math.sin(angle), radius * (1 - math.cos(angle))))
    return length, points


def circles():
    """A circle of 16 points that is held at its centre, and a dash."""
    points = []
    for step in range(17):
        angle = math.tau * step / 16
        points.append((6, 4 * math.cos(angle), 4 * math.sin(angle)))
    return 26, [*points, None, (14, 0, 0), (22, 0, 0), None]


def arc(centre_x, centre_y, radius_x, radius_y, first, last, steps):
    """Points of an ellipse's arc, angles in degrees, counter-clockwise."""
    angles = [math.radians(first + (last - first) * step / steps) for step in range(steps + 1)]
    return [(centre_x + radius_x * math.cos(a), centre_y + radius_y * math.sin(a)) for a in angles]


# Capitals in a box 1 wide and 1 high: strokes of (x, y), y upwards.
LETTERS = {
    "C": [arc(0.5, 0.5, 0.5, 0.5, 50, 310, 10)],
    "R": [[(0, 0), (0, 1)], [(0, 1), (0.5, 1), *arc(0.5, 0.75, 0.4, 0.25, 90, -90, 6), (0, 0.5)],
          [(0.45, 0.5), (0.95, 0)]],
    "O": [arc(0.5, 0.5, 0.5, 0.5, 90, 450, 14)],
    "Q": [arc(0.5, 0.5, 0.5, 0.5, 90, 450, 14), [(0.6, 0.3), (1.0, -0.08)]],
    "U": [[(0, 1), (0, 0.4), *arc(0.45, 0.4, 0.45, 0.4, 180, 360, 8), (0.9, 1)]],
    "I": [[(0.5, 0), (0.5, 1)]],
    "S": [[*arc(0.47, 0.74, 0.4, 0.26, 35, 260, 8), *arc(0.47, 0.26, 0.42, 0.26, 80, -145, 8)]],
}
WIDTHS = {"I": 0.6}


def letters():
    """Each letter is held at its middle, so that a bend turns it and does not bend it."""
    size, gap = 11, 4
    points, start = [], gap / 2
    for letter in "CROQUIS":
        width = WIDTHS.get(letter, 1.0)
        middle = start + width * size / 2
        for stroke in LETTERS[letter]:
            points += [(middle, (x - 0.5) * size, (y - 0.5) * size) for x, y in stroke]
            points.append(None)
        start += width * size + gap
    return start + 3 * gap, points


# --- Textures ----------------------------------------------------------------------------------

LENGTH, HEIGHT = 512, 64


def across(y):
    """-1 at the upper border of the stroke to 1 at the lower one."""
    return (y + 0.5) / HEIGHT * 2 - 1


def charcoal():
    """The tooth of the paper takes the stick's grains; less of them towards the sides."""
    tooth = band_noise("charcoal tooth", LENGTH, 1, 4)
    dust = normalise(blur(white_noise("charcoal dust", LENGTH), 5, 3))
    rows = []
    for y in range(HEIGHT):
        pressure = 1.25 - 2.3 * abs(across(y)) ** 2.4
        row = []
        for x in range(LENGTH):
            ink = smoothstep(-0.75, 0.9, tooth[y][x] + 0.35 * dust[y][x] + 1.6 * pressure - 0.55)
            ink *= smoothstep(1.0, 0.86, abs(across(y))) if abs(across(y)) > 0.86 else 1
            row.append((1 - 0.95 * ink,) * 3)
        rows.append(row)
    return rows


def brush():
    """Bristles that run dry here and there, each in its own place."""
    bristles = normalise(blur(white_noise("brush bristles", LENGTH), 40, 1))
    number = random_numbers("brush load")
    load = [number() for _ in range(HEIGHT)]
    rows = []
    for y in range(HEIGHT):
        side = abs(across(y))
        fullness = 2.3 - 2.6 * side ** 3 + 1.3 * (load[y] - 0.5)
        row = []
        for x in range(LENGTH):
            ink = smoothstep(-0.5, 0.4, 0.8 * bristles[y][x] + fullness - 0.25)
            row.append((1 - ink * (1 if side < 0.94 else (1 - side) / 0.06),) * 3)
        rows.append(row)
    return rows


def make(out):
    strokes, textures = out / "strokes", out / "textures" / "strokes"
    write_offsets(strokes / "wandering.offsets", "Slow arches to both sides.", *wandering())
    write_offsets(strokes / "loops.offsets", "Loops to the left.", *loops())
    write_offsets(strokes / "circles.offsets", "Circles and dashes.", *circles())
    write_offsets(strokes / "letters.offsets", "CROQUIS in capitals.", *letters())
    write_png(textures / "charcoal.png", charcoal())
    write_png(textures / "brush.png", brush())
