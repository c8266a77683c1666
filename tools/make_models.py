"""Make data/models: sample models in OBJ, each a test of something.

cube              points and faces only, no normals
two_material_cube one object, two materials
sphere            5120 nearly equal triangles, normals and texture coordinates
torus_knot        one closed surface that occludes itself
teapot            the classic (see teapot.py), four objects
scene             a still life of named objects and coloured materials
bearing           a machine part: creases, chamfers, roundings and holes (see machine_parts.py)
pipes             two parts that pass through each other

make_models.py --sphere TRIANGLES OUT.obj writes a sphere of exactly that many triangles
(an even number from 20) for benchmarks; make_models.py --scan OUT.obj a bracket of 66,056
triangles as a scanner sees it, with noise.
"""

import argparse
import math
import sys

from machine_parts import BEARING_MATERIALS, PIPE_MATERIALS, bearing, pipes, scanned_bracket
from meshes import (
    Mesh, Welder, cross, dot, resting, subtract, surface, transformed, unit, write_obj,
)
from teapot import teapot

# --- Cubes ---------------------------------------------------------------------------------

CUBE_SIDES = [(4, 5, 7, 6), (1, 0, 2, 3), (5, 1, 3, 7), (0, 4, 6, 2), (6, 7, 3, 2), (0, 1, 5, 4)]


def cuboid_points(width, height, depth):
    return [(x * width / 2, y * height / 2, z * depth / 2)
            for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]


def cube(name="cube"):
    """Two triangles a side, points only."""
    mesh = Mesh(name, points=cuboid_points(2, 2, 2))
    for a, b, c, d in CUBE_SIDES:
        mesh.faces += [tuple((k, None, None) for k in face) for face in ((a, b, c), (a, c, d))]
    return mesh


def two_material_cube():
    mesh = cube("two_material_cube")
    mesh.face_materials = ["red"] * 6 + ["blue"] * 6
    return mesh


def cuboid(name, material, width, height, depth):
    """With flat normals and texture coordinates; stands on y = 0."""
    points = [(x, y + height / 2, z) for x, y, z in cuboid_points(width, height, depth)]
    mesh = Mesh(name, material, points, uvs=[(0, 0), (1, 0), (1, 1), (0, 1)])
    for a, b, c, d in CUBE_SIDES:
        mesh.normals.append(
            unit(cross(subtract(points[b], points[a]), subtract(points[d], points[a]))))
        normal = len(mesh.normals) - 1
        corners = [(point, uv, normal) for uv, point in enumerate((a, b, c, d))]
        mesh.faces += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return mesh


# --- Spheres -------------------------------------------------------------------------------

GOLDEN = (1 + math.sqrt(5)) / 2
ICOSAHEDRON_POINTS = [
    (-1, GOLDEN, 0), (1, GOLDEN, 0), (-1, -GOLDEN, 0), (1, -GOLDEN, 0),
    (0, -1, GOLDEN), (0, 1, GOLDEN), (0, -1, -GOLDEN), (0, 1, -GOLDEN),
    (GOLDEN, 0, -1), (GOLDEN, 0, 1), (-GOLDEN, 0, -1), (-GOLDEN, 0, 1),
]
ICOSAHEDRON_FACES = [
    (0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
    (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
    (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
    (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1),
]


def sphere(triangles, name="sphere"):
    """A unit sphere of exactly this many triangles, an even number from 20.

    Each side of an icosahedron is cut into f * f triangles, as many as fit; what is missing
    comes from cutting triangles, spread over the sphere, into three at their middle.
    """
    if triangles < 20 or triangles % 2:
        raise ValueError(f"a sphere has an even number of triangles, at least 20, not {triangles}")
    frequency = math.isqrt(triangles // 20)
    points, faces = icosphere(frequency)
    while len(faces) < triangles:
        cuts = min((triangles - len(faces)) // 2, len(faces))
        chosen = {k * len(faces) // cuts for k in range(cuts)}
        faces = [piece for number, face in enumerate(faces)
                 for piece in (cut_in_three(points, face) if number in chosen else (face,))]
    corners = [tuple((k, None, k) for k in face) for face in faces]
    return Mesh(name, points=points, normals=points, faces=corners)


def cut_in_three(points, face):
    a, b, c = face
    points.append(unit(tuple(sum(points[k][axis] for k in face) for axis in range(3))))
    middle = len(points) - 1
    return (a, b, middle), (b, c, middle), (c, a, middle)


def icosphere(frequency):
    points, index, faces = [], {}, []

    def corner(face, i, j):
        """The point i steps towards face[1] and j towards face[2], shared between sides."""
        weights = ((face[0], frequency - i - j), (face[1], i), (face[2], j))
        key = tuple(sorted((k, weight) for k, weight in weights if weight))
        if key not in index:
            index[key] = len(points)
            points.append(unit(tuple(
                sum(ICOSAHEDRON_POINTS[k][axis] * weight for k, weight in key)
                for axis in range(3))))
        return index[key]

    for face in ICOSAHEDRON_FACES:
        for i in range(frequency):
            for j in range(frequency - i):
                a, b, c = corner(face, i, j), corner(face, i + 1, j), corner(face, i, j + 1)
                faces.append((a, b, c))
                if i + j < frequency - 1:
                    faces.append((b, corner(face, i + 1, j + 1), c))
    return points, faces


def with_longitude_and_latitude(mesh):
    """Texture coordinates; triangles across the seam or at a pole get their own."""
    weld = Welder(mesh.uvs)
    for number, face in enumerate(mesh.faces):
        around = [math.atan2(-mesh.points[k][2], mesh.points[k][0]) / math.tau % 1.0
                  for k, _, _ in face]
        if max(around) - min(around) > 0.5:
            around = [u + 1 if u < 0.5 else u for u in around]
        pole = [math.hypot(mesh.points[k][0], mesh.points[k][2]) < 1e-9 for k, _, _ in face]
        if any(pole):
            others = [u for u, at_pole in zip(around, pole) if not at_pole]
            around = [sum(others) / 2 if at_pole else u for u, at_pole in zip(around, pole)]
        mesh.faces[number] = tuple(
            (k, weld.index((u, math.acos(-mesh.points[k][1]) / math.pi)), n)
            for (k, _, n), u in zip(face, around))
    return mesh


# --- Curves and surfaces ---------------------------------------------------------------------


def curve(points, t):
    """Catmull-Rom spline through 2-D or 3-D points, t in 0 .. len(points) - 1.

    A profile that ends on the axis (radius 0) meets it at a right angle.
    """
    def beyond(end, inside):
        if len(end) == 2 and end[0] == 0:
            return (-inside[0], inside[1])
        return end

    padded = [beyond(points[0], points[1]), *points, beyond(points[-1], points[-2])]
    k = min(int(t), len(points) - 2)
    t -= k
    weights = (
        (-t + 2 * t * t - t**3) / 2,
        (2 - 5 * t * t + 3 * t**3) / 2,
        (t + 4 * t * t - 3 * t**3) / 2,
        (-t * t + t**3) / 2,
    )
    return tuple(
        sum(weight * point[axis] for weight, point in zip(weights, padded[k : k + 4]))
        for axis in range(len(points[0]))
    )


def revolved(name, material, profiles, columns, steps, lobes=lambda angle, height: 1.0):
    """Turn profiles of (radius, height) about the y axis; hard edges where profiles meet.

    Profiles run outwards along the bottom, then upwards. 'lobes' scales the radius.
    """
    segments = [len(profile) - 1 for profile in profiles]
    total = sum(segments)

    def place(u, v):
        position = v * total
        for profile, count in zip(profiles, segments):
            if position <= count + 1e-9:
                break
            position -= count
        radius, height = curve(profile, min(position, count))
        angle = math.tau * u
        radius *= lobes(angle, height)
        return (radius * math.cos(angle), height, -radius * math.sin(angle))

    runs, start = [], 0
    for count in segments:
        cuts = count * steps if count > 1 else 1
        runs.append([(start + count * k / cuts) / total for k in range(cuts + 1)])
        start += count
    return surface(name, material, place, columns, runs)


def tube(name, material, path, radii, columns, steps):
    """A tapering round tube along a curve, closed with round ends."""
    last = len(path) - 1

    def place(u, v):
        t = v * last
        ahead = unit(subtract(curve(path, min(last, t + 1e-3)), curve(path, max(0, t - 1e-3))))
        side = unit(cross(ahead, (0.31, 0.12, 0.94)))
        up = cross(side, ahead)
        radius = radii[0] + (radii[1] - radii[0]) * v
        radius *= min(1.0, 1.5 * math.sin(math.pi * v) ** 0.5) if 0 < v < 1 else 0.0
        c, s = radius * math.cos(math.tau * u), radius * math.sin(math.tau * u)
        return tuple(p + c * a + s * b for p, a, b in zip(curve(path, t), up, side))

    # Closer rings at the ends, where the tube closes.
    rows = [(1 - math.cos(math.pi * k / steps)) / 2 for k in range(steps + 1)]
    return surface(name, material, place, columns, [rows])


def leaf(name, material, length, width):
    """A pointed, arched leaf along +x, a little thick so that it is closed."""
    def place(u, v):
        half = width / 2 * math.sin(math.pi * v ** 0.8) if 0 < v < 1 else 0.0
        across, lift = math.cos(math.tau * u) * half, math.sin(math.tau * u) * half * 0.22
        arch = 0.30 * length * math.sin(math.pi * v * 0.8) - 0.2 * across * across / width
        return (length * v, arch + lift, -across)

    return surface(name, material, place, 12, [[k / 12 for k in range(13)]])


def torus_knot():
    """The trefoil: twice round the axis and three times round the torus."""
    def centre(t):
        r = 2 + 0.9 * math.cos(3 * t)
        return (r * math.cos(2 * t), 0.9 * math.sin(3 * t), r * math.sin(2 * t))

    def place(u, v):
        t = math.tau * v
        ahead = unit(subtract(centre(t + 1e-4), centre(t - 1e-4)))
        out = (math.cos(3 * t) * math.cos(2 * t), math.sin(3 * t), math.cos(3 * t) * math.sin(2 * t))
        out = unit(subtract(out, tuple(dot(out, ahead) * a for a in ahead)))
        side = cross(ahead, out)
        c, s = 0.45 * math.cos(math.tau * u), 0.45 * math.sin(math.tau * u)
        return tuple(p + c * a + s * b for p, a, b in zip(centre(t), out, side))

    return surface("torus_knot", "knot", place, 18, [[k / 192 for k in range(193)]])


# --- The still life ----------------------------------------------------------------------------

# name: diffuse colour, specular grey, shininess
SCENE_MATERIALS = {
    "wood": ((0.72, 0.50, 0.31), 0.10, 12),
    "glaze": ((0.24, 0.46, 0.62), 0.60, 60),
    "red_skin": ((0.80, 0.16, 0.13), 0.45, 40),
    "green_skin": ((0.58, 0.72, 0.24), 0.40, 40),
    "pear_skin": ((0.88, 0.76, 0.32), 0.25, 25),
    "bark": ((0.36, 0.25, 0.16), 0.05, 8),
    "leaf": ((0.27, 0.50, 0.25), 0.15, 16),
    "card": ((0.91, 0.84, 0.70), 0.05, 8),
    "lid": ((0.55, 0.25, 0.38), 0.10, 12),
}
APPLE = [(0, 0.12), (0.14, 0.02), (0.30, 0.04), (0.46, 0.22), (0.55, 0.50), (0.54, 0.72),
         (0.40, 0.92), (0.20, 0.95), (0.08, 0.87), (0, 0.78)]
PEAR = [(0, 0.09), (0.12, 0.02), (0.28, 0.04), (0.46, 0.25), (0.50, 0.48), (0.40, 0.78),
        (0.27, 1.02), (0.20, 1.22), (0.11, 1.34), (0, 1.34)]
VASE = [
    [(0, 0), (0.34, 0)],
    [(0.34, 0), (0.38, 0.05), (0.55, 0.30), (0.68, 0.66), (0.62, 1.05), (0.41, 1.38),
     (0.26, 1.64), (0.26, 1.85), (0.36, 2.02), (0.35, 2.06), (0.31, 2.03), (0.22, 1.85),
     (0.22, 1.64), (0.36, 1.36), (0.56, 1.04), (0.60, 0.66), (0.45, 0.30), (0, 0.16)],
]
TABLE = [
    [(0, -0.22), (2.50, -0.22)],
    [(2.50, -0.22), (2.60, -0.17), (2.64, -0.11), (2.60, -0.05), (2.50, 0)],
    [(2.50, 0), (0, 0)],
]


def apple(name, material):
    def lobes(angle, height):
        return 1 + 0.035 * math.cos(5 * angle) * (0.5 - height)

    return revolved(name, material, [APPLE], 36, 4, lobes)


def stem(name, base, height):
    path = [(0, base, 0), (0.01, base + height * 0.5, 0.01), (0.07, base + height, 0.03)]
    return tube(name, "bark", path, (0.03, 0.045), 10, 8)


def fruit(body, parts, **placement):
    return resting([transformed(mesh, **placement) for mesh in (body, *parts)])


def twig(number, path, leaves):
    """A branch standing in the vase, and its leaves at (t along it, turn, tilt)."""
    meshes = [tube(f"twig_{number}", "bark", path, (0.035, 0.018), 8, 16)]
    for letter, (t, turn, tilt) in zip("abcdef", leaves):
        blade = leaf(f"leaf_{number}{letter}", "leaf", 0.62, 0.30)
        meshes.append(transformed(blade, turn=turn, tilt=tilt, move=curve(path, t)))
    return meshes


def scene():
    vase = revolved("vase", "glaze", VASE, 48, 3)
    twigs = (
        twig(1, [(-0.30, 0.35, 0), (-0.05, 1.6, 0.02), (0.10, 2.5, 0.05), (0.42, 3.25, 0.10)],
             [(1.6, 200, 35), (2.1, 10, 20), (2.5, 150, 35), (2.75, 300, 30), (3.0, 20, 40)])
        + twig(2, [(0.30, 0.35, -0.1), (0.06, 1.6, -0.05), (-0.20, 2.3, -0.1), (-0.62, 2.85, 0.1)],
               [(1.8, 60, 35), (2.2, 230, 20), (2.6, 120, 45), (3.0, 190, 15)])
    )
    at_vase = {"move": (-0.75, 0, -0.75)}
    meshes = [revolved("table", "wood", TABLE, 72, 3)]
    meshes += [transformed(mesh, **at_vase) for mesh in (vase, *twigs)]
    meshes += fruit(apple("apple_red", "red_skin"),
                    [stem("stem_red", 0.76, 0.34),
                     transformed(leaf("leaf_apple", "leaf", 0.42, 0.20), turn=-30, tilt=18,
                                 move=(0.02, 0.95, 0.0))],
                    move=(0.18, 0, 0.62))
    meshes += fruit(apple("apple_green", "green_skin"), [stem("stem_green", 0.76, 0.28)],
                    scale=0.92, turn=-35, tilt=-58, move=(0.80, 0, 0.93))
    meshes += fruit(revolved("pear", "pear_skin", [PEAR], 36, 4), [stem("stem_pear", 1.30, 0.30)],
                    turn=70, move=(-1.25, 0, 0.75))
    box = transformed(cuboid("box", "card", 1.25, 0.85, 0.95), turn=-24, move=(1.15, 0, -0.55))
    lid = transformed(cuboid("box_lid", "lid", 1.35, 0.24, 1.05), turn=-24, move=(1.15, 0.82, -0.55))
    return meshes + [box, lid]


# --- All of them -------------------------------------------------------------------------------

CUBE_MATERIALS = {"red": ((0.78, 0.22, 0.18), 0.2, 20), "blue": ((0.20, 0.36, 0.70), 0.2, 20)}
KNOT_MATERIALS = {"knot": ((0.85, 0.55, 0.25), 0.5, 50)}
SPHERE_MATERIALS = {"clay": ((0.80, 0.50, 0.40), 0.3, 30)}
TEAPOT_MATERIALS = {
    "porcelain": ((0.88, 0.86, 0.80), 0.6, 60),
    "accent": ((0.30, 0.45, 0.62), 0.6, 60),
}


def make(out):
    models = out / "models"
    ball = with_longitude_and_latitude(sphere(5120))
    ball.material = "clay"
    write_obj(models / "cube.obj", "A cube: points and faces only", [cube()])
    write_obj(models / "two_material_cube.obj", "A cube of two materials",
              [two_material_cube()], CUBE_MATERIALS)
    write_obj(models / "sphere.obj", "A subdivided icosahedron", [ball], SPHERE_MATERIALS)
    write_obj(models / "torus_knot.obj", "A trefoil knot", [torus_knot()], KNOT_MATERIALS)
    write_obj(models / "teapot.obj", "Martin Newell's teapot, 1975", teapot(), TEAPOT_MATERIALS)
    write_obj(models / "scene.obj", "A still life", scene(), SCENE_MATERIALS)
    write_obj(models / "bearing.obj", "A bearing block, millimetres", bearing(), BEARING_MATERIALS)
    write_obj(models / "pipes.obj", "Two pipes through each other, millimetres", pipes(), PIPE_MATERIALS)


def main():
    parser = argparse.ArgumentParser(description="Write a sphere for benchmarks, or a scan.")
    model = parser.add_mutually_exclusive_group(required=True)
    model.add_argument("--sphere", nargs=2, metavar=("TRIANGLES", "OUT.obj"))
    model.add_argument("--scan", metavar="OUT.obj")
    asked = parser.parse_args()
    if asked.scan:
        write_obj(asked.scan, "A bracket as a scanner sees it, millimetres", scanned_bracket())
        return
    triangles, path = asked.sphere
    try:
        write_obj(path, f"A sphere of {triangles} triangles", [sphere(int(triangles))])
    except ValueError as error:
        sys.exit(f"make_models.py: {error}")


if __name__ == "__main__":
    main()
