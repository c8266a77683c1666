"""What each option of `croquis render` does, seen in the pixels."""

import program
import png
from program import MODELS, OWN_DATA, SMALL

COMPASS = OWN_DATA / "compass.obj"
TWO_BOXES = OWN_DATA / "two_boxes.obj"
SPHERE = MODELS / "sphere.obj"
FLAT = ("-t", "base", *SMALL)

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
CYAN, MAGENTA, YELLOW, WHITE = (0, 255, 255), (255, 0, 255), (255, 255, 0), (255, 255, 255)

# The face that stands in the middle of each view of compass.obj; the last are cut by one camera at one place.
VIEWS = [
    (["--view", "front"], RED),
    (["--view", "back"], CYAN),
    (["--view", "left"], GREEN),
    (["--view", "right"], MAGENTA),
    (["--view", "top"], BLUE),
    (["--view", "bottom"], YELLOW),
    (["--view", "0,0,-2"], CYAN),
    (["--view", "0.1, 0.1, 5"], RED),
    (["--eye", "7,0,0"], MAGENTA),
    (["--eye", "0,-7,0"], YELLOW),
    (["--eye", "0,0,7", "--target", "5,0,0"], WHITE),
]

BACKGROUNDS = [
    ("white", (255, 255, 255)),
    ("black", (0, 0, 0)),
    ("red", (255, 0, 0)),
    ("0.2,0.4,1", (51, 102, 255)),
    ("#336699", (51, 102, 153)),
    ("#36F", (51, 102, 255)),
]

# Light, view, and the half of the sphere that it falls on.
LIGHTS = [
    ("1,0,0", "front", "right"),
    ("1,0,0", "back", "left"),
    ("world:-1,0,0", "front", "left"),
    ("viewer:1,0,0", "front", "right"),
    ("viewer:1,0,0", "back", "right"),
    ("viewer:0,1,0", "right", "top"),
    ("0,-1,0", "front", "bottom"),
    ("point:50,0,0", "front", "right"),
    ("point:50,0,0", "back", "left"),
]


def halves(picture):
    """How bright each half of a picture is."""
    width, height = picture.width, picture.height
    parts = {
        "left": (0, 0, width // 2, height),
        "right": (width // 2, 0, width, height),
        "top": (0, 0, width, height // 2),
        "bottom": (0, height // 2, width, height),
    }
    return {name: sum(picture.crop(*part).mean()) for name, part in parts.items()}


OPPOSITE = {"left": "right", "right": "left", "top": "bottom", "bottom": "top"}


def is_red(pixel):
    return pixel == RED


def is_green(pixel):
    return pixel == GREEN


class Views(program.ProgramTest):
    def test_view_shows_its_side(self):
        for arguments, color in VIEWS:
            with self.subTest(arguments=arguments):
                self.assertEqual(self.drawn(COMPASS, *FLAT, *arguments).centre, color)

    def test_iso_shows_three_sides(self):
        colors = set(self.drawn(COMPASS, *FLAT, "--view", "iso").pixels)
        self.assertTrue({RED, MAGENTA, BLUE} <= colors)
        self.assertFalse({CYAN, GREEN, YELLOW} & colors)

    def test_front_view_has_x_to_the_right_and_y_up(self):
        red, green = self.boxes("--view", "front")
        self.assertLess(red[2], green[0])

    def test_up_turns_the_picture(self):
        red, green = self.boxes("--view", "front", "--up", "1,0,0")
        self.assertLess(green[3], red[1])

    def test_parallel_keeps_sizes_and_perspective_does_not(self):
        for projection, is_kept in (("parallel", True), ("perspective", False)):
            with self.subTest(projection=projection):
                red, green = self.boxes("--view", "front", "--projection", projection)
                heights = [box[3] - box[1] for box in (red, green)]
                if is_kept:
                    self.assertLessEqual(abs(heights[0] - heights[1]), 1)
                else:
                    self.assertGreater(heights[0], heights[1] * 1.1)

    def boxes(self, *arguments):
        """The rectangles of two_boxes.obj's red and green box."""
        picture = self.drawn(TWO_BOXES, *FLAT, *arguments)
        return picture.box(is_red), picture.box(is_green)

    def test_fit_is_the_share_of_the_frame(self):
        for fit in (1.0, 0.5, 0.25):
            with self.subTest(fit=fit):
                picture = self.drawn(COMPASS, "-t", "base", "--size", "200x100", "--view", "front", "--fit", fit,
                                     "--projection", "parallel")
                left, top, right, bottom = picture.box(is_red)
                self.assertAlmostEqual(bottom + 1 - top, 100 * fit, delta=1)
                self.assertAlmostEqual(right + 1 - left, 100 * fit, delta=1)

    def test_field_of_view(self):
        """A face of height 2 at distance 4 fills 1 / (4 tan(fov / 2)) of the frame's height."""
        for degrees, share in ((90, 0.25), (53.130102, 0.5)):
            with self.subTest(degrees=degrees):
                picture = self.drawn(COMPASS, "-t", "base", "--size", "100x100", "--eye", "0,0,5", "--fov", degrees)
                _, top, _, bottom = picture.box(is_red)
                self.assertAlmostEqual(bottom + 1 - top, 100 * share, delta=1)


class Pixels(program.ProgramTest):
    def test_size(self):
        for size in ((1, 1), (37, 91), (640, 3)):
            with self.subTest(size=size):
                picture = self.drawn(COMPASS, "-t", "base", "--size", f"{size[0]}x{size[1]}")
                self.assertEqual((picture.width, picture.height), size)
        picture = self.drawn(COMPASS, "-t", "base")
        self.assertEqual((picture.width, picture.height), (1024, 768))

    def test_samples_smooth_the_borders_alone(self):
        one, four = (self.drawn(COMPASS, *FLAT, "--samples", n) for n in (1, 4))
        self.assertEqual((four.width, four.height), (one.width, one.height))
        self.assertEqual(len(set(one.pixels)), 4)
        self.assertGreater(len(set(four.pixels)), 4)
        differing = sum(a != b for a, b in zip(one.pixels, four.pixels)) / len(one.pixels)
        self.assertLess(differing, 0.05)
        self.assertEqual(one.centre, four.centre)

    def test_background_colors(self):
        for text, color in BACKGROUNDS:
            with self.subTest(background=text):
                picture = self.drawn(COMPASS, *FLAT, "--view", "top", "--background", text)
                self.assertEqual((picture.corner, picture.centre), (color, BLUE))

    def test_transparent_background_has_alpha(self):
        picture = self.drawn(COMPASS, *FLAT, "--view", "top", "--background", "transparent", "--samples", "4")
        self.assertEqual(picture.corner[3], 0)
        self.assertEqual(picture.centre, (*BLUE, 255))
        halfway = [pixel for pixel in picture.pixels if 0 < pixel[3] < 255]
        self.assertTrue(all(max(abs(a - b) for a, b in zip(pixel, BLUE)) <= 2 for pixel in halfway), halfway[:3])

    def test_opaque_picture_has_no_alpha(self):
        self.assertEqual(len(self.drawn(COMPASS, *FLAT).corner), 3)

    def test_image_is_tiled_from_the_upper_left(self):
        """A picture of the program's own as paper: the same pixels again and again."""
        (self.folder / "own/textures/own").mkdir(parents=True)
        self.said("render", COMPASS, "-t", "base", "--size", "37x23", "-o", "own/textures/own/paper.png")
        paper = png.read(self.folder / "own/textures/own/paper.png")
        picture = self.drawn(COMPASS, "-t", "base", "--size", "160x120", "--data", "own", "--background", "own:paper:0",
                             "--set", "surfaces.render=false")
        expected = [[paper.at(x % 37, y % 23) for x in range(160)] for y in range(120)]
        self.assertEqual(picture.rows, expected)

    def test_shipped_paper(self):
        picture = self.drawn(COMPASS, *FLAT, "--view", "top", "--background", "paper:plain")
        self.assertEqual(picture.centre, BLUE)
        self.assertGreater(min(picture.corner), 200)
        self.assertGreater(len(set(picture.rows[0])), 3)

    def test_settings(self):
        picture = self.drawn(COMPASS, *FLAT, "--set", "surfaces.clear_color=0 1 1")
        self.assertEqual(picture.corner, CYAN)
        several = self.drawn(COMPASS, *FLAT, "--set", "surfaces.clear_color=0 1 1", "--set", "surfaces.render=false")
        self.assertEqual(several.share_drawn(), 0)

    def test_lights(self):
        for light, view, bright in LIGHTS:
            with self.subTest(light=light, view=view):
                picture = self.drawn(SPHERE, "-t", "phong", *SMALL, "--background", "black", "--view", view, "--light", light)
                found = halves(picture)
                self.assertGreater(found[bright], 1.5 * found[OPPOSITE[bright]])

    def test_light_color(self):
        white, red = (self.drawn(SPHERE, "-t", "phong", *SMALL, "--background", "black", "--light-color", color).mean()
                      for color in ("white", "red"))
        self.assertAlmostEqual(white[0], red[0], delta=1)
        self.assertLess(red[1], white[1] / 2)
        self.assertLess(red[2], white[2] / 2)

    def test_list_passes(self):
        lines = self.said("render", COMPASS, *SMALL, "-t", "cartoon", "--list-passes").splitlines()
        self.assertEqual([line.split(" ms  ")[1] for line in lines], ["surfaces", "attributes", "edges", "tagged_lines", "all passes"])
        times = [float(line.split(" ms")[0]) for line in lines]
        self.assertAlmostEqual(sum(times[:-1]), times[-1], delta=0.01)
        self.assertEqual(self.files(), set())


if __name__ == "__main__":
    program.main()
