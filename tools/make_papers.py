"""Make data/textures/paper and data/textures/canvas: tileable backgrounds, 512 x 512.

Source: seeds A, section 2.3.1 and figure 7 (custom background clear). Paper is a height
field lit from the upper left. Features much larger than a few pixels are filtered out, so
that a wall of tiles shows no repeated blotches; everything wraps round at the borders.
"""

import math

from shared import (
    band_noise, blend, blur, each, normalise, random_numbers, relief, white_noise, write_png,
)

SIZE = 512
WARM_WHITE = (1.0, 0.987, 0.955)
COTTON_WHITE = (1.0, 0.992, 0.972)
LINEN = (1.0, 0.965, 0.895)
JUTE = (1.0, 0.935, 0.81)
RULE_BLUE = (0.60, 0.73, 0.88)


def tinted(lightness, tint):
    return each(lambda value: tuple(value * channel for channel in tint), lightness)


def add_wrapped(field, x, y, value):
    """Add a value at a position between pixels, shared out to the four around it."""
    column, row = math.floor(x), math.floor(y)
    for dy, weight_y in ((0, row + 1 - y), (1, y - row)):
        for dx, weight_x in ((0, column + 1 - x), (1, x - column)):
            field[(row + dy) % SIZE][(column + dx) % SIZE] += value * weight_x * weight_y


def fibres(purpose, count):
    """Short, slightly curved hairs, some lighter and some darker than the sheet."""
    number = random_numbers(purpose)
    field = [[0.0] * SIZE for _ in range(SIZE)]
    for _ in range(count):
        x, y, angle = number() * SIZE, number() * SIZE, number() * math.tau
        bend = (number() - 0.5) * 0.08
        length = 8 + int(number() ** 2 * 34)
        strength = (0.4 + 0.6 * number()) * (-1 if number() < 0.55 else 1)
        for step in range(length):
            fade = math.sin(math.pi * (step + 0.5) / length)
            add_wrapped(field, x, y, strength * fade)
            x, y, angle = x + math.cos(angle), y + math.sin(angle), angle + bend
    return field


def sheet(purpose):
    """The fine grain of machine-made paper: about -1 .. 1 around 0."""
    grain = relief(band_noise(f"{purpose} grain", SIZE, 1, 5))
    felt = band_noise(f"{purpose} felt", SIZE, 2, 9)
    hairs = fibres(f"{purpose} hairs", 1300)
    return each(lambda g, f, h: 0.22 * g + 0.25 * f + 0.8 * h, grain, felt, hairs)


def plain():
    return tinted(each(lambda s: 0.958 + 0.013 * s, sheet("plain")), WARM_WHITE)


def lined():
    """Ruled paper, a line every 32 pixels; ink takes the grain a little."""
    grain = sheet("lined")
    paper = tinted(each(lambda s: 0.962 + 0.011 * s, grain), WARM_WHITE)
    for y in range(SIZE):
        distance = abs(y % 32 - 15.5)
        ink = max(0.0, min(1.0, 1.35 - distance)) * 0.85
        if ink > 0:
            paper[y] = [
                blend(colour, RULE_BLUE, ink * max(0.0, min(1.0, 0.95 - 0.3 * s)))
                for colour, s in zip(paper[y], grain[y])
            ]
    return paper


def watercolour():
    """Cold-pressed cotton paper: rounded bumps with pits between them."""
    bumps = normalise(each(
        lambda a, b: math.tanh(0.9 * a + 0.35 * b),
        band_noise("watercolour bumps", SIZE, 3, 7),
        band_noise("watercolour small bumps", SIZE, 1, 4),
    ))
    slope = normalise(relief(blur(bumps, 1)))
    grain = white_noise("watercolour grain", SIZE)
    lightness = each(
        lambda s, b, g: 0.945 + 0.016 * math.tanh(0.8 * s) + 0.006 * b + 0.006 * g,
        slope, bumps, grain,
    )
    return tinted(lightness, COTTON_WHITE)


def facets(purpose, cells):
    """A surface of flat triangles over a jittered grid: paper between its folds."""
    number = random_numbers(purpose)
    cell = SIZE / cells
    corners = {
        (i, j): (
            (i + (number() - 0.5) * 0.95) * cell,
            (j + (number() - 0.5) * 0.95) * cell,
            (number() - 0.5) * cell,
        )
        for i in range(cells)
        for j in range(cells)
    }

    def corner(i, j):
        x, y, height = corners[i % cells, j % cells]
        return x + i // cells * SIZE, y + j // cells * SIZE, height

    field = [[0.0] * SIZE for _ in range(SIZE)]
    for j in range(cells):
        for i in range(cells):
            a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            either = number() < 0.5
            for triangle in ((a, b, c), (a, c, d)) if either else ((a, b, d), (b, c, d)):
                fill(field, *triangle)
    return field


def fill(field, a, b, c):
    """Interpolate the heights of a triangle's corners over the pixels inside it."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if abs(area) < 1e-9:
        return
    for y in range(math.ceil(min(a[1], b[1], c[1])), math.floor(max(a[1], b[1], c[1])) + 1):
        for x in range(math.ceil(min(a[0], b[0], c[0])), math.floor(max(a[0], b[0], c[0])) + 1):
            wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
            wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
            if wb >= 0 and wc >= 0 and wb + wc <= 1:
                field[y % SIZE][x % SIZE] = a[2] + (b[2] - a[2]) * wb + (c[2] - a[2]) * wc


def wrinkled():
    """A sheet that was crunched up and unfolded: facets, folds, and worn crease lines."""
    layers = [facets(f"wrinkled {cells}", cells) for cells in (5, 9, 17, 34)]
    height = each(lambda a, b, c, d: 0.7 * a + 0.8 * b + 0.6 * c + 0.35 * d, *layers)
    height = blur(height, 1)
    slope = normalise(relief(height))
    crease = normalise(each(lambda h, soft: h - soft, height, blur(height, 2)))
    lightness = each(
        lambda s, c, g: 0.938
        + 0.020 * math.tanh(0.7 * s)
        + 0.0075 * max(-2.5, min(2.5, c))
        + 0.006 * g,
        slope, crease, sheet("wrinkled"),
    )
    return tinted(lightness, WARM_WHITE)


def woven(purpose, threads, wobble, contrast, gap):
    """Plain weave: warp (upright) and weft (level) threads, over and under in turn.

    Threads wander, differ in thickness and tone, and carry the streaks of their fibres.
    'gap' is how much darker it gets between them.
    """
    number = random_numbers(purpose)
    thickness = [[0.86 + 0.22 * number() for _ in range(threads)] for _ in range(2)]
    tone = [[number() - 0.5 for _ in range(threads)] for _ in range(2)]
    along_y = normalise(blur(white_noise(f"{purpose} warp path", SIZE), 3, 11))
    along_x = normalise(blur(white_noise(f"{purpose} weft path", SIZE), 11, 3))
    streak_y = normalise(blur(white_noise(f"{purpose} warp fibres", SIZE), 0, 9))
    streak_x = normalise(blur(white_noise(f"{purpose} weft fibres", SIZE), 9, 0))
    pitch = threads / SIZE

    height = [[0.0] * SIZE for _ in range(SIZE)]
    lightness = [[0.0] * SIZE for _ in range(SIZE)]
    for y in range(SIZE):
        for x in range(SIZE):
            warp = x * pitch + wobble * along_y[y][x]
            weft = y * pitch + wobble * along_x[y][x]
            i, j = math.floor(warp), math.floor(weft)
            across_warp, across_weft = 2 * (warp - i) - 1, 2 * (weft - j) - 1
            over = 1 if (i + j) % 2 == 0 else -1
            i, j = i % threads, j % threads
            bulge_warp = 0.45 * over * math.cos(across_weft * math.pi / 2)
            bulge_weft = -0.45 * over * math.cos(across_warp * math.pi / 2)
            round_warp = 1 - (across_warp / thickness[0][i]) ** 2
            round_weft = 1 - (across_weft / thickness[1][j]) ** 2
            top_warp = round_warp + bulge_warp
            top_weft = round_weft + bulge_weft
            if top_warp > top_weft:
                top, fibre = top_warp, 0.35 * streak_y[y][x] + tone[0][i]
            else:
                top, fibre = top_weft, 0.35 * streak_x[y][x] + tone[1][j]
            height[y][x] = max(-0.6, top)
            lightness[y][x] = 0.3 * fibre + gap * min(0.0, top - 0.55)
    slope = normalise(relief(blur(height, 1) if threads < 80 else height))
    return each(lambda l, s: contrast * (l + 0.42 * math.tanh(s)), lightness, slope)


def linen():
    weave = woven("linen", threads=96, wobble=0.16, contrast=0.042, gap=0.6)
    return tinted(each(lambda w: 0.935 + w, weave), LINEN)


def coarse():
    weave = woven("coarse", threads=44, wobble=0.14, contrast=0.085, gap=0.8)
    grain = sheet("coarse")
    return tinted(each(lambda w, g: 0.895 + w + 0.010 * g, weave, grain), JUTE)


BACKGROUNDS = {
    "paper/plain": plain,
    "paper/lined": lined,
    "paper/watercolour": watercolour,
    "paper/wrinkled": wrinkled,
    "canvas/linen": linen,
    "canvas/coarse": coarse,
}


def make(out):
    for name, background in BACKGROUNDS.items():
        write_png(out / "textures" / f"{name}.png", background())
