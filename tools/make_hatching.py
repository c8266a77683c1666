"""Make data/textures/hatching: strokes whose density is a tone.

Tonal art maps (Praun and others, Real-Time Hatching, 2001): for each tone and each size of the
picture an image of strokes that are as wide in texels at every size. All strokes of a lighter
tone are in a darker one, all of a smaller size in a larger one. Each new stroke is the one of
many candidates that lies where there is least ink so far, on several scales.

Image k of n has an ink share of k / (n - 1), white to black: the last stroke is drawn just as
strongly as this needs. Everything wraps round at the borders.

A tonal image holds its tones below each other, white first, and to the right of each its half,
quarter, ... sizes. A volume holds its slices below each other (seed A, section 4.6.2, figure 52).
"""

import math
from collections import namedtuple

from shared import blur, normalise, random_numbers, smoothstep, white_noise, write_grey_png, write_png

SIZE, TONES = 256, 7
SMALLEST = 16  # below it there is no room for strokes: even tones
VOLUME_SIZE, VOLUME_DEPTH = 128, 32
DENSITY_SIZES = (64, 32, 8)  # the scales on which ink is evened out

# Lengths and bows are shares of the tile, widths texels, angles degrees. A stroke's angle is its layer's, and layers
# follow on each other in equal shares of the tones.
Medium = namedtuple("Medium", "name angles spread length bow width wobble strength grain")
PENCIL = Medium("pencil", (0, 82, 40), 5, (0.3, 0.62), 0.012, (1.5, 2.5), 0.5, (0.5, 0.8), 0.45)
INK = Medium("ink", (0, 90, 45), 2.5, (0.35, 0.8), 0.010, (1.2, 2.1), 0.35, (1.0, 1.0), 0.0)
BRUSH = Medium("brush", (0, 0, 90), 7, (0.18, 0.42), 0.02, (2.2, 4.2), 0.7, (1.0, 1.0), 0.0)

Stroke = namedtuple("Stroke", "x y angle length bow width strength wobble phase")


class Picture:
    """The light that is left of a square sheet on which strokes were drawn, and its mean ink."""

    def __init__(self, size, grain):
        self.size = size
        self.rows = [[1.0] * size for _ in range(size)]
        self.light = float(size * size)
        self.grain = grain

    @property
    def ink(self):
        return 1 - self.light / self.size**2

    def marks(self, stroke):
        """(row, column, opacity) of the texels that a stroke covers.

        It is walked texel by texel along the axis that it is nearest to; across, it covers as much of a texel
        as its half width reaches over it. Pressure grows quickly at its start and fades towards its end.
        """
        size, marks = self.size, []
        cosine, sine = math.cos(stroke.angle), math.sin(stroke.angle)
        is_steep = abs(sine) > abs(cosine)
        major, minor = (sine, cosine) if is_steep else (cosine, sine)
        count = max(2, round(abs(major) * stroke.length * size))
        start_along, start_across = (stroke.y, stroke.x) if is_steep else (stroke.x, stroke.y)
        direction = 1 if major > 0 else -1
        for step in range(count):
            t = (step + 0.5) / count
            pressure = smoothstep(0, 0.12, t) * (1 - smoothstep(0.55, 1.0, t) * 0.8)
            wave = math.sin(stroke.phase + math.tau * t * 2.3) * stroke.wobble * t * (1 - t)
            sway = (4 * stroke.bow * t * (1 - t) + minor * stroke.length * t) * size + wave
            half = 0.5 * stroke.width * (0.45 + 0.55 * pressure) / abs(major)
            middle = start_across * size + sway - 0.5
            along = (math.floor(start_along * size) + direction * step) % size
            for across in range(math.ceil(middle - half - 0.5), math.floor(middle + half + 0.5) + 1):
                cover = min(half + 0.5 - abs(across - middle), 1.0, 2 * half)
                if cover <= 0:
                    continue
                row, column = (along, across % size) if is_steep else (across % size, along)
                tooth = 1 - self.grain[row][column] if self.grain else 1
                marks.append((row, column, cover * stroke.strength * (0.6 + 0.4 * pressure) * tooth))
        return marks

    def draw(self, marks):
        """Draws them, and returns (row, column, light) as it was before, to be gone through backwards."""
        undo = []
        for row, column, opacity in marks:
            before = self.rows[row][column]
            undo.append((row, column, before))
            self.rows[row][column] = before * (1 - opacity)
            self.light -= before * opacity
        return undo

    def bytes_with_last(self, undo, share):
        """The picture as bytes, with the marks drawn last in a share of their strength: ink is linear in it."""
        rows = [list(row) for row in self.rows]
        for row, column, before in reversed(undo):
            rows[row][column] = before
        for row, column in {(row, column) for row, column, _ in undo}:
            rows[row][column] += share * (self.rows[row][column] - rows[row][column])
        return [bytes(int(value * 255 + 0.5) for value in row) for row in rows]


class Layer:
    """Strokes of one direction, evened out among themselves."""

    def __init__(self, medium, number, random):
        self.medium, self.random = medium, random
        self.angle = medium.angles[number]
        self.density = [(size, [0.0] * size**2) for size in DENSITY_SIZES]
        self.drawn = 0

    def candidate(self):
        def between(ends):
            return ends[0] + (ends[1] - ends[0]) * self.random()

        def about(reach):
            return (self.random() * 2 - 1) * reach

        medium = self.medium
        angle = math.radians(self.angle + about(medium.spread) + (180 if self.random() < 0.25 else 0))
        return Stroke(self.random(), self.random(), angle, between(medium.length), about(medium.bow),
                      between(medium.width), between(medium.strength), medium.wobble, self.random() * math.tau)

    def cells(self, stroke):
        """For each scale the cells that the stroke goes through."""
        found = []
        cosine, sine = math.cos(stroke.angle), math.sin(stroke.angle)
        for size, density in self.density:
            steps = math.ceil(stroke.length * size)
            ways = [(i + 0.5) / steps * stroke.length for i in range(steps)]
            found.append((density, size, [int((stroke.y + way * sine) * size) % size * size +
                                          int((stroke.x + way * cosine) * size) % size for way in ways]))
        return found

    def next_stroke(self):
        """The candidate with the least ink around it. The first strokes have the widest choice: they are seen best."""
        candidates = [self.candidate() for _ in range(max(8, 80 // (1 + self.drawn // 8)))]
        cells = [self.cells(stroke) for stroke in candidates]
        scores = [sum(sum(map(density.__getitem__, places)) / len(places) for density, _, places in each)
                  for each in cells]
        best = scores.index(min(scores))
        self.drawn += 1
        for density, size, places in cells[best]:
            for place in places:
                density[place] += size  # what a line leaves in a cell, over the cell's area
        return candidates[best]


def grain(medium, size):
    """The tooth of the paper: how much of a stroke each texel leaves out."""
    if not medium.grain:
        return None
    tooth = normalise(blur(white_noise(f"{medium.name} tooth {size}", size), 1))
    return [[medium.grain * smoothstep(-1.2, 1.6, value) for value in row] for row in tooth]


def even(size, tone, tones):
    return [bytes([round(255 * (1 - tone / (tones - 1)))]) * size for _ in range(size)]


def nested(medium, purpose, sizes, tones):
    """The images by (tone, size): tones from white to black, and for each the sizes from small to large, so that a
    stroke of a small size is in all larger ones."""
    random = random_numbers(f"hatching {purpose}")
    pictures = {size: Picture(size, grain(medium, size)) for size in sizes}
    layers = [Layer(medium, i, random) for i in range(len(medium.angles))]
    images = {(tone, size): even(size, tone, tones) for tone in (0, tones - 1) for size in sizes}
    for tone in range(1, tones - 1):
        layer = layers[(tone - 1) * len(layers) // (tones - 2)]
        for size in sorted(sizes):
            images[tone, size] = drawn_to(pictures, size, tone / (tones - 1), layer)
    return images


def drawn_to(pictures, size, ink, layer):
    """Adds strokes to this size and all larger ones until its ink is there; returns its image."""
    picture, undo, before = pictures[size], [], pictures[size].ink
    while picture.ink < ink:
        stroke = layer.next_stroke()
        before = picture.ink
        for other in pictures.values():
            if other.size > size:
                other.draw(other.marks(stroke))
        undo = picture.draw(picture.marks(stroke))
    share = (ink - before) / (picture.ink - before) if undo else 1
    return picture.bytes_with_last(undo, share)


def tonal_rows(images, size, tones):
    """A tone's sizes side by side, the tones below each other."""
    rows = []
    for tone in range(tones):
        for y in range(size):
            row, part = b"", size
            while part:
                row += images[tone, part][y] if y < part else b"\xff" * part
                part //= 2
            rows.append(row + b"\xff")
    return rows


def tonal(medium):
    sizes = [SIZE >> level for level in range(9)]
    images = nested(medium, medium.name, [size for size in sizes if size >= SMALLEST], TONES)
    for size in (size for size in sizes if size < SMALLEST):
        images.update({(tone, size): even(size, tone, TONES) for tone in range(TONES)})
    return images


def volume(medium):
    images = nested(medium, f"{medium.name} volume", [VOLUME_SIZE], VOLUME_DEPTH)
    return [row for tone in range(VOLUME_DEPTH) for row in images[tone, VOLUME_SIZE]]


def ramp():
    """How much of the strokes' transparency is left by the cosine to the light: three regions, soft between them."""
    def value(cosine):
        return 0.5 * smoothstep(0.22, 0.34, cosine) + 0.3 * smoothstep(0.52, 0.64, cosine) + \
            0.2 * smoothstep(0.8, 0.92, cosine)
    return [[(value((x + 0.5) / 256),) * 3 for x in range(256)]]


def make(out):
    folder = out / "textures" / "hatching"
    for medium in (PENCIL, INK, BRUSH):
        images = tonal(medium)
        write_grey_png(folder / f"{medium.name}.png", tonal_rows(images, SIZE, TONES))
        if medium is INK:
            write_grey_png(folder / "parallel.png", images[2, SIZE])
            write_grey_png(folder / "crosshatch.png", images[4, SIZE])
    write_grey_png(folder / "pencil_volume.png", volume(PENCIL))
    write_grey_png(folder / "ink_volume.png", volume(INK))
    write_png(folder / "ramp.png", ramp())
