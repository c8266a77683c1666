"""croquis bench: what its table, its JSON and its plot say of one another, and `render --simplify`."""

import json
import re
import subprocess

import png
import program
from program import MODELS

SPHERE = MODELS / "sphere.obj"
QUICK = ("--size", "96x80", "--frames", "11", "--seconds", "0.05")

# Command lines that must be refused before anything is measured.
WRONG = [
    (["-t", "cartoom"], 'unknown technique "cartoom"; did you mean "cartoon"?'),
    (["-t", ","], '--techniques: expected names, found ","'),
    (["--levels", "0"], "expected 1 to 20 levels of detail, found 0"),
    (["--levels", "21"], "expected 1 to 20 levels of detail, found 21"),
    (["--frames", "0"], "expected 1 to 10000000 frames to measure, found 0"),
    (["--frames", "10000001"], "expected 1 to 10000000 frames to measure, found 10000001"),
    (["--frames", "99999999999"], "expected 1 to 10000000 frames to measure, found 99999999999"),
    (["--seconds", "0"], "expected more than 0 seconds to measure, found 0"),
    (["--coverage", "0"], "expected the model to cover more than 0 and at most 100 percent, found 0"),
    (["--triangles", "100,x"], '--triangles: expected whole numbers of 1 to 4294967295, found "100,x"'),
    (["--triangles", "100,0"], '--triangles: expected whole numbers of 1 to 4294967295, found "100,0"'),
    (["--triangles", "4294967296"], '--triangles: expected whole numbers of 1 to 4294967295, found "4294967296"'),
    (["--triangles", "9999"], "expected a model of at least 9999 triangles, found 5120"),
    (["--size", "0x5"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "0x5"'),
    (["--view", "0,0,0"], "expected the view to have a direction, found 0,0,0"),
    (["--plot", "plot.gif"], '--plot: expected a file that ends in .svg or .png, found "plot.gif"'),
    (["--json", "missing/out.json"], "missing/out.json: folder missing does not exist"),
    (["--plot", "missing/out.svg"], "missing/out.svg: folder missing does not exist"),
    (["--json", "{folder}"], "{folder}: expected a file name, found a folder"),
    (["--json", "/proc/out.json"], re.compile(r"/proc/out\.json: cannot write: .+")),
    (["--orientation", "--json", "-"], "--orientation compares no techniques: it does not go with --json"),
    (["--orientation", "--plot", "a.svg"], "--orientation compares no techniques: it does not go with --plot"),
    (["--orientation", "-t", "comic"], "--orientation compares no techniques: it does not go with --techniques"),
]


def rows(table):
    """The lines of techniques: {name: words}, of the first block."""
    lines = table.split("\n\n")[1].splitlines()[2:]
    return {line.split()[0]: line.split()[1:] for line in lines if not line.startswith("    ")}


class Bench(program.ProgramTest):
    def measured(self, *arguments):
        """The JSON of a run."""
        return json.loads(self.said("bench", SPHERE, *QUICK, *arguments, "--json", "-"))

    def test_json(self):
        result = self.measured("--techniques", "base,cartoon", "--levels", "3")
        self.assertEqual(list(result), ["machine", "size", "model", "techniques", "levels"])
        self.assertEqual(list(result["machine"]), ["renderer", "version", "api", "software"])
        self.assertEqual((result["size"], result["model"]), ("96x80", "sphere.obj"))
        self.assertEqual(result["techniques"], result["levels"][0]["techniques"])
        for number, level in enumerate(result["levels"]):
            self.assertAlmostEqual(level["triangles"] * 2**number / 5120, 1, delta=0.03)
            self.assertAlmostEqual(level["coverage"], 15, delta=0.13 * 15)
            self.assertEqual([one["technique"] for one in level["techniques"]], ["phong", "base", "cartoon"])
            for one in level["techniques"]:
                self.assertEqual(list(one), ["technique", "ms", "fps", "ratio", "frames"])
                self.assertAlmostEqual(one["fps"] * one["ms"], 1000)
                self.assertAlmostEqual(one["ratio"], one["ms"] / level["techniques"][0]["ms"])

    def test_table_and_files_agree(self):
        table = self.said("bench", SPHERE, *QUICK, "-t", "base", "--passes", "--stability", "--json", "out.json")
        self.assertEqual(self.files(), {"out.json"})
        result = json.loads((self.folder / "out.json").read_text())
        self.assertIn("5120 triangles, ", table)
        shown = rows(table)
        self.assertEqual(list(shown), ["phong", "base"])
        for one in result["techniques"]:
            self.assertEqual(shown[one["technique"]][0], f"{one['ms']:.3f}")
            self.assertEqual(shown[one["technique"]][2], f"{one['ratio']:.2f}")
            self.assertEqual([each["pass"] for each in one["passes"]], ["surfaces"])
        stability = result["stability"]
        self.assertEqual([list(one) for one in stability], [["technique", "change", "ratio", "pops"]] * 2)
        self.assertEqual((stability[0]["ratio"], stability[0]["pops"]), (1, 0))

    def test_plots(self):
        self.said("bench", SPHERE, *QUICK, "-t", "base", "--levels", "2", "--plot", "plot.svg")
        self.said("bench", SPHERE, *QUICK, "-t", "base", "--plot", "plot.png")
        subprocess.run(["xmllint", "--noout", self.folder / "plot.svg"], check=True)
        picture = png.decode((self.folder / "plot.png").read_bytes())
        self.assertEqual((picture.width, picture.height), (960, 640))

    def test_built_in_model_and_own_technique(self):
        own = self.write("own.technique", 'include "base" ;\n')
        result = json.loads(self.said("bench", *QUICK, "-t", own, "--triangles", "900,300", "--json", "-"))
        self.assertEqual(result["model"], "teapot.obj")
        self.assertEqual([one["technique"] for one in result["techniques"]], ["phong", "own"])
        for level, wanted in zip(result["levels"], (900, 300)):
            self.assertAlmostEqual(level["triangles"] / wanted, 1, delta=0.03)

    def test_mistakes(self):
        for arguments, message in WRONG:
            self.refused(message, "bench", SPHERE, *map(self.placed, arguments))

    def test_orientation(self):
        """Ways with and without holes, of the model in fewer triangles."""
        table = self.said("bench", SPHERE, "--orientation", "--triangles", "320")
        self.assertRegex(table, r"\A3[12]\d triangles, means over \d+ views\n")
        self.assertEqual(len(table.splitlines()), 10)

    def test_coverage_that_cannot_be(self):
        outcome = self.croquis("bench", SPHERE, "--size", "300x60", *QUICK[2:], "-t", "phong", "--coverage", "90")
        self.assertEqual(outcome.status, 0)
        found = re.fullmatch(
            r"croquis: warning: the model covers ([\d.]+) percent of the pixels, not 90: it cannot be seen otherwise "
            r"from outside its box\n", outcome.errors)
        self.assertLess(float(found[1]), 45)


class Simplify(program.ProgramTest):
    @staticmethod
    def tones(picture):
        return len({picture.at(x, y) for x in range(picture.width) for y in range(picture.height)})

    def test_outline_stays_and_faces_show(self):
        """A coarse sphere covers what the fine one does; drawn flat, it has far fewer tones."""
        view = ("-t", "flat", "--size", "200x160")
        fine, coarse = self.drawn(SPHERE, *view), self.drawn(SPHERE, *view, "--simplify", "320")
        self.assertAlmostEqual(coarse.share_drawn() / fine.share_drawn(), 1, delta=0.06)
        self.assertLess(self.tones(coarse), 0.6 * self.tones(fine))

    def test_the_smooth_surface_is_simplified(self):
        """Not the other way round: that would draw sixteen times as many triangles."""
        self.said("render", MODELS / "cube.obj", *program.SMALL, "--subdivide", "2", "--simplify", "192", "-o", "a.png")
        self.said("render", MODELS / "cube.obj", *program.SMALL, "--subdivide", "2", "--reference", "a.png",
                  "--threshold", "0,0")
        coarse = ("-t", "flat", *program.SMALL, "--subdivide", "2", "--simplify", "48")
        self.assertLess(self.tones(self.drawn(MODELS / "cube.obj", *coarse)),
                        0.6 * self.tones(self.drawn(MODELS / "cube.obj", *coarse[:-2])))

    def test_no_triangles(self):
        self.refused("expected at least 1 triangle to simplify to, found 0", "render", SPHERE, "--simplify", "0")

    def test_models_that_are_small_enough_stay(self):
        self.said("render", MODELS / "cube.obj", *program.SMALL, "-o", "cube.png")
        self.said("render", MODELS / "cube.obj", *program.SMALL, "--simplify", "500", "--reference", "cube.png",
                  "--threshold", "0,0")


if __name__ == "__main__":
    program.main()
