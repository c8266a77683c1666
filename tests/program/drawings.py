"""Drawings in lines as the program writes them: JSON, and SVG read and rasterised without trusting the writer."""

import json
import math
import re
import subprocess
import xml.etree.ElementTree as ElementTree

import png

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
CATALOGUE_HINT = "the DTD comes with Debian's w3c-sgml-lib"


def length(points, closed):
    """Length of a polyline of (x, y, ...) points."""
    ends = points[1:] + points[:1] if closed else points[1:]
    return sum(math.dist(a[:2], b[:2]) for a, b in zip(points, ends))


class Path:
    """One subpath of an SVG path: its pieces, whether it is closed, and the element's inherited attributes.

    A piece is a tuple of points: two of a straight piece, four of a cubic. `points` are places along all of them.
    """

    def __init__(self, pieces, closed, attributes, groups):
        self.pieces, self.closed, self.attributes, self.groups = pieces, closed, attributes, groups
        self.points = [pieces[0][0]]
        for piece in pieces:
            self.points += places(piece)[1:]
        if closed and len(self.points) > 1 and math.dist(self.points[0], self.points[-1]) < 1e-9:
            self.points.pop()

    @property
    def length(self):
        return length(self.points, self.closed)


def places(piece, steps=16):
    """Points along a piece, from its start to its end."""
    if len(piece) == 2:
        return list(piece)
    found = []
    for i in range(steps + 1):
        t = i / steps
        weights = (1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3
        found.append(tuple(sum(weight * point[side] for weight, point in zip(weights, piece)) for side in (0, 1)))
    return found


def straightened(path):
    """The pieces of a path, cubics as many short straight ones."""
    return [pair for piece in path.pieces for along in [places(piece, 64)] for pair in zip(along, along[1:])]


def distance(point, pieces):
    """From a point to the nearest of some straight pieces (a, b)."""
    nearest = math.inf
    for (ax, ay), (bx, by) in pieces:
        along_x, along_y, from_x, from_y = bx - ax, by - ay, point[0] - ax, point[1] - ay
        square = along_x * along_x + along_y * along_y
        share = min(max((from_x * along_x + from_y * along_y) / square, 0.0), 1.0) if square > 0 else 0.0
        nearest = min(nearest, math.hypot(from_x - share * along_x, from_y - share * along_y))
    return nearest


def subpaths(text):
    """(pieces, closed) of each subpath of path data that has M, l, c and Z alone."""
    number = r"-?(?:\d+(?:\.\d+)?|\.\d+)"
    pair = rf"{number}(?: |(?=-)){number}"
    gap = r"(?: |(?=-))"
    one = rf"M{pair}(?:l{pair}(?:{gap}{pair})*|c{pair}(?:{gap}{pair}){{2}}(?:{gap}{pair}(?:{gap}{pair}){{2}})*)*Z?"
    if not re.fullmatch(rf"(?:{one})+", text):
        raise ValueError(f"unexpected path data {text[:200]}")
    found = []
    for part in re.findall(r"M[^M]+", text):
        pen, pieces = (0.0, 0.0), []
        for letter, data in re.findall(r"([Mlc])([^Mlc]+)", part):
            numbers = [float(one) for one in re.findall(number, data)]
            step = {"M": 2, "l": 2, "c": 6}[letter]
            for i in range(0, len(numbers), step):
                ends = [(pen[0] + numbers[j], pen[1] + numbers[j + 1]) for j in range(i, i + step, 2)]
                pieces.append((pen, *ends))
                pen = ends[-1]
        closed = part.endswith("Z")
        start, pieces = pieces[0][1], pieces[1:]
        if closed and math.dist(pen, start) > 1e-9:
            pieces.append((pen, start))
        found.append((pieces or [(start, start)], closed))
    return found


class Drawing:
    """An SVG file."""

    def __init__(self, text):
        self.text = text.decode() if isinstance(text, bytes) else text
        self.root = ElementTree.fromstring(self.text.encode())
        self.width, self.height = (self.millimetres(self.root.get(side)) for side in ("width", "height"))
        self.view_box = [float(number) for number in self.root.get("viewBox").split()]
        self.title = self.root.findtext(f"{SVG}title")
        self.description = self.root.findtext(f"{SVG}desc")

    @staticmethod
    def millimetres(text):
        match = re.fullmatch(r"([\d.]+)mm", text)
        return float(match[1])

    def ids(self):
        """Every id, in order."""
        return [element.get("id") for element in self.root.iter() if element.get("id") is not None]

    def group(self, name):
        """The element of an id."""
        return next(element for element in self.root.iter() if element.get("id") == name)

    def paths(self, inside=""):
        """All subpaths below the groups whose id begins with `inside`."""
        found = []
        self.collect(self.root, {}, (), found)
        return [path for path in found if not inside or any(name.startswith(inside) for name in path.groups)]

    def collect(self, element, attributes, groups, found):
        attributes = {**attributes, **element.attrib}
        if element.tag == f"{SVG}g":
            groups = (*groups, element.get("id"))
        if element.tag == f"{SVG}path":
            found += [Path(*part, attributes, groups) for part in subpaths(element.get("d"))]
        for child in element:
            self.collect(child, attributes, groups, found)

    def strokes(self):
        """All stroked subpaths."""
        return [path for path in self.paths() if path.attributes.get("stroke", "none") != "none"]


def travel(paths):
    """How far a pen that draws paths in their order travels up, from the upper left corner on."""
    pen, sum_ = (0.0, 0.0), 0.0
    for path in paths:
        sum_ += math.dist(pen, path.points[0])
        pen = path.points[0] if path.closed else path.points[-1]
    return sum_


def validate(path):
    """What xmllint says of a file against the DTD that it names; empty when it is valid."""
    done = subprocess.run(["xmllint", "--noout", "--nonet", "--valid", path], capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else f"{CATALOGUE_HINT}: {done.stderr}"


def rasterised(path, output, ground="white"):
    """The picture that rsvg-convert makes of an SVG file."""
    subprocess.run(["rsvg-convert", "-b", ground, "-o", output, path], check=True)
    return png.read(output)


def read_json(text):
    """The drawing of a JSON file, its structure checked."""
    drawing = json.loads(text)
    if set(drawing) != {"width", "height", "paths"}:
        raise ValueError(f"keys {sorted(drawing)}")
    for path in drawing["paths"]:
        kinds = {"class": str, "mesh": str, "visible": bool, "layers": int, "closed": bool, "points": list}
        if set(path) - {"view"} != set(kinds) or not all(isinstance(path[key], kinds[key]) for key in kinds):
            raise ValueError(f"path with {sorted(path)}")
        if path["visible"] != (path["layers"] == 0) or len(path["points"]) < 2:
            raise ValueError(f"layers {path['layers']}, {len(path['points'])} points")
        if not all(len(point) == 3 and all(math.isfinite(number) for number in point) for point in path["points"]):
            raise ValueError("a point that is none")
    return drawing
