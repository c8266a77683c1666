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
    """One subpath of an SVG path: its points, whether it is closed, and the element's inherited attributes."""

    def __init__(self, points, closed, attributes, groups):
        self.points, self.closed, self.attributes, self.groups = points, closed, attributes, groups

    @property
    def length(self):
        return length(self.points, self.closed)


def subpaths(text):
    """(points, closed) of each subpath of path data that has only M, L and Z with absolute numbers."""
    if not re.fullmatch(r"(M-?[\d.]+ -?[\d.]+(L-?[\d.]+ -?[\d.]+( -?[\d.]+ -?[\d.]+)*)?Z?)+", text):
        raise ValueError(f"unexpected path data {text[:200]}")
    found = []
    for part in re.findall(r"M[^M]+", text):
        numbers = [float(number) for number in re.findall(r"-?[\d.]+", part)]
        found.append((list(zip(numbers[::2], numbers[1::2])), part.endswith("Z")))
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
