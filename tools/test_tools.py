"""Tests of the shipped data: python3 -m unittest discover -s tools -p test_tools.py

They read data/; that data/ is what the scripts make is checked by make_data.py --check.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import machine_parts
import make_gallery
import make_models
import meshes
import paper_tables
import teapot
from make_data import DATA
from shared import read_png, write_png

TEXTURES = DATA / "textures"
MODELS = DATA / "models"


def lightness(pixel):
    return sum(pixel) / 765


def stroke_rows(name):
    """The light of an image of strokes, 0 to 255."""
    return [[pixel[0] for pixel in row] for row in read_png(TEXTURES / "hatching" / f"{name}.png")]


TONAL, VOLUMES = ("pencil", "ink", "brush"), ("pencil_volume", "ink_volume")


def stroke_images():
    """(name, image, x, y, size, ink share) of every single picture of strokes in the textures."""
    for name in TONAL:
        image = stroke_rows(name)
        width = len(image[0])
        tones = 2 * len(image) // width
        for tone in range(tones):
            x, size = 0, width // 2
            while size:
                yield name, image, x, tone * width // 2, size, tone / (tones - 1)
                x, size = x + size, size // 2
    for name in VOLUMES:
        image = stroke_rows(name)
        side = len(image[0])
        slices = len(image) // side
        for number in range(slices):
            yield name, image, 0, number * side, side, number / (slices - 1)
    for name, ink in (("parallel", 1 / 3), ("crosshatch", 2 / 3)):
        image = stroke_rows(name)
        yield name, image, 0, 0, len(image), ink


def tone_series():
    """(name, pictures from white to black) of each tonal image in its two largest sizes, and of each volume."""
    series = {}
    for name, image, x, y, size, _ in stroke_images():
        if size >= 128:
            series.setdefault((name, size), []).append([row[x : x + size] for row in image[y : y + size]])
    return [(f"{name} {size}", images) for (name, size), images in series.items() if len(images) > 1]


class Pictures(unittest.TestCase):
    def test_png_survives_writing_and_reading(self):
        few = [[(x % 5 / 255, 0, y % 7 / 255) for x in range(80)] for y in range(70)]
        many = [[(x / 255, y / 255, 0) for x in range(80)] for y in range(70)]
        with tempfile.TemporaryDirectory() as folder:
            for picture in (few, many):
                path = pathlib.Path(folder) / "picture.png"
                write_png(path, picture)
                expected = [[tuple(round(c * 255) for c in p) for p in row] for row in picture]
                self.assertEqual(read_png(path), expected)

    def test_backgrounds_have_no_seams(self):
        """Across the border, neighbours differ no more than neighbours do inside."""
        paths = [*TEXTURES.glob("paper/*.png"), *TEXTURES.glob("canvas/*.png")]
        self.assertEqual(len(paths), 6)
        for path in paths:
            rows = [[lightness(p) for p in row] for row in read_png(path)]
            for lines in (rows, list(zip(*rows))):
                with self.subTest(path=path.name):
                    steps = [
                        sum(abs(a - b) for a, b in zip(line, following)) / len(line)
                        for line, following in zip(lines, lines[1:])
                    ]
                    seam = sum(abs(a - b) for a, b in zip(lines[-1], lines[0])) / len(lines)
                    self.assertLessEqual(seam, max(steps) * 1.05)
                    if path.name != "lined.png":
                        self.assertLess(seam, 1.6 * sum(steps) / len(steps))

    def test_papers_are_light_and_quiet(self):
        for path in TEXTURES.glob("paper/*.png"):
            values = [lightness(p) for row in read_png(path) for p in row]
            mean = sum(values) / len(values)
            deviation = math.sqrt(sum((v - mean) ** 2 for v in values) / len(values))
            with self.subTest(path=path.name):
                self.assertTrue(0.90 < mean < 0.98, mean)
                self.assertLess(deviation, 0.04 if path.name == "lined.png" else 0.02)

    def test_stroke_textures_wrap_along_the_stroke_and_end_at_its_sides(self):
        paths = [*TEXTURES.glob("strokes/*.png")]
        self.assertEqual(len(paths), 2)
        for path in paths:
            rows = [[lightness(p) for p in row] for row in read_png(path)]
            columns = list(zip(*rows))
            with self.subTest(path=path.name):
                steps = [
                    sum(abs(a - b) for a, b in zip(column, following)) / len(column)
                    for column, following in zip(columns, columns[1:])
                ]
                seam = sum(abs(a - b) for a, b in zip(columns[-1], columns[0])) / len(columns[0])
                self.assertLessEqual(seam, max(steps) * 1.05)
                middle = rows[len(rows) // 2]
                self.assertLess(sum(middle) / len(middle), 0.4)
                for row in (rows[0], rows[-1]):
                    self.assertGreater(sum(row) / len(row), 0.75)

    def test_toon_maps_grow_lighter_and_keep_the_highlight_for_the_last_texel(self):
        for path in TEXTURES.glob("toon/*.png"):
            rows = read_png(path)
            with self.subTest(path=path.name):
                self.assertEqual((len(rows), len(rows[0])), (1, 256))
        for name in ("three_tone", "four_tone"):
            tones = [pixel[0] for pixel in read_png(TEXTURES / "toon" / f"{name}.png")[0]]
            self.assertEqual(tones, sorted(tones))
            self.assertEqual(tones.count(255), 1)
            self.assertLess(tones[-2], 215)
        self.assertEqual({p[0] for p in read_png(TEXTURES / "toon" / "two_tone.png")[0]}, {140, 255})

    def test_strokes_have_the_tones_asked_for(self):
        """Tone k of n has an ink share of k / (n - 1), at each size of a tonal image and in each slice of a volume."""
        for name, image, x, y, size, ink in stroke_images():
            light = sum(sum(row[x : x + size]) for row in image[y : y + size])
            with self.subTest(name=name, x=x, y=y):
                self.assertAlmostEqual(light / size**2, 255 * (1 - ink), delta=1)

    def test_strokes_of_a_lighter_tone_are_in_a_darker_one(self):
        for name, images in tone_series():
            for number, (lighter, darker) in enumerate(zip(images, images[1:])):
                with self.subTest(name=name, tone=number):
                    self.assertFalse(any(d > l for upper, lower in zip(lighter, darker) for l, d in zip(upper, lower)))

    def test_strokes_have_no_seams(self):
        for name, images in tone_series():
            for rows in images[1:-1]:
                for lines in (rows, list(zip(*rows))):
                    steps = [sum(abs(a - b) for a, b in zip(*pair)) for pair in zip(lines, lines[1:])]
                    seam = sum(abs(a - b) for a, b in zip(lines[-1], lines[0]))
                    with self.subTest(name=name):
                        self.assertLess(seam, max(steps) * 1.05)

    def test_checker_is_the_first_image(self):
        self.assertEqual(min(TEXTURES.glob("images/*")).name, "checker.png")


def bearing_volume():
    """Of machine_parts.bearing() in cubic millimetres, its curves as true circles."""
    def cone(first, second, height):
        return math.pi / 3 * height * (first**2 + first * second + second**2)

    corner = 1 - math.pi / 4  # of a square that a quarter of a circle leaves
    feet = 2 * 88 * 16 - 2 * corner * 4**2 - 3 * (60 + 54) / 2
    half_angle = math.asin(9 / 44)
    cap = 44**2 * (half_angle - math.sin(2 * half_angle) / 2)  # what the pad's rectangle cuts off the circle
    pad = 18 * (96 - 50 - 44 * math.cos(half_angle)) - cap
    arch = 2 * 44 * (50 - 16) + math.pi / 2 * 44**2 + 2 * corner * 8**2 + pad
    foot_slot = (math.pi * 5.5**2 + 4 * 6 * 5.5) * 14.5 + cone(7, 5.5, 1.5) + 12 * 12.5 * 1.5
    grease = cone(4, 3, 1) + math.pi * 3**2 * 9 + math.pi * 3**2 * 1.7 / 3
    # A quarter of a circle of radius 4 round the boss leaves corner * 16, its centroid so far from the corner (Pappus).
    centroid = 4 * (10 - 3 * math.pi) / (12 - 3 * math.pi)
    boss = math.pi * 36**2 * 8.5 + cone(36, 34.5, 1.5) + corner * 16 * math.tau * (36 + centroid)
    bore = math.pi * 20**2 * 51 + 2 * cone(20, 21.5, 1.5) + 2 * math.pi * 26**2 * 5
    screws = 6 * (math.pi * 2.4**2 * 10 + math.pi * 2.4**2 * 1.4 / 3)
    return 44 * (feet + arch) - 2 * foot_slot - grease + 2 * boss - bore - screws


class Models(unittest.TestCase):
    def check(self, mesh, euler, loops):
        found = meshes.topology(mesh)
        self.assertEqual((found.euler, found.boundary_loops), (euler, loops))
        self.assertEqual((found.bad_edges, found.unused_points), (0, 0))
        self.assertGreater(found.volume, 0)
        self.assertGreater(found.smallest_area, 1e-6)
        self.assertGreater(found.worst_normal, 0.05)
        for normal in mesh.normals:
            self.assertAlmostEqual(meshes.dot(normal, normal), 1, delta=1e-3)

    def test_closed_models(self):
        for name, euler in (("cube", 2), ("two_material_cube", 2), ("sphere", 2), ("torus_knot", 0)):
            for mesh in meshes.read_obj(MODELS / f"{name}.obj"):
                with self.subTest(mesh=mesh.name):
                    self.check(mesh, euler, 0)

    def test_machine_parts(self):
        """Closed; the block has three ways through it, each pipe one."""
        for name, eulers in (("bearing", (-4,)), ("pipes", (0, 0))):
            for mesh, euler in zip(meshes.read_obj(MODELS / f"{name}.obj"), eulers, strict=True):
                with self.subTest(mesh=mesh.name):
                    self.check(mesh, euler, 0)

    def test_bearing_fills_its_volume(self):
        """Against the volumes of the bodies that it is made of, in closed form."""
        block, = meshes.read_obj(MODELS / "bearing.obj")
        self.assertAlmostEqual(meshes.topology(block).volume, bearing_volume(), delta=5e-4 * bearing_volume())

    def test_scan_is_closed_and_noisy(self):
        bracket, = machine_parts.scanned_bracket()
        self.check(bracket, 2, 0)
        self.assertEqual(len(bracket.faces), 66056)

    def test_every_object_of_the_scene_is_closed(self):
        for mesh in meshes.read_obj(MODELS / "scene.obj"):
            with self.subTest(mesh=mesh.name):
                self.check(mesh, 2, 0)

    def test_teapot_parts(self):
        """Body and lid open where they meet, handle and spout at both ends; no cracks."""
        parts = {mesh.name: mesh for mesh in meshes.read_obj(MODELS / "teapot.obj")}
        self.assertEqual(list(parts), ["body", "lid", "handle", "spout"])
        for name, euler, loops in (("body", 1, 1), ("lid", 1, 1), ("handle", 0, 2), ("spout", 0, 2)):
            with self.subTest(mesh=name):
                self.check(parts[name], euler, loops)

    def test_teapot_patches(self):
        """32 patches over the published points: 306, less 4 unused and 12 given twice."""
        patches = [p for bands in teapot.parts().values() for group, _, _ in bands for p in group]
        points = {tuple(round(c, 6) + 0.0 for c in q) for p in patches for row in p for q in row}
        self.assertEqual((len(patches), len(points)), (32, 290))
        for published in ((1.4, -0.784, 2.4), (-0.45, 0.8, 3.15), (3.525, 0.25, 2.49375),
                          (-2.65, -0.3, 0.9375), (0.798, 1.425, 0.0)):
            self.assertIn(published, points)

    def test_materials_exist(self):
        for path in MODELS.glob("*.obj"):
            words = [line.split() for line in path.read_text().splitlines()]
            used = {w[1] for w in words if w[0] == "usemtl"}
            libraries = [MODELS / w[1] for w in words if w[0] == "mtllib"]
            defined = {line.split()[1] for library in libraries
                       for line in library.read_text().splitlines() if line.startswith("newmtl")}
            with self.subTest(path=path.name):
                self.assertEqual(used, defined)

    def test_sphere_has_exactly_the_triangles_asked_for(self):
        for triangles in (20, 22, 58, 78, 80, 1000, 4998):
            mesh = make_models.sphere(triangles)
            with self.subTest(triangles=triangles):
                self.assertEqual(len(mesh.faces), triangles)
                self.check(mesh, 2, 0)
        for triangles in (18, 21):
            self.assertRaises(ValueError, make_models.sphere, triangles)


class Gallery(unittest.TestCase):
    def test_pen_goes_up_and_down_where_paths_end_and_begin(self):
        for path, lines in (
            ("M1 2L3 4", [((1, 2), (3, 4))]),
            ("M1 2l.5-.25 1 1", [((1, 2), (2.5, 2.75))]),
            ("M1 2L5 5 3 0ZM0 0c1 1 2 2 3-3", [((1, 2), (1, 2)), ((0, 0), (3, -3))]),
            ("M1 1c1 0 2 0 3 0 1 0 2 0 3 1l-1 0M10 10C0 0 0 0 7 8", [((1, 1), (6, 2)), ((10, 10), (7, 8))]),
        ):
            with self.subTest(path=path):
                self.assertEqual([tuple(line) for line in make_gallery.drawn_lines(path)], lines)

    def test_commands_are_the_lines_of_sh_blocks(self):
        page = "a\n```sh\n# no\ncroquis lines a.obj \\\n  -o a.svg\n```\n```text\ncroquis x\n```\n```sh\ntools/b.py\n```\n"
        self.assertEqual(make_gallery.commands_of(page), [["croquis", "lines", "a.obj", "-o", "a.svg"], ["tools/b.py"]])


class PaperTables(unittest.TestCase):
    def test_a_figure_for_each_number_of_faces(self):
        for table in paper_tables.TABLES:
            for column in table.columns:
                with self.subTest(table=table.title, column=column.paper_name):
                    self.assertEqual(len(column.fps), len(table.faces))

    def test_shares_are_of_the_first_column(self):
        columns = [paper_tables.Column("Plain", "phong", (100, 50)), paper_tables.Column("Inked", "cartoon", (40, None))]
        table = paper_tables.Table("Seed X", (1000, 2000), columns)
        text = paper_tables.markdown(table, columns, {columns[0]: [300, 200], columns[1]: [150, 50]})
        self.assertEqual(text.splitlines()[4:], [
            "| Plain (`phong`) | 1,000 | 100 | 300 | 1.00 | 1.00 |",
            "|  | 2,000 | 50 | 200 | 1.00 | 1.00 |",
            "| Inked (`cartoon`) | 1,000 | 40 | 150 | 0.40 | 0.50 |",
            "|  | 2,000 |  | 50 |  | 0.25 |",
        ])


if __name__ == "__main__":
    unittest.main()
