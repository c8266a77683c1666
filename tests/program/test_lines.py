"""`croquis lines`: what its files hold, and that pictures of them agree with each other and with `croquis render`."""

import json
import math
import os
import random
import re

import drawings
import program
from program import MODELS, OWN_DATA

CUBE = MODELS / "cube.obj"
TEAPOT = MODELS / "teapot.obj"
KNOT = MODELS / "torus_knot.obj"
SCENE = MODELS / "scene.obj"
TWO_BOXES = OWN_DATA / "two_boxes.obj"
FRAME = ("--size", "320x240")
CLASSES = "contour, silhouette, border, tagged, crease, intersection, material"

WRONG_OPTIONS = [
    (["--classes", "countour"], f'--classes: expected {CLASSES}, found "countour"; did you mean "contour"?'),
    (["--classes", "contour,+crease"], '--classes: expected names, or +NAME and -NAME, found "contour,+crease"'),
    (["--classes", ","], '--classes: expected names, or +NAME and -NAME, found ","'),
    (["--width", "crease"], '--width: expected CLASS=MM, found "crease"'),
    (["--width", "creese=1"], f'--width: expected {CLASSES}, found "creese"; did you mean "crease"?'),
    (["--width", "crease=0"], "expected a width of crease lines above 0 and at most 100 mm, found 0"),
    (["--hidden", "dotted"], '--hidden: expected none, dashed or styled, found "dotted"'),
    (["--hidden", "dashd"], '--hidden: expected none, dashed or styled, found "dashd"; did you mean "dashed"?'),
    (["--hidden-width", "-1"], "expected a width of hidden lines above 0 and at most 100 mm, found -1"),
    (["--crease-angle", "200"], "expected the crease angle to be 0 to 180 degrees, found 200"),
    (["--crease-angle", "x"], '--crease-angle: expected a number, found "x"'),
    (["--size", "0x10"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "0x10"'),
    (["--size", "100000x10"], "expected a size of 1x1 to 65536x65536 pixels, found 100000x10"),
    (["--paper", "a9"], 'unknown paper "a9"; did you mean "a0"?'),
    (["--paper", "0x10"], '--paper: expected millimetres above 0 as WIDTHxHEIGHT, found "0x10"'),
    (["--paper", "0x0"], '--paper: expected millimetres above 0 as WIDTHxHEIGHT, found "0x0"'),
    (["--paper", "20000x10"], "expected a sheet of up to 10000 x 10000 mm, found 20000 x 10"),
    (["--landscape"], "--landscape: expected --paper with it, found none"),
    (["--paper", "a6", "--margin", "60"], "expected margins that leave something of the sheet of 105 x 148 mm, found 60 mm"),
    (["--margin", "-1"], "expected a margin of 0 to 10000 mm, found -1"),
    (["--fill", "black"], '--fill: expected none, white or regions, found "black"'),
    (["--fill", "white", "--plotter"], "expected no fill for a plotter, which draws lines alone"),
    (["--views", "front,sid"], 'unknown view "sid"'),
    (["--views", "front,front"], 'expected each view once on a sheet, found "front" twice'),
    (["--views", ","], '--views: expected names of views, found ","'),
    (["--views", ""], '--views: expected names of views, found ""'),
    (["--views", "front,top", "--eye", "1,2,3"], "--views are parallel views along the axes: they do not go with --eye"),
    (["--arrangement", "second"], '--arrangement: expected third or first, found "second"'),
    (["--clean", "--exact"], "expected --clean or --exact, found both"),
    (["--visibility", "raycast"], 'expected the visibility to be automatic, quantitative, walking, ray_cast or none, found "raycast"; did you mean "ray_cast"?'),
    (["--finder", "exhaustiv"], re.compile(r'.*"exhaustiv"; did you mean "exhaustive"\?')),
    (["--stroke", "technicl"], re.compile(r'.*"technicl".*; did you mean "technical"\?')),
    (["--data", "nowhere"], "nowhere: no such data folder"),
    (["--format", "dxf"], '--format: expected svg, pdf or json, found "dxf"'),
    (["--subdivide", "9"], re.compile(r".*0 to 5.*9.*")),
    (["--subdivide", "1", "--scheme", "lop"], re.compile(r'.*"lop".*; did you mean "loop"\?')),
    (["--repeat", "0"], "--repeat: expected 1 to 10000, found 0"),
    (["--view", "fron"], 'unknown view "fron"; did you mean "front"?'),
    (["--eye", "nan,0,0"], '--eye: expected three numbers as X,Y,Z, found "nan,0,0"'),
    (["--view", "0,0,0"], "expected the view to have a direction, found 0,0,0"),
    (["--eye", "1,1"], '--eye: expected three numbers as X,Y,Z, found "1,1"'),
    (["--animation", "run"], f'{CUBE}: expected animation clip "run", found a model without clips'),
    (["--technique", "cartoon"], 'unknown argument "--technique"'),
]

WRONG_PLACES = [
    (["-o", "missing/a.svg"], "missing/a.svg: folder missing does not exist"),
    (["-o", "a.png"], "a.png: expected a path that ends in .svg, .pdf or .json, or --format"),
    (["-o", "a"], "a: expected a path that ends in .svg, .pdf or .json, or --format"),
    (["-o", "-"], "expected --format svg, pdf or json for standard output"),
    (["-o", "."], ".: expected a path that ends in .svg, .pdf or .json, or --format"),
]

# Models that are no closed surface, and what stands in them.
ODD_MODELS = {
    "three faces on an edge": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0.5\nv 0 0.5 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
    "faces of no area": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 1 1 1\nf 1 2 4\nf 1 2 3\nf 2 5 3\nf 1 1 2\n",
    "points that are no numbers": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\nf 2 5 3\nf 1 2 4\n",
    "neighbours wound two ways": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.3\nf 1 2 3\nf 2 3 4\n",
    "one face": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
}


def one_thread():
    """Leaves this process one processor, and so one thread."""
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})


def between(a, b, step):
    """Places from a to b, none farther than `step` from the next."""
    count = max(1, math.ceil(math.dist(a, b) / step))
    return [(a[0] + (b[0] - a[0]) * i / count, a[1] + (b[1] - a[1]) * i / count) for i in range(count + 1)]


def obj_of_boxes(boxes):
    """An OBJ file of axis-aligned boxes ((low), (high), material name)."""
    lines, at = [], 0
    for low, high, material in boxes:
        corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
        lines += [f"o {material}"] + ["v {} {} {}".format(*corner) for corner in corners] + [f"usemtl {material}"]
        for face in ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)):
            lines.append("f " + " ".join(str(at + corner) for corner in face))
        at += 8
    return "mtllib own.mtl\n" + "\n".join(lines) + "\n"


MATERIALS = "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n"
# Boxes through each other, and one behind a hole.
CROSSING = [
    ((-2, -0.4, -0.5), (2, 0.4, 0.5), "red"),
    ((-0.4, -2, -0.4), (0.4, 2, 0.7), "green"),
    ((-1.5, -1.5, -2), (-0.6, 1.7, -1.2), "blue"),
]


class LinesTest(program.ProgramTest):
    def drawing(self, *arguments):
        """The SVG of `croquis lines`, which must say nothing."""
        return drawings.Drawing(self.said("lines", *arguments, "--format", "svg", "-o", "-"))

    def json(self, *arguments):
        """The JSON of `croquis lines`, which must say nothing."""
        return drawings.read_json(self.said("lines", *arguments, "--format", "json", "-o", "-"))

    def crossing_boxes(self):
        self.write("own.mtl", MATERIALS)
        return self.write("own.obj", obj_of_boxes(CROSSING))


class Json(LinesTest):
    def test_cube_seen_from_the_front(self):
        """One square, known beforehand: eye 7 before the middle, so 6 before the face, 40 degrees over 240 pixels."""
        found = self.json(CUBE, "--eye", "0,0,7", *FRAME)
        self.assertEqual((found["width"], found["height"]), (320, 240))
        half = 120 / math.tan(math.radians(20)) / 6
        corners = {(round(160 + x * half, 2), round(120 + y * half, 2), 6.0) for x in (-1, 1) for y in (-1, 1)}
        points = {(round(x, 2), round(y, 2), round(depth, 4)) for path in found["paths"] for x, y, depth in path["points"]}
        self.assertEqual(points, corners)
        self.assertAlmostEqual(sum(drawings.length(path["points"], path["closed"]) for path in found["paths"]), 8 * half, 0)
        self.assertEqual({path["mesh"] for path in found["paths"]}, {"cube"})

    def test_depth_is_in_the_units_of_the_file(self):
        self.write("large.obj", re.sub(r"(?m)^v (\S+) (\S+) (\S+)$", lambda v: "v " + " ".join(str(50 * float(x)) for x in v.groups()), CUBE.read_text()))
        small, large = (self.json(model, "--eye", eye, *FRAME) for model, eye in ((CUBE, "3,4,7"), ("large.obj", "150,200,350")))
        depths = [sorted(point[2] for path in found["paths"] for point in path["points"]) for found in (small, large)]
        self.assertEqual(len(depths[0]), len(depths[1]))
        for one, other in zip(*depths):
            self.assertAlmostEqual(50 * one, other, delta=1e-3 * other)

    def test_lines_lie_in_the_frame(self):
        for arguments in ([TEAPOT], [KNOT, "--eye", "1,1,1.2", "--target", "0,0,0"], [SCENE, "--hidden", "dashed"]):
            found = self.json(*arguments, *FRAME)
            self.assertGreater(len(found["paths"]), 3)
            for path in found["paths"]:
                for x, y, depth in path["points"]:
                    self.assertTrue(-0.001 <= x <= 320.001 and -0.001 <= y <= 240.001 and depth > 0, (x, y, depth))

    def test_classes(self):
        everything = {path["class"] for path in self.json(SCENE, *FRAME)["paths"]}
        self.assertTrue({"contour", "silhouette"} <= everything)
        self.assertEqual({path["class"] for path in self.json(SCENE, *FRAME, "--classes", "silhouette")["paths"]}, {"silhouette"})
        others = {path["class"] for path in self.json(SCENE, *FRAME, "--classes=-silhouette")["paths"]}
        self.assertTrue(everything - {"silhouette"} <= others)
        self.assertNotIn("silhouette", others)

    def test_hidden_lines_are_asked_for(self):
        for hidden, layers in (("none", {0}), ("dashed", {0, 1})):
            found = self.json(CUBE, "--hidden", hidden, *FRAME)
            self.assertEqual({path["layers"] for path in found["paths"]}, layers)

    def test_same_bytes_on_any_number_of_threads(self):
        for kind in ("svg", "pdf", "json"):
            command = ("lines", TEAPOT, "--hidden", "styled", "--format", kind, "-o", "-")
            runs = [self.croquis(*command), self.croquis(*command), self.croquis(*command, preexec_fn=one_thread)]
            self.assertEqual({(run.status, run.errors) for run in runs}, {(0, "")})
            self.assertEqual(len({run.output for run in runs}), 1)
            self.assertGreater(len(runs[0].output), 1000)


class Svg(LinesTest):
    def test_valid_against_the_dtd(self):
        styles = [[], ["--plotter"], ["--fill", "regions"], ["--hidden", "styled", "--stroke", "ink_taper"], ["--views", "front,top,right,iso"]]
        for number, arguments in enumerate(styles):
            with self.subTest(arguments=arguments):
                path = self.folder / f"{number}.svg"
                self.said("lines", SCENE, "-o", path, *arguments)
                self.assertEqual(drawings.validate(path), "")
                ids = drawings.Drawing(path.read_text()).ids()
                self.assertEqual(len(ids), len(set(ids)))

    def test_names_that_are_none_in_xml(self):
        names = ["a b", "a_b", "<&\"'>", "é", "-1", "a b", "]]>", "x" * 300]
        text = "".join(
            f"o {name}\nv {3 * i} 0 0\nv {3 * i + 2} 0 0\nv {3 * i} 2 0\nv {3 * i} 0 2\n"
            + "".join("f {} {} {}\n".format(*(4 * i + corner for corner in face)) for face in ((1, 3, 2), (1, 2, 4), (2, 3, 4), (1, 4, 3)))
            for i, name in enumerate(names)
        )
        self.write("names & co.obj", text.encode() + b"o \xff\xfe\x01\nv 30 0 0\nv 32 0 0\nv 30 2 0\nf -3 -2 -1\n")
        self.said("lines", "names & co.obj")
        self.assertEqual(drawings.validate(self.folder / "names & co.svg"), "")
        svg = drawings.Drawing((self.folder / "names & co.svg").read_text())
        self.assertEqual(len(svg.ids()), len(set(svg.ids())))
        self.assertIn("<&\"'>", [title.text for title in svg.root.iter(f"{drawings.SVG}title")])
        self.assertEqual(svg.description, "croquis lines 'names & co.obj'")
        self.assertIn("é", {path["mesh"] for path in self.json("names & co.obj")["paths"]})

    def test_paper(self):
        for arguments, size in [
            ([], (270.933, 203.2)),
            (["--size", "960x480"], (254, 127)),
            (["--size", "960x480", "--margin", "5"], (264, 137)),
            (["--paper", "a4"], (210, 297)),
            (["--paper", "a4", "--landscape"], (297, 210)),
            (["--paper", "letter"], (215.9, 279.4)),
            (["--paper", "120.5x80"], (120.5, 80)),
            (["--paper", "120.5x80", "--size", "100x100"], (120.5, 80)),
        ]:
            with self.subTest(arguments=arguments):
                svg = self.drawing(TEAPOT, *arguments)
                self.assertEqual((svg.width, svg.height), size)
                self.assertEqual(svg.view_box, [0, 0, *size])

    def test_margin_is_kept(self):
        for margin in (10, 35):
            svg = self.drawing(TEAPOT, "--paper", "a5", "--margin", str(margin), "--fit", "1")
            points = [point for path in svg.paths() for point in path.points]
            for side, low, high in ((0, margin, 148 - margin), (1, margin, 210 - margin)):
                self.assertGreaterEqual(min(point[side] for point in points), low - 0.01)
                self.assertLessEqual(max(point[side] for point in points), high + 0.01)
            # The model touches a side of the frame.
            gaps = [point[0] - margin for point in points] + [148 - margin - point[0] for point in points]
            self.assertAlmostEqual(min(gaps), 0, delta=0.5)

    def test_widths(self):
        svg = self.drawing(SCENE, "--width", "contour=1.25", "--width", "silhouette=0.1")
        self.assertEqual({path.attributes["stroke-width"] for path in svg.paths("visible-contour")}, {"1.25"})
        self.assertEqual({path.attributes["stroke-width"] for path in svg.paths("visible-silhouette")}, {"0.1"})
        hidden = self.drawing(SCENE, "--hidden", "dashed", "--hidden-width", "0.2", "--paper", "a3").paths("hidden")
        self.assertEqual({path.attributes["stroke-width"] for path in hidden}, {"0.2"})

    def test_groups(self):
        """Every line of the JSON stands in the group of its visibility, class and mesh, closed where it is closed."""
        found, svg = self.json(TEAPOT, "--hidden", "dashed"), self.drawing(TEAPOT, "--hidden", "dashed")
        for path in found["paths"]:
            name = f"{'visible' if path['visible'] else 'hidden'}-{path['class']}-{path['mesh']}"
            self.assertIn(name, svg.ids())
        count = sum(path["visible"] for path in found["paths"])
        self.assertEqual(len(svg.paths("visible")), count)
        closed = sum(path["closed"] for path in found["paths"] if path["visible"])
        self.assertEqual(sum(path.closed for path in svg.paths("visible")), closed)
        names = [group.get("id") for group in svg.root.findall(f"{drawings.SVG}g")]
        self.assertEqual(names, ["hidden", "visible"])

    def test_same_ink_as_json(self):
        found, svg = self.json(TEAPOT), self.drawing(TEAPOT)
        pixels = sum(drawings.length(path["points"], path["closed"]) for path in found["paths"])
        millimetres = sum(path.length for path in svg.paths("visible"))
        self.assertAlmostEqual(millimetres / (pixels * 25.4 / 96), 1, places=3)

    def test_smooth_lines_are_curves(self):
        """Curves pass every point of the JSON and leave the chain of points by less than half a pixel."""
        for arguments in ([KNOT], [KNOT, "--plotter"], [KNOT, "--hidden", "dashed"], [KNOT, "--paper", "a3"]):
            with self.subTest(arguments=arguments):
                found, svg = self.json(*arguments), self.drawing(*arguments)
                cubics = [piece for path in svg.paths() for piece in path.pieces if len(piece) == 4]
                self.assertGreater(len(cubics), 50)
                self.assertLess(len(cubics), sum(len(path["points"]) for path in found["paths"]) / 2)
                margin = 10 if "--paper" in arguments else 0
                pixel = (svg.width - 2 * margin) / found["width"]
                chains = [path["points"] + path["points"][:1] if path["closed"] else path["points"] for path in found["paths"]]
                pieces = [(a[:2], b[:2]) for chain in chains for a, b in zip(chain, chain[1:])]
                for x, y in [place for path in svg.paths() for place in path.points][::11]:
                    place = (x - margin) / pixel, (y - margin) / pixel
                    self.assertLess(drawings.distance(place, pieces), 0.35)
                if "--hidden" not in arguments:
                    pieces = [piece for path in svg.paths() for piece in drawings.straightened(path)]
                    for point in [point for path in found["paths"] for point in path["points"]][::7]:
                        self.assertLess(drawings.distance((point[0] * pixel + margin, point[1] * pixel + margin), pieces), 0.15 * pixel)

    def test_exact_lines_are_polylines(self):
        for arguments in ([KNOT], [SCENE, "--plotter"]):
            self.assertEqual({len(piece) for path in self.drawing(*arguments, "--exact").paths() for piece in path.pieces}, {2})

    def test_polygons_stay_polygons(self):
        """A cube has no curves, and its corners are where the JSON has them."""
        svg, found = self.drawing(CUBE), self.json(CUBE)
        self.assertEqual({len(piece) for path in svg.paths() for piece in path.pieces}, {2})
        in_svg = [place for path in svg.paths() for piece in path.pieces for place in piece]
        in_json = [(x * 25.4 / 96, y * 25.4 / 96) for path in found["paths"] for x, y, _ in path["points"]]
        for ones, others in ((in_svg, in_json), (in_json, in_svg)):
            self.assertEqual([place for place in ones if min(math.dist(place, other) for other in others) > 0.002], [])

    def test_picture_agrees_with_json(self):
        """Every point of a line is dark, and everything dark is a point of a line, within a pixel."""
        widths = [word for name in CLASSES.split(", ") for word in ("--width", f"{name}=0.265")]
        self.said("lines", TEAPOT, *FRAME, *widths, "-o", "a.svg")
        picture = drawings.rasterised(self.folder / "a.svg", self.folder / "a.png")
        self.assertEqual((picture.width, picture.height), (320, 240))
        marked = set()
        for path in self.json(TEAPOT, *FRAME)["paths"]:
            points = path["points"] + path["points"][:1] if path["closed"] else path["points"]
            for (x0, y0, _), (x1, y1, _) in zip(points, points[1:]):
                steps = max(1, math.ceil(2 * math.hypot(x1 - x0, y1 - y0)))
                for i in range(steps + 1):
                    x, y = x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps
                    marked.add((min(int(x), 319), min(int(y), 239)))
        near = lambda x, y: [(i, j) for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1)]
        dark = {(x, y) for y, row in enumerate(picture.rows) for x, pixel in enumerate(row) if pixel[0] < 200}
        self.assertEqual([place for place in marked if not dark & set(near(*place))], [])
        self.assertEqual([place for place in dark if not marked & set(near(*place))], [])


class Fills(LinesTest):
    def rendered(self, model, *arguments):
        return self.drawn(model, "-t", "base", *FRAME, *arguments)

    def assert_alike(self, one, other, is_alike):
        """Pictures agree but at pixels where one of them changes from neighbour to neighbour."""
        def changes(picture, x, y):
            return len({picture.at(i, j)[:3] for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1)}) > 1

        inner = [(x, y) for y in range(1, 239) for x in range(1, 319) if not changes(one, x, y) and not changes(other, x, y)]
        self.assertGreater(len(inner), 0.7 * 318 * 238)
        self.assertEqual([place for place in inner if not is_alike(one.at(*place), other.at(*place))], [])

    def filled(self, fill, model, *arguments):
        """The fill alone, without lines, on a magenta ground."""
        self.said("lines", model, *FRAME, "--fill", fill, *arguments, "-o", "fill.svg")
        text = (self.folder / "fill.svg").read_text()
        text = re.sub(r'<g id="visible".*</g>\n(?=</svg>)', "", text, flags=re.DOTALL)
        self.write("fill.svg", text)
        self.assertEqual(drawings.validate(self.folder / "fill.svg"), "")
        return drawings.rasterised(self.folder / "fill.svg", self.folder / "fill.png", "#ff00ff")

    def test_white_covers_what_the_model_covers(self):
        for model in (TEAPOT, KNOT, SCENE, self.crossing_boxes()):
            for view in ("0.3,0.5,1", "front"):
                with self.subTest(model=model, view=view):
                    mask = self.rendered(model, "--background", "transparent", "--view", view)
                    fill = self.filled("white", model, "--view", view)
                    self.assert_alike(mask, fill, lambda a, b: (a[3] > 127) == (b[1] > 127))

    def test_white_within_the_model(self):
        mask = self.rendered(KNOT, "--background", "transparent", "--eye", "0.9,0.3,0.5")
        fill = self.filled("white", KNOT, "--eye", "0.9,0.3,0.5")
        self.assert_alike(mask, fill, lambda a, b: (a[3] > 127) == (b[1] > 127))

    def assert_regions(self, model):
        for view in ("1,0.7,1", "0.4,0.2,1", "front"):
            with self.subTest(model=model, view=view):
                flat = self.rendered(model, "--background", "#ff00ff", "--view", view)
                fill = self.filled("regions", model, "--view", view)
                self.assert_alike(flat, fill, lambda a, b: max(abs(i - j) for i, j in zip(a[:3], b[:3])) <= 2)

    def test_regions_have_the_colours_of_what_is_seen(self):
        for model in (TWO_BOXES, MODELS / "two_material_cube.obj", SCENE):
            self.assert_regions(model)

    def test_regions_end_where_parts_pass_through_each_other(self):
        self.assert_regions(self.crossing_boxes())


class Contours(LinesTest):
    """The contour is where the picture of `croquis render` goes over from the model to nothing."""

    WIDTH, HEIGHT = 480, 360
    SIZE = ("--size", f"{WIDTH}x{HEIGHT}")

    VIEWS = ["--view", "0.2,0.3,-1"], ["--view", "0.3,0.2,1", "--projection", "parallel"], ["--eye", "3,2,5", "--fov", "60"]

    def edges(self, mask, least):
        """Pixels covered so much that have a neighbour covered less, or the other way round."""
        inside = [[pixel[3] > least for pixel in row] for row in mask.rows]
        found = set()
        for y in range(self.HEIGHT):
            for x in range(self.WIDTH):
                for i, j in ((x + 1, y), (x, y + 1)):
                    if i < self.WIDTH and j < self.HEIGHT and inside[y][x] != inside[j][i]:
                        found |= {(x, y), (i, j)}
        return found

    def assert_agrees(self, mask, svg, most_missing):
        """No more edges of the picture than so many without a contour within a pixel, and no contour without an edge."""
        places = [(x * 96 / 25.4, y * 96 / 25.4) for path in svg.paths() for a, b in drawings.straightened(path) for x, y in between(a, b, 0.1)]
        pixels = {(int(x), int(y)) for x, y in places if x < self.WIDTH and y < self.HEIGHT}
        near = lambda x, y: {(i, j) for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1)}
        edges, with_slivers = self.edges(mask, 127), self.edges(mask, 127) | self.edges(mask, 0)
        self.assertGreater(len(edges), 500)
        missing = sorted(pixel for pixel in edges if not pixels & near(*pixel))
        self.assertLessEqual(len(missing), most_missing * len(edges), missing)
        # Holes may be smaller than the samples of a pixel see.
        beyond = sorted(pixel for pixel in pixels if not with_slivers & near(*pixel))
        self.assertLessEqual(len(beyond), 4, beyond)

    def test_agrees_with_the_picture(self):
        """Cleaning may leave out short pieces, and adds none."""
        for model in (TEAPOT, KNOT, SCENE, self.crossing_boxes()):
            for view in self.VIEWS:
                mask = self.drawn(model, *view, "-t", "base", *self.SIZE, "--samples", "9", "--background", "transparent")
                for how, most_missing in (("--exact", 0), ("--clean", 0.04)):
                    with self.subTest(model=model, view=view, how=how):
                        svg = self.drawing(model, *view, how, *self.SIZE, "--classes", "contour")
                        self.assert_agrees(mask, svg, most_missing)

    def test_subdivided(self):
        """Both commands draw the same smooth surface; catmull-clark makes another one than loop."""
        areas = []
        for scheme in ("loop", "catmull-clark"):
            options = ("--subdivide", "3", "--scheme", scheme, *self.SIZE)
            mask = self.drawn(CUBE, *options, "-t", "base", "--samples", "4", "--background", "transparent")
            self.assert_agrees(mask, self.drawing(CUBE, *options, "--exact", "--classes", "contour"), 0)
            areas.append(sum(pixel[3] for row in mask.rows for pixel in row))
        self.assertGreater(abs(areas[0] / areas[1] - 1), 0.005)
        self.refused("expected 0 to 5 levels of subdivision, found 6", "render", CUBE, "--subdivide", "6")

    def test_closed_outlines(self):
        """Where one contour comes out from behind another, a plotter's pen goes on: outlines, and holes, are closed."""
        for arguments, outlines in (([TEAPOT], 1), ([TEAPOT, "--exact"], 1), ([KNOT], 3), ([KNOT, "--exact"], 3), ([SCENE, "--exact"], 2)):
            paths = self.drawing(*arguments, "--classes", "contour", "--plotter").paths()
            self.assertEqual([path.closed for path in paths], outlines * [True], arguments)

    def test_contours_alone(self):
        """Of silhouettes, the contour is what has nothing behind it: no other class comes along."""
        for options in ([], ["--exact"], ["--hidden", "dashed"], ["--visibility", "ray_cast"]):
            found = self.json(TEAPOT, "--classes", "contour", *options)
            self.assertEqual({path["class"] for path in found["paths"]}, {"contour"})
            self.assertEqual({path["visible"] for path in found["paths"]}, {True})
            everything = [path for path in self.json(TEAPOT, *options)["paths"] if path["class"] == "contour"]
            ink = [sum(drawings.length(path["points"], path["closed"]) for path in paths) for paths in (found["paths"], everything)]
            self.assertAlmostEqual(ink[0] / ink[1], 1, delta=0.01)


class Plotter(LinesTest):
    def test_shorter_way_same_ink(self):
        self.write("own.mtl", MATERIALS)
        chance = random.Random(5)
        lows = [[chance.uniform(-10, 10) for _ in range(3)] for _ in range(120)]
        boxes = [(low, [side + 0.8 for side in low], "red") for low in lows]
        arguments = [self.write("boxes.obj", obj_of_boxes(boxes)), "--paper", "a3", "--landscape"]
        plain, plotted = self.drawing(*arguments), self.drawing(*arguments, "--plotter")
        self.assertGreater(len(plain.strokes()), 100)
        ink = [sum(path.length for path in drawing.strokes()) for drawing in (plain, plotted)]
        self.assertAlmostEqual(ink[1] / ink[0], 1, delta=0.01)
        self.assertLess(len(plotted.strokes()), len(plain.strokes()))
        self.assertEqual(len(plotted.paths()), len(plotted.strokes()))
        way = drawings.travel(plain.strokes()), drawings.travel(plotted.strokes())
        self.assertLess(way[1], way[0] / 4)

    def test_layers(self):
        svg = self.drawing(SCENE, "--plotter", "--hidden", "dashed")
        layers = svg.root.findall(f"{drawings.SVG}g")
        widths = [float(layer.get("stroke-width")) for layer in layers]
        self.assertEqual(widths, sorted(set(widths), reverse=True))
        for number, layer in enumerate(layers, start=1):
            self.assertEqual(layer.get(f"{drawings.INKSCAPE}groupmode"), "layer")
            self.assertTrue(layer.get(f"{drawings.INKSCAPE}label").startswith(f"{number} "))
            self.assertEqual(layer.get("id"), f"pen-{layer.get('stroke-width')}mm")
            self.assertEqual({element.tag for element in layer.iter()} - {layer.tag}, {f"{drawings.SVG}path"})

    def test_no_idle_points(self):
        for path in self.drawing(SCENE, "--plotter").paths():
            for piece in path.pieces:
                self.assertNotEqual(piece[0], piece[-1])
            following = path.pieces[1:] + path.pieces[:1] if path.closed else path.pieces[1:]
            for one, other in zip(path.pieces, following):
                (a, b, c) = one[0], one[-1], other[-1]
                if len(one) == len(other) == 2 and math.dist(a, c) > 0.1:
                    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
                    self.assertGreater(abs(area) / math.dist(a, c), 0.001)

    def test_what_lies_twice_is_drawn_once(self):
        """Two boxes almost in one place: as much ink as one."""
        self.write("own.mtl", MATERIALS)
        low, high, _ = CROSSING[0]
        moved = ([side + 1e-4 for side in low], [side + 1e-4 for side in high], "green")
        once = self.write("one.obj", obj_of_boxes([CROSSING[0]]))
        twice = self.write("two.obj", obj_of_boxes([CROSSING[0], moved]))
        options = ("--plotter", "--visibility", "none", "--classes", "contour,silhouette,crease")
        ink = [sum(path.length for path in self.drawing(model, *options, "--width", "contour=0.25", "--width", "silhouette=0.25").strokes()) for model in (once, twice)]
        self.assertAlmostEqual(ink[0], ink[1], delta=0.01 * ink[0])


class Views(LinesTest):
    def boxes(self, *arguments):
        """The box of each view's lines on the sheet of a 4 x 2 x 1 box."""
        self.write("own.mtl", MATERIALS)
        model = self.write("slab.obj", obj_of_boxes([((0, 0, 0), (4, 2, 1), "red")]))
        found = self.json(model, *arguments)
        boxes = {}
        for name in {path["view"] for path in found["paths"]}:
            points = [point for path in found["paths"] if path["view"] == name for point in path["points"]]
            xs, ys = [point[0] for point in points], [point[1] for point in points]
            boxes[name] = min(xs), min(ys), max(xs), max(ys)
        return boxes

    def assert_near(self, one, other):
        for a, b in zip(one, other):
            self.assertAlmostEqual(a, b, delta=0.01)

    def test_aligned_and_of_one_scale(self):
        for arrangement in ("third", "first"):
            boxes = self.boxes("--views", "front,top,right,iso", "--arrangement", arrangement)
            front, top, right, iso = (boxes[name] for name in ("front", "top", "right", "iso"))
            scale = (front[2] - front[0]) / 4
            self.assert_near((front[3] - front[1], top[3] - top[1], right[2] - right[0]), (2 * scale, scale, scale))
            self.assert_near((front[0], front[2]), (top[0], top[2]))
            self.assert_near((front[1], front[3]), (right[1], right[3]))
            self.assertEqual(right[0] > front[2], arrangement == "third")
            self.assertEqual(top[3] < front[1], arrangement == "third")
            self.assertAlmostEqual(iso[2] - iso[0], 5 / math.sqrt(2) * scale, delta=0.01)
            for one in boxes.values():
                self.assertTrue(0 < one[0] and one[2] < 1024 and 0 < one[1] and one[3] < 768)
                overlaps = [other for other in boxes.values() if other[0] < one[2] and one[0] < other[2] and other[1] < one[3] and one[1] < other[3]]
                self.assertEqual(overlaps, [one])

    def test_labels_and_groups(self):
        svg = self.drawing(CUBE, "--views", "front,left", "--fill", "white", "--hidden", "dashed")
        self.assertEqual([group.get("id") for group in svg.root.findall(f"{drawings.SVG}g")], ["front", "left"])
        self.assertEqual([text.text for text in svg.root.iter(f"{drawings.SVG}text")], ["front", "left"])
        self.assertTrue({"front-fill", "front-visible-contour-cube", "left-label"} <= set(svg.ids()))


class Files(LinesTest):
    def test_default_name_and_formats(self):
        self.said("lines", CUBE)
        self.said("lines", CUBE, "--format", "json")
        self.said("lines", CUBE, "-o", "b.pdf")
        self.said("lines", CUBE, "-o", "c.SVG")
        self.said("lines", CUBE, "-o", "d.txt", "--format", "svg")
        self.assertEqual(self.files(), {"cube.svg", "cube.json", "b.pdf", "c.SVG", "d.txt"})
        drawings.Drawing((self.folder / "d.txt").read_text())

    def test_pdf(self):
        self.said("lines", TEAPOT, "--paper", "a4", "--landscape", "--hidden", "styled", "--fill", "white", "-o", "a.pdf")
        data = (self.folder / "a.pdf").read_bytes()
        self.assertTrue(data.startswith(b"%PDF-"))
        box = [float(number) for number in re.search(rb"/MediaBox \[ ([\d. ]+) \]", data)[1].split()]
        self.assertEqual([round(side * 25.4 / 72) for side in box], [0, 0, 297, 210])
        self.assertNotIn(b"/Image", data)

    def test_wrong_options(self):
        for arguments, message in WRONG_OPTIONS:
            self.refused(message, "lines", CUBE, "-o", "out.svg", *arguments)

    def test_wrong_places(self):
        for arguments, message in WRONG_PLACES:
            self.refused(message, "lines", CUBE, *arguments)
        self.refused("model is required", "lines")
        self.refused("/dev/full: cannot write: No space left on device", "lines", CUBE, "--format", "svg", "-o", "/dev/full")

    def test_an_old_file_stays_when_writing_fails(self):
        self.write("a.svg", "old")
        self.refused("missing.obj: no such file", "lines", "missing.obj", "-o", "a.svg")
        self.assertEqual((self.folder / "a.svg").read_text(), "old")

    def test_empty_view(self):
        for kind in ("svg", "pdf", "json"):
            for arguments in ([], ["--plotter"], ["--fill", "white"], ["--fill", "regions"]):
                outcome = self.croquis("lines", CUBE, "--eye", "0,0,9", "--target", "0,0,99", "-o", f"a.{kind}", *arguments)
                message = f"croquis: warning: {CUBE}: no line lies in the frame: the drawing is empty\n"
                self.assertEqual((outcome.status, outcome.errors), (0, message))
        self.assertEqual(drawings.validate(self.folder / "a.svg"), "")
        self.assertEqual(drawings.read_json((self.folder / "a.json").read_text())["paths"], [])

    def test_odd_models(self):
        for name, text in ODD_MODELS.items():
            self.write("odd.obj", text)
            for arguments in ([], ["--hidden", "styled", "--exact"], ["--plotter"], ["--fill", "white"], ["--fill", "regions"], ["--stroke", "pencil"]):
                with self.subTest(model=name, arguments=arguments):
                    outcome = self.croquis("lines", "odd.obj", "-o", "odd.svg", *arguments)
                    self.assertEqual(outcome.status, 0, outcome.errors)
                    self.assertEqual(drawings.validate(self.folder / "odd.svg"), "")
                    self.assertGreater(len(drawings.Drawing((self.folder / "odd.svg").read_text()).paths()), 0)

    def test_eye_within_the_model(self):
        for arguments in ([], ["--hidden", "dashed"], ["--fill", "white"], ["--fill", "regions"], ["--plotter"]):
            outcome = self.croquis("lines", SCENE, "--eye", "0.1,0.4,0.1", "--target", "1,0.3,0", "-o", "in.svg", *arguments)
            self.assertEqual(outcome.status, 0, outcome.errors)
            self.assertEqual(drawings.validate(self.folder / "in.svg"), "")

    def test_strokes(self):
        for style in ("ink_taper", "pencil", "technical", "sketchy"):
            with self.subTest(style=style):
                self.said("lines", TEAPOT, *FRAME, "--stroke", style, "-o", "a.svg")
                self.assertEqual(drawings.validate(self.folder / "a.svg"), "")
        self.assertIn("fill", {name for path in self.drawing(TEAPOT, "--stroke", "ink_taper").paths() for name in path.attributes})
        styled = self.drawing(SCENE, "--hidden", "styled")
        self.assertIn("hidden-1", styled.ids())

    def test_subdivision(self):
        counts = []
        for level in (0, 1, 2):
            outcome = self.croquis("lines", CUBE, "--subdivide", str(level), "--timings", "-o", "a.svg")
            counts.append(json.loads(outcome.errors)["triangles"])
        self.assertEqual(counts, [12, 48, 192])

    def test_timings(self):
        outcome = self.croquis("lines", TEAPOT, "--timings", "--repeat", "3", "-o", "a.svg")
        self.assertEqual((outcome.status, outcome.errors.count("\n")), (0, 1))
        found = json.loads(outcome.errors)
        times = ["load", "adjacency", "prepare", "find", "visibility", "chain", "write"]
        counts = ["lines", "points", "silhouette_edges", "clusters", "triangles"]
        self.assertEqual(list(found), times + counts)
        self.assertTrue(all(found[name] >= 0 for name in times))
        self.assertTrue(all(isinstance(found[name], int) and found[name] > 0 for name in counts))
        paths = self.json(TEAPOT)["paths"]
        self.assertEqual((found["lines"], found["points"]), (len(paths), sum(len(path["points"]) for path in paths)))


if __name__ == "__main__":
    program.main()
