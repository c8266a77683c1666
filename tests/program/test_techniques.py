"""Every technique draws: on both back ends alike, the same bytes each time, on every kind of model."""

import re
import shutil

import png
import program
from program import ASSIMP, MODELS, SMALL

# Models that differ in what they bring along. A name ends in what is copied beside it.
KINDS_OF_MODEL = {
    "no material": MODELS / "cube.obj",
    "two materials": MODELS / "two_material_cube.obj",
    "several meshes": ASSIMP / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
    "vertex colours": ASSIMP / "OBJ/cube_with_vertexcolors.obj",
    "vertex colours, no normals": ASSIMP / "PLY/float-color.ply",
    "texture inside": ASSIMP / "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf",
}
BESIDE = [MODELS / "two_material_cube.mtl"]
FAERIE = (ASSIMP / "MD2/faerie.md2", "--texture", ASSIMP / "MD2/faerie2.bmp")

LEAST_DRAWN = 0.002  # of the picture: thin lines alone cover little


class Techniques(program.ProgramTest):
    def test_same_picture_each_time_and_on_both_back_ends(self):
        """The same bytes with one and with two threads; on OpenGL ES a mean difference below 1."""
        for name in program.technique_names():
            with self.subTest(technique=name):
                draw = ("render", "-t", name, *SMALL)
                self.said(*draw, "--gl", "gl", "-o", "one.png", environment={"LP_NUM_THREADS": "1"})
                self.said(*draw, "--gl", "gl", "-o", "two.png", environment={"LP_NUM_THREADS": "2"})
                one, two = (self.folder / "one.png").read_bytes(), (self.folder / "two.png").read_bytes()
                self.assertEqual(one, two)
                self.assertGreater(png.decode(one).share_drawn(), LEAST_DRAWN)
                self.said(*draw, "--gl", "gles", "--reference", "one.png", "--threshold", "0.999")

    def test_every_kind_of_model(self):
        models = self.folder / "models"
        models.mkdir()
        for path in [*KINDS_OF_MODEL.values(), *BESIDE]:
            shutil.copy(path, models)
        for name in program.technique_names():
            with self.subTest(technique=name):
                pictures = self.folder / name
                pictures.mkdir()
                self.said("render", "--input-dir", models, "-t", name, *SMALL, "-o", pictures)
                for path in KINDS_OF_MODEL.values():
                    with self.subTest(technique=name, model=path.name):
                        self.assertGreater(png.read(pictures / f"{path.stem}.png").share_drawn(), LEAST_DRAWN)

    def test_animated_and_textured_model(self):
        for name in program.technique_names():
            with self.subTest(technique=name):
                draw = (*FAERIE, "--view", "right", "-t", name, *SMALL, "--animation", "run", "--time")
                early, late = (self.drawn(*draw, time) for time in ("0", "0.25"))
                self.assertGreater(early.share_drawn(), LEAST_DRAWN)
                self.assertNotEqual(early.rows, late.rows)

    def test_texture_is_seen(self):
        shutil.copy(FAERIE[0], self.folder / "faerie.md2")
        textured = self.drawn("faerie.md2", *FAERIE[1:], *SMALL, "-t", "base")
        self.assertGreater(len(set(textured.pixels)), 50)
        bare = self.croquis("render", "faerie.md2", *SMALL, "-t", "base", "-o", "bare.png")
        self.assertEqual(bare.status, 0)
        self.assertLess(len(set(png.read(self.folder / "bare.png").pixels)), 10)

    def test_unknown_animation(self):
        message = re.compile(re.escape(f'{FAERIE[0]}: no animation clip "rum"; it has stand, run, ') + '.*; did you mean "run"\\?')
        self.refused(message, "render", *FAERIE, "--animation", "rum", "-o", "out.png")


if __name__ == "__main__":
    program.main()
