"""The Utah teapot: Martin Newell's control points and their tessellation.

Source: M. E. Newell, The Utilization of Procedure Models in Digital Image Synthesis, PhD
thesis, University of Utah, 1975; F. Crow, The Origins of the Teapot, IEEE Computer Graphics
and Applications 7(1), 1987; height scaled by Blinn, bottom added later, as everybody's teapot.

The published list has 306 points and 32 bicubic Bezier patches. Rim, body, lid and bottom
are surfaces of revolution: a quarter turn at radius r has the points (r, 0), (r, k), (k, r),
(0, r) with k = 0.56 r, so a profile of radii and heights says it all. Handle and spout are
mirror images in the plane y = 0. Published coordinates have z up; the mesh has y up, the spout
towards +x and the handle towards -x.
"""

import math

from meshes import Mesh, Welder, add_grid, cross, dot, unit

# Profiles, from the bottom up: four (radius, height) a ring of four patches.
BOTTOM = [(0, 0), (1.425, 0), (1.5, 0.075), (1.5, 0.15)]
BODY_LOWER = [(1.5, 0.15), (1.5, 0.225), (2, 0.45), (2, 0.9)]
BODY_UPPER = [(2, 0.9), (2, 1.35), (1.75, 1.875), (1.5, 2.4)]
RIM = [(1.5, 2.4), (1.4375, 2.53125), (1.3375, 2.53125), (1.4, 2.4)]
LID = [(1.3, 2.4), (1.3, 2.55), (0.4, 2.55), (0.2, 2.7)]
KNOB = [(0.2, 2.7), (0, 2.85), (0.8, 3.15), (0, 3.15)]

# Half sections: four points at y = 0, w, w, 0, given as (x, z), (x, z, w), (x, z, w), (x, z);
# each patch is four such sections along handle or spout.
HANDLE = [
    [(-1.6, 2.025, 0), (-1.6, 2.025, 0.3), (-1.5, 2.25, 0.3), (-1.5, 2.25, 0)],
    [(-2.3, 2.025, 0), (-2.3, 2.025, 0.3), (-2.5, 2.25, 0.3), (-2.5, 2.25, 0)],
    [(-2.7, 2.025, 0), (-2.7, 2.025, 0.3), (-3.0, 2.25, 0.3), (-3.0, 2.25, 0)],
    [(-2.7, 1.8, 0), (-2.7, 1.8, 0.3), (-3.0, 1.8, 0.3), (-3.0, 1.8, 0)],
    [(-2.7, 1.575, 0), (-2.7, 1.575, 0.3), (-3.0, 1.35, 0.3), (-3.0, 1.35, 0)],
    [(-2.5, 1.125, 0), (-2.5, 1.125, 0.3), (-2.65, 0.9375, 0.3), (-2.65, 0.9375, 0)],
    [(-2.0, 0.9, 0), (-2.0, 0.9, 0.3), (-1.9, 0.6, 0.3), (-1.9, 0.6, 0)],
]
SPOUT = [
    [(1.7, 1.425, 0), (1.7, 1.425, 0.66), (1.7, 0.6, 0.66), (1.7, 0.6, 0)],
    [(2.6, 1.425, 0), (2.6, 1.425, 0.66), (3.1, 0.825, 0.66), (3.1, 0.825, 0)],
    [(2.3, 2.1, 0), (2.3, 2.1, 0.25), (2.4, 2.025, 0.25), (2.4, 2.025, 0)],
    [(2.7, 2.4, 0), (2.7, 2.4, 0.25), (3.3, 2.4, 0.25), (3.3, 2.4, 0)],
    [(2.8, 2.475, 0), (2.8, 2.475, 0.25), (3.525, 2.49375, 0.25), (3.525, 2.49375, 0)],
    [(2.9, 2.475, 0), (2.9, 2.475, 0.15), (3.45, 2.5125, 0.15), (3.45, 2.5125, 0)],
    [(2.8, 2.4, 0), (2.8, 2.4, 0.15), (3.2, 2.4, 0.15), (3.2, 2.4, 0)],
]


def ring(profile):
    """Four patches round the axis; columns go counter-clockwise seen from above."""
    patches = []
    for quarter in range(4):
        c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter]
        patch = []
        for r, z in profile:
            k = 0.45 if r == 0.8 else 0.56 * r  # the published knob is rounded
            patch.append([
                (x * c - y * s, x * s + y * c, z) for x, y in ((r, 0), (r, k), (k, r), (0, r))
            ])
        patches.append(patch)
    return patches


def tube(sections):
    """Patches of two halves along a tube: on one side of the plane y = 0 and on the other."""
    patches = []
    for start in (0, 3):
        quad = sections[start : start + 4]
        near = [[(x, -w, z) for x, z, w in row] for row in quad]
        far = [[(x, w, z) for x, z, w in reversed(row)] for row in quad]
        patches.append([near, far])
    return patches


def parts():
    """name -> list of bands of patches, each band at its place along v (from, to)."""
    return {
        "body": [(ring(BOTTOM), 0.0, 0.15), (ring(BODY_LOWER), 0.15, 0.45),
                 (ring(BODY_UPPER), 0.45, 0.9), (ring(RIM), 0.9, 1.0)],
        "lid": [(ring(LID), 0.0, 0.6), (ring(KNOB), 0.6, 1.0)],
        "handle": list(zip(tube(HANDLE), (0.0, 0.5), (0.5, 1.0))),
        "spout": list(zip(tube(SPOUT), (0.0, 0.7), (0.7, 1.0))),
    }


def bernstein(t):
    s = 1 - t
    values = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
    slopes = (-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t)
    return values, slopes


def mix(patch, along, across):
    """Sum of control points, weighted; from z up to y up on the way."""
    x, y, z = (
        math.fsum(along[i] * across[j] * patch[i][j][k] for i in range(4) for j in range(4))
        for k in range(3)
    )
    return (x, z, -y)


def evaluate(patch, u, v):
    """Point and exact unit normal; at a pole, where du vanishes, the axis."""
    across, across_slope = bernstein(u)
    along, along_slope = bernstein(v)
    normal = cross(mix(patch, along, across_slope), mix(patch, along_slope, across))
    point = mix(patch, along, across)
    if dot(normal, normal) < 1e-16:
        return point, (0.0, 1.0 if point[1] > 1 else -1.0, 0.0)
    return point, unit(normal)


def teapot(divisions=12):
    """Four meshes, 'divisions' cells along each side of a patch."""
    meshes = []
    for name, bands in parts().items():
        mesh = Mesh(name, material="accent" if name in ("lid", "handle") else "porcelain")
        weld_points, weld_normals = Welder(mesh.points), Welder(mesh.normals)
        steps = [step / divisions for step in range(divisions + 1)]
        for patches, low, high in bands:
            for number, patch in enumerate(patches):
                grid = [[evaluate(patch, u, v) for u in steps] for v in steps]
                uvs = [
                    [((number + u) / len(patches), low + (high - low) * v) for u in steps]
                    for v in steps
                ]
                points = [[point for point, _ in row] for row in grid]
                normals = [[normal for _, normal in row] for row in grid]
                add_grid(mesh, points, uvs, normals, weld_points, weld_normals)
        meshes.append(mesh)
    return meshes
