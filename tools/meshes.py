"""Triangle meshes for the scripts in this folder: building, checking, OBJ files.

Right-handed, y up, faces counter-clockwise seen from outside. A corner of a face is
(point, texture coordinate, normal), three indices; the latter two may be None.
"""

import collections
import math
import pathlib
from dataclasses import dataclass, field


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length)


@dataclass
class Mesh:
    name: str
    material: str = ""
    points: list = field(default_factory=list)
    uvs: list = field(default_factory=list)
    normals: list = field(default_factory=list)
    faces: list = field(default_factory=list)
    face_materials: list = field(default_factory=list)  # one a face, or empty


class Welder:
    """Gives values that are equal to 5 decimals the same index in a list.

    A new welder does not find what others put into the list before.
    """

    def __init__(self, values):
        self.values = values
        self.indices = {}

    def index(self, value):
        key = tuple(round(number, 5) + 0.0 for number in value)
        if key not in self.indices:
            self.indices[key] = len(self.values)
            self.values.append(value)
        return self.indices[key]


def add_grid(mesh, points, uvs, normals, weld_points, weld_normals):
    """Add a grid of triangles, two a cell, leaving out those that a pole collapses.

    Rows run so that (next column) x (next row) points outwards.
    """
    weld_uvs = Welder(mesh.uvs)
    corner = [
        [
            (weld_points.index(p), weld_uvs.index(t), weld_normals.index(n))
            for p, t, n in zip(*rows)
        ]
        for rows in zip(points, uvs, normals)
    ]
    for lower, upper in zip(corner, corner[1:]):
        for a, b, c, d in zip(lower, lower[1:], upper[1:], upper):
            for face in ((a, b, c), (a, c, d)):
                if len({point for point, _, _ in face}) == 3:
                    mesh.faces.append(face)


def surface(name, material, function, columns, runs):
    """The grid surface of function(u, v) -> point; u goes once round, 0 to 1.

    'runs' is a list of lists of v. Inside a run the surface is smooth; where two runs meet
    they share points but not normals, which makes a hard edge. Normals come from
    differences; at a pole, where there is no u direction, from the ring beside it, as their
    mean unless the pole is pointed.
    """
    mesh = Mesh(name, material)
    weld_points = Welder(mesh.points)
    step = 1e-4
    us = [i / columns for i in range(columns + 1)]

    def normal(u, v, low, high):
        across = subtract(function(u + step, v), function(u - step, v))
        along = subtract(function(u, min(high, v + step)), function(u, max(low, v - step)))
        return cross(across, along)

    def ring_normals(v, low, high):
        if math.dist(function(0.0, v), function(0.5, v)) > 1e-6:
            return [unit(normal(u, v, low, high)) for u in us]
        beside = v + 10 * step if v == low else v - 10 * step
        ring = [unit(normal(u, beside, low, high)) for u in us]
        axis = unit(tuple(math.fsum(n[k] for n in ring[:-1]) for k in range(3)))
        is_smooth = min(dot(axis, n) for n in ring) > 0.99
        return [axis] * len(us) if is_smooth else ring

    for run in runs:
        points = [[function(u, v) for u in us] for v in run]
        uvs = [[(u, v) for u in us] for v in run]
        normals = [ring_normals(v, run[0], run[-1]) for v in run]
        add_grid(mesh, points, uvs, normals, weld_points, Welder(mesh.normals))
    return mesh


def transformed(mesh, scale=1.0, turn=0.0, tilt=0.0, move=(0.0, 0.0, 0.0)):
    """Scale, tilt about z, turn about y (degrees), then move."""
    ct, st = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    cy, sy = math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def rotate(p):
        x, y, z = p[0] * ct - p[1] * st, p[0] * st + p[1] * ct, p[2]
        return (x * cy + z * sy, y, z * cy - x * sy)

    def place(p):
        x, y, z = rotate(p)
        return (x * scale + move[0], y * scale + move[1], z * scale + move[2])

    mesh.points = [place(p) for p in mesh.points]
    mesh.normals = [rotate(n) for n in mesh.normals]
    return mesh


def resting(meshes):
    """Lower the group until the first mesh touches y = 0."""
    lowest = min(y for _, y, _ in meshes[0].points)
    return [transformed(mesh, move=(0, -lowest, 0)) for mesh in meshes]


# --- OBJ -----------------------------------------------------------------------------------


def number(value):
    text = f"{value:.5g}" if abs(value) >= 1 else f"{value:.5f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def write_obj(path, comment, meshes, materials=None):
    """Write meshes, and beside them 'materials', a dict of name to (diffuse, specular, shininess)."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [f"# {comment}"]
    if materials:
        lines.append(f"mtllib {path.stem}.mtl")
    first = [1, 1, 1]
    for mesh in meshes:
        lines.append(f"o {mesh.name}")
        for key, values in (("v", mesh.points), ("vt", mesh.uvs), ("vn", mesh.normals)):
            lines.extend(f"{key} " + " ".join(map(number, value)) for value in values)
        current = None
        for position, face in enumerate(mesh.faces):
            material = mesh.face_materials[position] if mesh.face_materials else mesh.material
            if material and material != current:
                lines.append(f"usemtl {material}")
                current = material
            lines.append("f " + " ".join(corner_text(corner, first) for corner in face))
        counts = (len(mesh.points), len(mesh.uvs), len(mesh.normals))
        first = [base + count for base, count in zip(first, counts)]
    path.write_text("\n".join(lines) + "\n")
    if materials:
        write_mtl(path.with_suffix(".mtl"), materials)


def corner_text(corner, first):
    parts = ["" if index is None else str(index + base) for index, base in zip(corner, first)]
    return "/".join(parts).rstrip("/")


def write_mtl(path, materials):
    lines = []
    for name, (diffuse, specular, shininess) in materials.items():
        lines += [
            f"newmtl {name}",
            "Ka " + " ".join(number(0.15 * channel) for channel in diffuse),
            "Kd " + " ".join(map(number, diffuse)),
            "Ks " + " ".join([number(specular)] * 3),
            f"Ns {shininess}",
            "illum 2",
            "",
        ]
    path.write_text("\n".join(lines))


def read_obj(path):
    """Read what write_obj wrote: a list of meshes."""
    meshes, first = [], [1, 1, 1]
    for line in pathlib.Path(path).read_text().splitlines():
        key, *words = line.split()
        if key == "o":
            if meshes:
                last = meshes[-1]
                counts = (len(last.points), len(last.uvs), len(last.normals))
                first = [base + count for base, count in zip(first, counts)]
            meshes.append(Mesh(words[0]))
        elif key in ("v", "vt", "vn"):
            target = {"v": "points", "vt": "uvs", "vn": "normals"}[key]
            getattr(meshes[-1], target).append(tuple(map(float, words)))
        elif key == "usemtl":
            meshes[-1].material = words[0]
        elif key == "f":
            face = []
            for word in words:
                parts = word.split("/") + ["", ""]
                face.append(tuple(
                    int(part) - base if part else None for part, base in zip(parts[:3], first)
                ))
            meshes[-1].faces.append(tuple(face))
    return meshes


# --- Checks --------------------------------------------------------------------------------


@dataclass
class Topology:
    euler: int  # points - edges + faces
    boundary_edges: int
    boundary_loops: int
    bad_edges: int  # shared by more than two faces, or by two that wind differently
    unused_points: int
    volume: float  # positive when faces wind counter-clockwise seen from outside
    smallest_area: float
    worst_normal: float  # least cosine between a face and its corners' normals


def topology(mesh):
    directed = collections.Counter()
    used, volume, smallest, worst = set(), 0.0, math.inf, 1.0
    for face in mesh.faces:
        points = [mesh.points[corner[0]] for corner in face]
        used.update(corner[0] for corner in face)
        for k in range(3):
            directed[face[k][0], face[(k + 1) % 3][0]] += 1
        volume += dot(points[0], cross(points[1], points[2])) / 6
        area = cross(subtract(points[1], points[0]), subtract(points[2], points[0]))
        smallest = min(smallest, math.sqrt(dot(area, area)) / 2)
        for corner in face:
            if corner[2] is not None and dot(area, area) > 0:
                worst = min(worst, dot(unit(area), mesh.normals[corner[2]]))
    boundary = {start: end for start, end in directed if (end, start) not in directed}
    edges = {tuple(sorted(edge)) for edge in directed}
    return Topology(
        euler=len(used) - len(edges) + len(mesh.faces),
        boundary_edges=sum((end, start) not in directed for start, end in directed),
        boundary_loops=count_loops(boundary),
        bad_edges=sum(count > 1 for count in directed.values()),
        unused_points=len(mesh.points) - len(used),
        volume=volume,
        smallest_area=smallest,
        worst_normal=worst,
    )


def count_loops(successor):
    remaining, loops = dict(successor), 0
    while remaining:
        start = point = next(iter(remaining))
        while point in remaining:
            point = remaining.pop(point)
        loops += point == start
    return loops
