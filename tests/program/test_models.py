"""Models sound and broken: each is drawn, or refused with one line; none crashes or hangs."""

import random
import re

import png
import program
from program import ASSIMP, MODELS, SOUND_MODELS

ENDINGS = ".obj .md2 .wrl .off .ase .ply .stl .gltf .glb .3ds"
TINY = ("--size", "64x48", "-t", "phong")
INVALID = ASSIMP / "invalid"


def unknown_ending(ending, guess=""):
    """What is said to a file that is no model."""
    return f"expected a model file ({ENDINGS}), found ending {ending}{guess}"


# Every file of assimp-testmodels/invalid; None for what has some sound triangles and is drawn.
INVALID_FILES = {
    "OutOfMemory.off": "expected room for 353535235358 vertices, found a file of 309 bytes",
    "empty.3ds": "expected a model, found an empty file",
    "empty.ase": "expected a model, found an empty file",
    "empty.lwo": unknown_ending(".lwo"),
    "empty.md5mesh": unknown_ending(".md5mesh"),
    "empty.obj": "expected triangles, found none",
    "empty.off": "expected a model, found an empty file",
    "empty.ply": re.compile("expected .*"),
    "empty.raw": unknown_ending(".raw"),
    "empty.smd": unknown_ending(".smd", '; did you mean ".md2"?'),
    "empty.x": unknown_ending(".x"),
    "emptyIrrMesh.xml": unknown_ending(".xml", '; did you mean ".wrl"?'),
    "malformed.obj": None,
    "malformed2.obj": None,
    "readme.txt": unknown_ending(".txt"),
}

# Other broken models of that package, from ASSIMP.
BROKEN_MODELS = {
    "OFF/invalid.off": "expected triangles, found 2 of no area",
    "OBJ/testline.obj": "expected triangles, found only lines and points",
    "OBJ/testpoints.obj": "expected triangles, found only lines and points",
    "PLY/points.ply": "expected triangles, found only lines and points",
    "glTF2/RecursiveNodes/RecursiveNodes.gltf": "expected nodes at most 200 deep, found node 0 deeper or in a circle",
    "glTF2/MissingBin/BoxTextured.gltf": re.compile('expected a sound gltf file, found: .*"BoxTextured0.bin"'),
    "glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf": re.compile("expected a sound gltf file, found: .*"),
}

# Folders whose files must each be drawn or refused.
FOLDERS = ["OBJ", "MD2", "OFF", "ASE", "PLY", "STL", "3DS", "WRL"]


def at(path, message):
    """The message, named after its file."""
    if isinstance(message, re.Pattern):
        return re.compile(re.escape(f"{path}:") + r"(?:\d+:)* " + message.pattern)
    return f"{path}: {message}"


def damaged(data, seed):
    """Broken versions of a file's bytes, by name."""
    dice = random.Random(seed)
    flipped = bytearray(data)
    for _ in range(20):
        flipped[dice.randrange(len(data))] = dice.randrange(256)
    return {
        "one_byte": data[:1],
        "half": data[: len(data) // 2],
        "all_but_one": data[:-1],
        "random": dice.randbytes(5000),
        "random_after_head": data[:200] + dice.randbytes(5000),
        "flipped": bytes(flipped),
        "zeros": bytes(5000),
    }


# Ways of damage that leave nothing to draw, whatever the format.
HOPELESS = {"one_byte", "random", "zeros"}


class Models(program.ProgramTest):
    def assert_drawn_or_refused(self, path, way=""):
        """Returns whether it was drawn."""
        outcome = self.croquis("render", path, *TINY, "-o", "out.png")
        if outcome.status != 0:
            self.assert_refused(outcome, at(path, re.compile(".+")))
            self.assertNotIn("out.png", self.files())
            return False
        self.assertRegex(outcome.errors, r"\A(croquis: warning: [^\n]+\n)*\Z")
        picture = png.read(self.folder / "out.png")
        (self.folder / "out.png").unlink()
        self.assertEqual((picture.width, picture.height), (64, 48))
        self.assertNotIn(way, HOPELESS, "a picture of nothing")
        return True

    def test_every_invalid_file(self):
        self.assertEqual({path.name for path in INVALID.iterdir()}, INVALID_FILES.keys())
        for name, message in INVALID_FILES.items():
            if message is None:
                with self.subTest(model=name):
                    self.assertTrue(self.assert_drawn_or_refused(INVALID / name))
            else:
                self.refused(at(INVALID / name, message), "render", INVALID / name, "-o", "out.png")

    def test_broken_models(self):
        for name, message in BROKEN_MODELS.items():
            self.refused(at(ASSIMP / name, message), "render", ASSIMP / name, "-o", "out.png")

    def test_damaged_versions_of_each_format(self):
        for ending, sound in SOUND_MODELS.items():
            data = sound.read_bytes()
            for seed in (1, 2):
                for way, content in damaged(data, seed).items():
                    if seed > 1 and way not in ("random_after_head", "flipped"):
                        continue
                    with self.subTest(ending=ending, way=way, seed=seed):
                        path = self.write(f"{way}{ending}", content)
                        self.assert_drawn_or_refused(path, way)
                        path.unlink()

    def test_sound_model_of_each_format(self):
        for ending, sound in SOUND_MODELS.items():
            with self.subTest(ending=ending):
                picture = self.drawn(sound, *TINY)
                self.assertGreater(picture.share_drawn(), 0.05)

    def test_whole_folders(self):
        """Each file of a folder is drawn, or named on a line of its own, with a sum at the end."""
        for name in FOLDERS:
            with self.subTest(folder=name):
                outcome = self.croquis("render", "--input-dir", ASSIMP / name, *TINY, "-o", ".")
                lines = [line for line in outcome.errors.splitlines() if not line.startswith("croquis: warning: ")]
                refused = [line for line in lines if line.startswith(f"croquis: {ASSIMP / name}")]
                models = [path for path in (ASSIMP / name).iterdir() if path.suffix.lower() in SOUND_MODELS]
                self.assertEqual(len(self.files()), len(models) - len(refused))
                total = [f"croquis: {len(refused)} of {len(models)} models could not be drawn"] if refused else []
                self.assertEqual(lines, refused + total)
                self.assertEqual(outcome.status, 2 if refused else 0)
                for path in self.folder.iterdir():
                    path.unlink()

    def test_every_gltf(self):
        for path in sorted((ASSIMP / "glTF2").rglob("*.gl*")):
            if path.suffix in SOUND_MODELS:
                with self.subTest(model=path.name):
                    self.assert_drawn_or_refused(path)

    def test_hostile_names_and_numbers(self):
        for name, text, message in [
            ("nothing.obj", "", "expected triangles, found none"),
            ("outside.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", None),
            ("huge.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n", None),
            ("flat.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", None),
            ("long_line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + " 1 2 3" * 200_000 + "\n", None),
            ("escape.obj", "v \x1b[31m 0 0\n", re.compile(r'expected a number, found "\\x1b\[31m"')),
            ("many.off", "OFF\n2000000000 2000000000 0\n", re.compile("expected .*")),
            ("many.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n", re.compile("expected .*")),
            ("climbing.obj", "mtllib ../../../../../etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", None),
        ]:
            with self.subTest(model=name):
                path = self.write(name, text)
                if message is None:
                    self.assert_drawn_or_refused(path)
                else:
                    self.refused(at(path, message), "render", path, "-o", "out.png")

    def test_folder_with_good_and_bad(self):
        for name, text in {
            "good.obj": (MODELS / "cube.obj").read_bytes(),
            "bad.obj": b"",
            "same.obj": (MODELS / "cube.obj").read_bytes(),
            "same.stl": SOUND_MODELS[".stl"].read_bytes(),
            "notes.txt": b"no model",
        }.items():
            self.write(f"models/{name}", text)
        (self.folder / "pictures").mkdir()
        outcome = self.croquis("render", "--input-dir", "models", *TINY, "-o", "pictures")
        self.assertEqual((outcome.status, outcome.output), (2, b""))
        self.assertEqual(
            outcome.errors.splitlines(),
            ["croquis: models/bad.obj: expected triangles, found none", "croquis: 1 of 4 models could not be drawn"],
        )
        pictures = {path.name for path in (self.folder / "pictures").iterdir()}
        self.assertEqual(pictures, {"good.png", "same.obj.png", "same.stl.png"})


if __name__ == "__main__":
    program.main()
