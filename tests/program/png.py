"""Pictures as the program writes them: 8-bit RGB and RGBA PNG files, read without a library."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {2: 3, 6: 4}  # colour types RGB and RGBA


class Picture:
    """Pixels in rows from top to bottom; each a tuple of 3 or 4 channels of 0 to 255."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def at(self, x, y):
        """The pixel in column x of row y; negative numbers count from the right and the bottom."""
        return self.rows[y][x]

    @property
    def centre(self):
        return self.at(self.width // 2, self.height // 2)

    @property
    def corner(self):
        return self.at(0, 0)

    @property
    def pixels(self):
        return [pixel for row in self.rows for pixel in row]

    def share(self, wanted):
        """The share of pixels for which wanted(pixel) holds."""
        return sum(map(wanted, self.pixels)) / (self.width * self.height)

    def share_drawn(self):
        """The share of pixels that are not as the upper left corner."""
        return self.share(lambda pixel: pixel != self.corner)

    def box(self, wanted):
        """(left, top, right, bottom) of the pixels for which wanted(pixel) holds, right and bottom included."""
        places = [(x, y) for y, row in enumerate(self.rows) for x, pixel in enumerate(row) if wanted(pixel)]
        columns, lines = zip(*places)
        return min(columns), min(lines), max(columns), max(lines)

    def crop(self, left, top, right, bottom):
        """The pixels of columns left to right and rows top to bottom, the last ones left out."""
        return Picture(right - left, bottom - top, [row[left:right] for row in self.rows[top:bottom]])

    def mean(self):
        """The mean of each channel."""
        return tuple(sum(channel) / len(channel) for channel in zip(*self.pixels))


def chunks(data):
    """Yields (type, content) of each chunk; raises ValueError where one is damaged."""
    if not data.startswith(SIGNATURE):
        raise ValueError("no PNG signature")
    offset = len(SIGNATURE)
    while offset < len(data):
        (length,) = struct.unpack_from(">I", data, offset)
        kind, content = data[offset + 4 : offset + 8], data[offset + 8 : offset + 8 + length]
        if data[offset + 8 + length : offset + 12 + length] != struct.pack(">I", zlib.crc32(kind + content)):
            raise ValueError(f"chunk {kind} is damaged")
        yield kind, content
        offset += 12 + length


def paeth(left, above, corner):
    """PNG's predictor 4."""
    estimate = left + above - corner
    distances = abs(estimate - left), abs(estimate - above), abs(estimate - corner)
    return (left, above, corner)[distances.index(min(distances))]


def unfilter(kind, line, above, channels):
    """A row's bytes from its filtered ones and the row above."""
    if kind == 0:
        return bytearray(line)
    if kind not in (1, 2, 3, 4):
        raise ValueError(f"filter {kind}")
    row = bytearray(line)
    for i, value in enumerate(line):
        left = row[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        guess = (left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner) if kind == 4 else 0)[kind - 1]
        row[i] = (value + guess) & 255
    return row


def decode(data):
    """The picture that the bytes of a PNG file hold. Raises ValueError for what the program never writes."""
    parts = list(chunks(data))
    if not parts or parts[0][0] != b"IHDR" or parts[-1][0] != b"IEND":
        raise ValueError("not a whole PNG")
    width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if depth != 8 or color not in CHANNELS or interlaced:
        raise ValueError(f"{depth} bits, colour type {color}, interlaced {interlaced}")
    channels = CHANNELS[color]
    packed = zlib.decompress(b"".join(content for kind, content in parts if kind == b"IDAT"))
    stride = 1 + width * channels
    if len(packed) != stride * height:
        raise ValueError("too few or too many pixels")
    rows, above = [], bytearray(stride - 1)
    for start in range(0, len(packed), stride):
        above = unfilter(packed[start], packed[start + 1 : start + stride], above, channels)
        rows.append(list(zip(*(above[c::channels] for c in range(channels)))))
    return Picture(width, height, rows)


def read(path):
    """The picture of a PNG file."""
    with open(path, "rb") as file:
        return decode(file.read())
