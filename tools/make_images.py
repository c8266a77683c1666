"""Make data/textures/images (pictures to wrap round a model) and data/textures/metal.

images: what seeds C, program 2.2, offers as "images:*"; the first one is its default.
metal: sphere maps for shading with a metallic texture. Texel (x, y) holds the colour of a
polished ball, seen from afar along -z, where its normal is (x, y, .) with x and y in -1..1.
"""

import colorsys
import math

from shared import blend, smoothstep, write_png

# --- Pictures --------------------------------------------------------------------------------

CREAM = (0.95, 0.92, 0.84)
TEAL = (0.36, 0.55, 0.58)

# Capital letters and digits on 5 x 7 dots, a row a number in base 32.
GLYPHS = {
    "A": (14, 17, 17, 31, 17, 17, 17), "B": (30, 17, 17, 30, 17, 17, 30),
    "C": (14, 17, 16, 16, 16, 17, 14), "D": (30, 17, 17, 17, 17, 17, 30),
    "E": (31, 16, 16, 30, 16, 16, 31), "F": (31, 16, 16, 30, 16, 16, 16),
    "G": (14, 17, 16, 23, 17, 17, 14), "H": (17, 17, 17, 31, 17, 17, 17),
    "1": (4, 12, 4, 4, 4, 4, 14), "2": (14, 17, 1, 6, 8, 16, 31),
    "3": (14, 17, 1, 6, 1, 17, 14), "4": (2, 6, 10, 18, 31, 2, 2),
    "5": (31, 16, 30, 1, 1, 17, 14), "6": (14, 16, 30, 17, 17, 17, 14),
    "7": (31, 1, 2, 4, 8, 8, 8), "8": (14, 17, 17, 14, 17, 17, 14),
}


def checker():
    """Eight by eight checks, cream and teal."""
    return [[CREAM if (x // 32 + y // 32) % 2 == 0 else TEAL for x in range(256)]
            for y in range(256)]


def in_label(text, x, y):
    """Whether a dot of the text lies at (x, y), dots being 3 pixels, from its upper left."""
    column, row = x // 3, y // 3
    letter, dot = divmod(column, 6)
    if x < 0 or y < 0 or row > 6 or letter >= len(text) or dot > 4:
        return False
    return bool(GLYPHS[text[letter]][row] >> (4 - dot) & 1)


def uv_grid():
    """Cells named by column (A to H along u) and row (1 to 8 along v, from the bottom)."""
    size, cell = 512, 64
    rows = []
    for y in range(size):
        row = []
        for x in range(size):
            i, j = x // cell, (size - 1 - y) // cell
            colour = colorsys.hsv_to_rgb(i / 8, 0.30 + 0.05 * (j % 2), 0.98 - 0.055 * j)
            if (i + j) % 2:
                colour = blend(colour, (1.0, 1.0, 1.0), 0.35)
            if in_label("ABCDEFGH"[i] + str(j + 1), x % cell - 16, y % cell - 22):
                colour = blend(colour, (0.1, 0.1, 0.15), 0.75)
            if x % cell in (0, cell - 1) or y % cell in (0, cell - 1):
                colour = blend(colour, (0.15, 0.15, 0.2), 0.6)
            row.append(colour)
        rows.append(row)
    return rows


# --- Sphere maps -----------------------------------------------------------------------------

# A photographer's studio, by elevation: dark floor, bright horizon, grey backdrop, pale ceiling.
CHROME_WALLS = [
    (-90, (0.10, 0.10, 0.11)), (-35, (0.20, 0.20, 0.21)), (-6, (0.46, 0.46, 0.47)),
    (-1, (0.12, 0.13, 0.15)), (2, (0.80, 0.83, 0.87)), (14, (0.52, 0.57, 0.64)),
    (45, (0.30, 0.35, 0.43)), (90, (0.62, 0.67, 0.74)),
]
GOLD_WALLS = [
    (-90, (0.22, 0.11, 0.02)), (-35, (0.36, 0.20, 0.04)), (-6, (0.74, 0.48, 0.14)),
    (-1, (0.27, 0.14, 0.03)), (2, (0.98, 0.82, 0.42)), (14, (0.84, 0.60, 0.20)),
    (45, (0.56, 0.36, 0.09)), (90, (0.90, 0.70, 0.30)),
]

# Soft boxes: azimuth and elevation of the middle, half width, half height (degrees), strength.
# Azimuth 0 is behind the eye, 90 to its right.
SOFT_BOXES = [(-38, 48, 24, 17, 1.0), (62, 28, 9, 30, 0.85), (160, 40, 30, 10, 0.6)]


def reflected(x, y):
    """The direction in which the eye, looking along -z, sees the ball's surroundings."""
    length = math.hypot(x, y)
    if length > 0.999:  # beyond the rim: carry the rim's colour on, so that no edge shows
        x, y = x / length * 0.999, y / length * 0.999
    z = math.sqrt(1 - x * x - y * y)
    return 2 * z * x, 2 * z * y, 2 * z * z - 1


def wall_colour(walls, elevation):
    for (low, first), (high, second) in zip(walls, walls[1:]):
        if elevation <= high:
            return blend(first, second, smoothstep(low, high, elevation))
    return walls[-1][1]


def studio(walls, light, x, y):
    dx, dy, dz = reflected(x, y)
    elevation = math.degrees(math.asin(max(-1.0, min(1.0, dy))))
    azimuth = math.degrees(math.atan2(dx, dz))
    colour = wall_colour(walls, elevation)
    for middle, height, half_width, half_height, strength in SOFT_BOXES:
        turn = abs((azimuth - middle + 180) % 360 - 180)
        inside = smoothstep(half_width + 4, half_width - 2, turn)
        inside *= smoothstep(half_height + 4, half_height - 2, abs(elevation - height))
        colour = blend(colour, light, strength * inside)
    rim = math.hypot(x, y)
    return blend(colour, (0.0, 0.0, 0.0), 0.35 * smoothstep(0.86, 1.0, rim))


def sphere_map(walls, light):
    """256 x 256, each texel the mean of four samples."""
    size, offsets = 256, (0.25, 0.75)
    rows = []
    for row in range(size):
        line = []
        for column in range(size):
            samples = [
                studio(walls, light, (column + dx) / size * 2 - 1, 1 - (row + dy) / size * 2)
                for dy in offsets for dx in offsets
            ]
            line.append(tuple(sum(channel) / 4 for channel in zip(*samples)))
        rows.append(line)
    return rows


def make(out):
    textures = out / "textures"
    write_png(textures / "images" / "checker.png", checker())
    write_png(textures / "images" / "uv_grid.png", uv_grid())
    write_png(textures / "metal" / "chrome.png", sphere_map(CHROME_WALLS, (1.0, 1.0, 1.0)))
    write_png(textures / "metal" / "gold.png", sphere_map(GOLD_WALLS, (1.0, 0.97, 0.80)))
