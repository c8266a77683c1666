"""What the scripts in this folder share: PNG files, tileable noise, random numbers.

Every random number comes from (seed, purpose), never from a clock, so that the same
script writes the same bytes again.
"""

import itertools
import math
import pathlib
import random
import struct
import zlib

SEED = 1


def random_numbers(purpose):
    """A generator of numbers in [0, 1) that depends on SEED and the purpose only."""
    return random.Random(f"{SEED}/{purpose}").random


# --- PNG ---------------------------------------------------------------------------------


def to_byte(value):
    return max(0, min(255, int(value * 255 + 0.5)))


def write_png(path, rows):
    """Write rows of (red, green, blue) in 0..1, top row first.

    A picture of at most 256 colours becomes a palette PNG: the same pixels in a third
    of the bytes.
    """
    pixels = [[tuple(map(to_byte, colour)) for colour in row] for row in rows]
    palette = sorted(set(itertools.chain.from_iterable(pixels)))
    width, height = len(pixels[0]), len(pixels)
    if len(palette) <= 256 and width * height > 4096:
        index = {colour: number for number, colour in enumerate(palette)}
        scanlines = [bytes(index[colour] for colour in row) for row in pixels]
        chunks = [(b"PLTE", bytes(itertools.chain.from_iterable(palette)))]
        colour_type = 3
    else:
        scanlines = [bytes(itertools.chain.from_iterable(row)) for row in pixels]
        chunks = []
        colour_type = 2
    _write_chunks(path, width, height, colour_type, chunks, scanlines)


def write_grey_png(path, rows):
    """Write rows of bytes, black 0 to white 255, top row first."""
    _write_chunks(path, len(rows[0]), len(rows), 0, [], rows)


def _write_chunks(path, width, height, colour_type, chunks, scanlines):
    data = zlib.compress(b"".join(b"\0" + line for line in scanlines), 9)
    header = struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0)
    chunks = [(b"IHDR", header), *chunks, (b"IDAT", data), (b"IEND", b"")]

    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, body in chunks:
            file.write(struct.pack(">I", len(body)) + name + body)
            file.write(struct.pack(">I", zlib.crc32(name + body)))


def read_png(path):
    """Read what write_png or write_grey_png wrote: rows of (red, green, blue) bytes."""
    content = pathlib.Path(path).read_bytes()
    chunks, position = {}, 8
    while position < len(content):
        (length,) = struct.unpack_from(">I", content, position)
        name = content[position + 4 : position + 8]
        chunks[name] = content[position + 8 : position + 8 + length]
        position += 12 + length
    width, height, _, colour_type = struct.unpack_from(">IIBB", chunks[b"IHDR"])
    data = zlib.decompress(chunks[b"IDAT"])
    channels = 3 if colour_type == 2 else 1
    stride = width * channels + 1
    lines = [data[y * stride + 1 : (y + 1) * stride] for y in range(height)]
    if colour_type == 3:
        table = chunks[b"PLTE"]
        palette = [tuple(table[i : i + 3]) for i in range(0, len(table), 3)]
        return [[palette[number] for number in line] for line in lines]
    if colour_type == 0:
        return [[(value,) * 3 for value in line] for line in lines]
    return [list(zip(line[0::3], line[1::3], line[2::3])) for line in lines]


# --- Fields: square lists of rows of numbers that wrap round at their borders ---------------


def each(function, *fields):
    """The field whose values are function(values of the given fields)."""
    return [[function(*values) for values in zip(*rows)] for rows in zip(*fields)]


def white_noise(purpose, size):
    number = random_numbers(purpose)
    return [[number() - 0.5 for _ in range(size)] for _ in range(size)]


def _blur_rows(field, radius):
    """Three box filters along each row: nearly a Gaussian of deviation 'radius'."""
    if radius == 0:
        return field
    width = 2 * radius + 1
    result = []
    for row in field:
        row = list(row)
        for _ in range(3):
            sums = [0.0, *itertools.accumulate(row[-radius:] + row + row[:radius])]
            row = [(after - before) / width for before, after in zip(sums, sums[width:])]
        result.append(row)
    return result


def blur(field, radius_x, radius_y=None):
    across = _blur_rows(field, radius_x)
    radius_y = radius_x if radius_y is None else radius_y
    return [list(row) for row in zip(*_blur_rows(list(zip(*across)), radius_y))]


def normalise(field):
    """Shift and scale to mean 0 and standard deviation 1."""
    values = list(itertools.chain.from_iterable(field))
    mean = math.fsum(values) / len(values)
    deviation = math.sqrt(math.fsum((v - mean) ** 2 for v in values) / len(values))
    return [[(v - mean) / deviation for v in row] for row in field]


def band_noise(purpose, size, fine, coarse):
    """Noise with features between two radii: no grain below, no blotches above."""
    start = blur(white_noise(purpose, size), fine)
    return normalise(each(lambda a, b: a - b, start, blur(start, coarse)))


def relief(field):
    """The slope towards a light at the upper left."""
    size = len(field)
    return [
        [
            field[(y + 1) % size][(x + 1) % size] - field[y - 1][x - 1]
            for x in range(size)
        ]
        for y in range(size)
    ]


def smoothstep(low, high, value):
    t = max(0.0, min(1.0, (value - low) / (high - low)))
    return t * t * (3 - 2 * t)


def blend(first, second, amount):
    return tuple(a + (b - a) * amount for a, b in zip(first, second))
