"""Models of odd size, place and sense draw as the plain ones do."""

import program
from program import MODELS, SMALL

FLAT = (*SMALL, "--view", "1,0.7,1")


def moved(scale=1, offset=(0, 0, 0)):
    """The text of cube.obj with its points scaled and then moved."""
    lines = []
    for line in (MODELS / "cube.obj").read_text().splitlines():
        if line.startswith("v "):
            point = [float(word) * scale + shift for word, shift in zip(line.split()[1:4], offset)]
            line = "v " + " ".join(map(repr, point))
        lines.append(line)
    return "\n".join(lines) + "\n"


def inverted():
    """cube.obj with every face turned inside out."""
    lines = (MODELS / "cube.obj").read_text().splitlines()
    return "\n".join("f " + " ".join(reversed(line.split()[1:])) if line.startswith("f ") else line for line in lines) + "\n"


# Models that must look like cube.obj, and how far a picture may lie from its own.
LIKE_THE_CUBE = {
    "large.obj": (moved(1e6), "0.05"),
    "small.obj": (moved(1e-6), "0.05"),
    "far.obj": (moved(1, (1e7, -1e7, 1e7)), "0.05"),
    "large_and_far.obj": (moved(1e6, (1e7, 0, 0)), "0.05"),
    "inverted.obj": (inverted(), "0.05"),
    "byte_order_mark.obj": ("\ufeff" + moved(), "0.05"),
    "carriage_returns.obj": (moved().replace("\n", "\r\n"), "0.05"),
}
TECHNIQUES = ["phong", "base", "cartoon", "edges", "wireframe"]


class Geometry(program.ProgramTest):
    def test_like_the_cube(self):
        for name, (text, _) in LIKE_THE_CUBE.items():
            self.write(name, text)
        for technique in TECHNIQUES:
            self.said("render", MODELS / "cube.obj", *FLAT, "-t", technique, "-o", "cube.png")
            for name, (_, threshold) in LIKE_THE_CUBE.items():
                with self.subTest(model=name, technique=technique):
                    self.said("render", name, *FLAT, "-t", technique, "--reference", "cube.png", "--threshold", threshold)

    def test_eye_is_in_the_files_coordinates(self):
        self.write("far.obj", moved(1, (1e7, 0, 0)))
        self.said("render", MODELS / "cube.obj", *SMALL, "--eye", "3,4,5", "-o", "cube.png")
        self.said("render", "far.obj", *SMALL, "--eye", "10000003,4,5", "--reference", "cube.png", "--threshold", "0.05")

    def test_flat_and_tiny_models(self):
        """A single triangle, seen from in front, from behind and along its plane."""
        self.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        for view, is_seen in (("front", True), ("back", True), ("right", False)):
            with self.subTest(view=view):
                share = self.drawn("triangle.obj", *SMALL, "-t", "base", "--view", view).share_drawn()
                self.assertEqual(share > 0.1, is_seen)

    def test_lines_and_points_alone_are_refused(self):
        for name, text in {
            "lines.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n",
            "points.obj": "v 0 0 0\nv 1 0 0\np 1 2\n",
            "vertices.obj": "v 0 0 0\nv 1 0 0\n",
        }.items():
            self.write(name, text)
            self.refused(f"{name}: expected triangles, found only lines and points", "render", name, "-o", "out.png")

    def test_lines_beside_triangles_are_left_out(self):
        triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.write("triangle.obj", triangle)
        self.write("mixed.obj", triangle + "v 0.2 0.2 0\nl 1 4\np 3\n")  # a line along no edge
        self.said("render", "triangle.obj", *SMALL, "-o", "triangle.png")
        self.said("render", "mixed.obj", *SMALL, "--reference", "triangle.png", "--threshold", "0")

    def test_tagged_edges_are_drawn(self):
        """A line along the diagonal of a flat square shows in a cartoon, which has no other reason to draw it."""
        square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n"
        for name, text, is_drawn in (("plain.obj", square, False), ("tagged.obj", square + "l 1 3\n", True)):
            self.write(name, text)
            picture = self.drawn(name, "--size", "200x200", "--view", "front", "-t", "cartoon")
            dark = [max(picture.at(x, 199 - x)[:3]) < 60 for x in range(60, 140)]
            with self.subTest(model=name):
                self.assertEqual(all(dark), is_drawn)
                self.assertEqual(any(dark), is_drawn)


if __name__ == "__main__":
    program.main()
