"""Machine parts for the sample models: a bearing block, two pipes through each other, a bracket as a scanner sees it.

Lengths are millimetres. A loop is a closed list of points that runs counter-clockwise about an axis, seen from the axis'
positive end; a wall from one loop to the next faces left of its way, as seen along the loop: outwards on the way up,
inwards, as in a hole, on the way down.
"""

import math

from meshes import Mesh, Welder, transformed
from shared import random_numbers

# For each axis, the two coordinates across it, in the order that makes x to y counter-clockwise about it.
ACROSS = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}
AXES = "xyz"


class Solid:
    """A mesh in the making: walls between loops, and flat faces between loops."""

    def __init__(self, name, material=""):
        self.mesh = Mesh(name, material)
        self.weld = Welder(self.mesh.points)

    def face(self, *points):
        corners = [self.weld.index(point) for point in points]
        if len(set(corners)) == 3:
            self.mesh.faces.append(tuple((corner, None, None) for corner in corners))

    def panel(self, a, b, c, d):
        self.face(a, b, c)
        self.face(a, c, d)

    def wall(self, *loops):
        for low, high in zip(loops, loops[1:]):
            for corners in zip(low, [*low[1:], low[0]], [*high[1:], high[0]], high):
                self.panel(*corners)

    def cone(self, loop, tip):
        for a, b in zip(loop, [*loop[1:], loop[0]]):
            self.face(a, b, tip)

    def flat(self, outer, holes, axis, faces_up=True):
        """What lies between a loop and the loops of holes in it; all counter-clockwise about the axis."""
        u, v = ACROSS[axis]
        rings = [outer, *([*reversed(hole)] for hole in holes)]
        points = [point for ring in rings for point in ring]
        flat_points = [(point[u], point[v]) for point in points]
        starts = [sum(map(len, rings[:number])) for number in range(len(rings))]
        indices = [list(range(start, start + len(ring))) for start, ring in zip(starts, rings)]
        for a, b, c in cut_to_triangles(flat_points, indices[0], indices[1:]):
            self.face(*(points[k] for k in ((a, b, c) if faces_up else (a, c, b))))


# --- Flat faces --------------------------------------------------------------------------------


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def crosses(a, b, c, d):
    """Whether the open segments a b and c d cross or touch."""
    if a in (c, d) or b in (c, d):
        return False
    return turn(a, b, c) * turn(a, b, d) <= 0 and turn(c, d, a) * turn(c, d, b) <= 0


def joined_with_hole(points, ring, hole):
    """The ring cut open to take in a hole: from the nearest pair of points that see each other, there and back."""
    sides = [(points[r[k - 1]], points[r[k]]) for r in (ring, hole) for k in range(len(r))]
    pairs = sorted((math.dist(points[a], points[b]), i, k) for i, a in enumerate(ring) for k, b in enumerate(hole))
    for _, i, k in pairs:
        a, b = points[ring[i]], points[hole[k]]
        if not any(crosses(a, b, c, d) for c, d in sides):
            return ring[: i + 1] + hole[k:] + hole[: k + 1] + ring[i:]
    raise ValueError("a hole that no point of the ring sees")


def cut_to_triangles(points, ring, holes):
    """Triangles of a polygon with holes, by cutting off ears, the roundest first (Meisters 1975)."""
    for hole in sorted(holes, key=lambda hole: min(math.dist(points[a], points[b]) for a in ring for b in hole)):
        ring = joined_with_hole(points, ring, hole)

    def roundness(a, b, c):
        """Twice the area over the square of the longest side; None where it is no ear."""
        area = turn(points[a], points[b], points[c])
        if area <= 1e-9:
            return None
        corner_points = (points[a], points[b], points[c])
        for k in ring:
            p = points[k]
            if p not in corner_points and min(turn(corner_points[i - 1], corner_points[i], p) for i in range(3)) >= 0:
                return None
        return area / max(math.dist(corner_points[i - 1], corner_points[i]) for i in range(3)) ** 2

    triangles = []
    while len(ring) > 3:
        ears = [(roundness(ring[k - 1], ring[k], ring[(k + 1) % len(ring)]), k) for k in range(len(ring))]
        _, k = max(ear for ear in ears if ear[0] is not None)
        triangles.append((ring[k - 1], ring[k], ring[(k + 1) % len(ring)]))
        del ring[k]
    return [*triangles, tuple(ring)]


# --- Loops -------------------------------------------------------------------------------------


def placed(axis, height, u, v):
    point = [0.0, 0.0, 0.0]
    point[AXES.index(axis)] = height
    point[ACROSS[axis][0]], point[ACROSS[axis][1]] = u, v
    return tuple(point)


def circle(axis, centre, radius, height, count):
    """The centre is given by the two coordinates across the axis."""
    angles = [math.tau * k / count for k in range(count)]
    return [placed(axis, height, centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


def slot(centre_x, half_length, radius, height, count=16):
    """Two half circles, one beside the other along x, about the y axis."""
    loop = []
    for side in (1, -1):  # z is the first coordinate across y: counter-clockwise from +z to +x
        start = 0.0 if side > 0 else math.pi
        for k in range(count + 1):
            angle = start + math.pi * k / count
            loop.append((centre_x + side * half_length + radius * math.sin(angle), height, radius * math.cos(angle)))
    return loop


def arc(centre, radius, first, last, count):
    """Points in the plane; angles in degrees."""
    angles = [math.radians(first + (last - first) * k / count) for k in range(count + 1)]
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


# --- A bearing block ---------------------------------------------------------------------------

BEARING_MATERIALS = {"cast_iron": ((0.55, 0.60, 0.64), 0.25, 25)}
DEPTH = 22.0  # from the middle to the front of the body
AXIS_HEIGHT = 50.0
FOOT = 16.0  # height
FOOT_END = 88.0
PAD = 9.0  # half the width of the flat top
PAD_HEIGHT = 96.0
BODY_RADIUS = 44.0
SIDES = 72  # of the large circles
SCREWS = 6


def bearing_profile():
    """The body seen from the front, counter-clockwise, without its bottom and feet's tops: right half, then left."""
    pad_angle = math.degrees(math.acos(PAD / BODY_RADIUS))
    right = [
        (FOOT_END, 0.0), *arc((FOOT_END - 4, FOOT - 4), 4, 0, 90, 4),
        *arc((BODY_RADIUS + 8, FOOT + 8), 8, -90, -180, 6),
        *arc((0.0, AXIS_HEIGHT), BODY_RADIUS, 0, pad_angle, 16), (PAD, PAD_HEIGHT),
    ]
    left = [(-x, y) for x, y in reversed(right)]
    return [*right, *left, (-30.0, 0.0), (-27.0, 3.0), (27.0, 3.0), (30.0, 0.0)]


def rectangle(axis, height, low_u, low_v, high_u, high_v):
    corners = ((low_u, low_v), (high_u, low_v), (high_u, high_v), (low_u, high_v))
    return [placed(axis, height, u, v) for u, v in corners]


def add_body(solid):
    """Front, back and sides, with feet that slots go through, and a greasing hole in the top."""
    profile = bearing_profile()
    front, back = ([(x, y, z) for x, y in profile] for z in (DEPTH, -DEPTH))
    for k, (x, y) in enumerate(profile):
        next_x, next_y = profile[(k + 1) % len(profile)]
        is_flat_with_hole = y == next_y and (y in (FOOT, PAD_HEIGHT) or (y == 0.0 and x * next_x > 0))
        if not is_flat_with_hole:
            solid.panel(back[k], back[(k + 1) % len(back)], front[(k + 1) % len(front)], front[k])
    for z, loop in ((DEPTH, front), (-DEPTH, back)):
        solid.flat(loop, [circle("z", (0.0, AXIS_HEIGHT), 40.0, z, SIDES)], "z", faces_up=z > 0)

    for side in (1, -1):
        near, far, middle = side * (BODY_RADIUS + 8), side * (FOOT_END - 4), side * 68.5
        rims = [slot(middle, 6.0, radius, height) for radius, height in ((7.0, FOOT), (5.5, FOOT - 1.5), (5.5, 0.0))]
        solid.flat(rectangle("y", FOOT, -DEPTH, min(near, far), DEPTH, max(near, far)), [rims[0]], "y")
        solid.wall(*rims)
        ends = sorted((side * 30.0, side * FOOT_END))
        solid.flat(rectangle("y", 0.0, -DEPTH, ends[0], DEPTH, ends[1]), [rims[-1]], "y", faces_up=False)

    rings = [circle("y", (0.0, 0.0), radius, height, 20) for radius, height in ((4.0, 96.0), (3.0, 95.0), (3.0, 86.0))]
    solid.flat(rectangle("y", PAD_HEIGHT, -DEPTH, -PAD, DEPTH, PAD), [rings[0]], "y")
    solid.wall(*rings)
    solid.cone(rings[-1], (0.0, 84.3, 0.0))


def add_bore(solid):
    """The bosses on both sides, rounded where they meet the body, and the stepped bore; screw holes in the front."""
    def ring(radius, z):
        return circle("z", (0.0, AXIS_HEIGHT), radius, z, SIDES)

    boss = [(x, DEPTH + y) for x, y in arc((40.0, 4.0), 4.0, 270, 180, 6)] + [(36.0, 30.5), (34.5, 32.0)]
    bore = [(26.0, 32.0), (26.0, 27.0), (21.5, 27.0), (20.0, 25.5), (20.0, -25.5), (21.5, -27.0), (26.0, -27.0),
            (26.0, -32.0)]
    front = [ring(radius, z) for radius, z in boss]
    inner = [ring(radius, z) for radius, z in bore]
    screws = []
    for k in range(SCREWS):
        angle = math.tau * (k + 0.5) / SCREWS
        centre = (30.2 * math.cos(angle), AXIS_HEIGHT + 30.2 * math.sin(angle))
        walls = [circle("z", centre, radius, z, 16) for radius, z in ((2.4, 32.0), (2.4, 22.0))]
        solid.wall(*walls)
        solid.cone(walls[-1], placed("z", 20.6, *centre))
        screws.append(walls[0])
    solid.wall(*front)
    solid.flat(front[-1], [inner[0], *screws], "z")
    solid.wall(*inner)
    solid.wall(inner[-1], *reversed([ring(radius, -z) for radius, z in boss]))


def bearing():
    solid = Solid("bearing", "cast_iron")
    add_body(solid)
    add_bore(solid)
    return [solid.mesh]


# --- Two pipes ---------------------------------------------------------------------------------

PIPE_MATERIALS = {"brass": ((0.85, 0.68, 0.32), 0.4, 40), "steel": ((0.62, 0.68, 0.74), 0.4, 40)}


def pipe(name, material, axis, radii, length):
    solid = Solid(name, material)
    outer, inner = radii
    ends = ((inner, -length), (outer, -length), (outer, length), (inner, length), (inner, -length))
    solid.wall(*(circle(axis, (0.0, 0.0), radius, height / 2, 96) for radius, height in ends))
    return solid.mesh


def pipes():
    return [pipe("run", "brass", "x", (24.0, 20.0), 130.0),
            transformed(pipe("branch", "steel", "y", (17.0, 14.0), 110.0), tilt=12)]


# --- A scan ------------------------------------------------------------------------------------

LEG, OTHER_LEG = 62.0, 40.0  # of the bracket, from the bend to the ends
BEND = 7.0  # inner radius
THICKNESS, WIDTH = 8.0, 42.0
STEP = 0.6  # between the points of the scan
NOISE = 0.09  # of their places, at most


def bent(along, out, across):
    """A point of the bracket: along the plate, out from its inner face, across its width."""
    quarter = math.pi / 2 * BEND
    if along < LEG:
        return (BEND + LEG - along, -out, across)
    if along > LEG + quarter:
        return (-out, BEND + along - LEG - quarter, across)
    angle = (along - LEG) / BEND
    radius = BEND + out
    return (BEND - radius * math.sin(angle), BEND - radius * math.cos(angle), across)


def scanned_bracket():
    """A bent plate as a cloud of points that a scanner measured with some noise, joined to a closed surface."""
    sizes = (LEG + math.pi / 2 * BEND + OTHER_LEG, THICKNESS, WIDTH)
    counts = [round(size / STEP) for size in sizes]
    number = random_numbers("scan")
    shifts = {}

    def place(key):
        if key not in shifts:
            shifts[key] = tuple(NOISE * (2 * number() - 1) for _ in range(3))
        point = bent(*(size * k / count for size, k, count in zip(sizes, key, counts)))
        return tuple(a + b for a, b in zip(point, shifts[key]))

    solid = Solid("bracket")
    for fixed in range(3):
        u, v = ACROSS[AXES[fixed]]
        for level in (0, counts[fixed]):
            def at(i, j):
                key = [0, 0, 0]
                key[fixed], key[u], key[v] = level, i, j
                return place(tuple(key))

            for i in range(counts[u]):
                for j in range(counts[v]):
                    corners = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                    solid.panel(*(corners if level else reversed(corners)))
    return [solid.mesh]
