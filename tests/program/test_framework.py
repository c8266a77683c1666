"""Techniques, components and shaders of a user's own: files of the working folder and data folders."""

import program
from program import DATA, MODELS, OWN_DATA, SMALL

CUBE = MODELS / "cube.obj"
SEED_C = OWN_DATA / "seed_c"  # programs 2.1, 2.2, 2.3 and 2.7 of the source text
BLUE_SHADER = "#ifdef FRAGMENT_STAGE\nvec4 blue() { return vec4(0.0, 0.0, 1.0, 1.0); }\n#endif\n"


class OwnTechniques(program.ProgramTest):
    def test_file_with_an_include_beside_it(self):
        self.write("styles/own.technique", 'include "shared" ;\nmodify surfaces { clear_color 1 0 0 ; } ;\n')
        self.write("styles/shared.technique", "pass render_base surfaces {} ;\n")
        picture = self.drawn(CUBE, *SMALL, "-t", "styles/own.technique")
        self.assertEqual(picture.corner, (255, 0, 0))
        self.assertNotEqual(picture.centre, picture.corner)

    def test_file_that_includes_a_shipped_technique(self):
        self.write("own.technique", 'pass render_base surfaces { clear_color 1 1 1 ; } ;\ninclude "ink_lines" ;\n')
        self.assertIn((0, 0, 0), self.drawn(CUBE, *SMALL, "-t", "own.technique").pixels)

    def test_include_beside_goes_before_the_shipped_one(self):
        self.write("own.technique", 'include "phong" ;\n')
        self.write("phong.technique", "pass render_base surfaces { clear_color 0 1 0 ; } ;\n")
        self.assertEqual(self.drawn(CUBE, *SMALL, "-t", "own.technique").corner, (0, 255, 0))

    def test_objects_are_chosen_by_material(self):
        """One scene, two styles: what one pass leaves out the next draws."""
        model = OWN_DATA / "two_boxes.obj"
        self.write("own.technique", 'pass render_base one { clear_color 1 1 1 ; objects "red" ; } ;\n'
                                    'pass render_base two { objects "green" ; keep_color 1 ; keep_depth 1 ; } ;\n')
        only_red = self.drawn(model, *SMALL, "-t", "own.technique", "--set", "two.render=false")
        self.assertEqual(set(only_red.pixels), {(255, 255, 255), (255, 0, 0)})
        both = self.drawn(model, *SMALL, "-t", "own.technique")
        self.assertEqual(both.rows, self.drawn(model, *SMALL, "-t", "base").rows)


class OwnData(program.ProgramTest):
    def test_folder_overrides_a_component(self):
        text = (DATA / "components/surface.component").read_text()
        start = text.index("component render_phong")
        phong = text[start : text.index("component", start + 1)]
        own = phong.rsplit("} ;", 1)[0] + "    modify clear_color { default 0 1 0 ; } ;\n} ;\n"
        self.write("own/components/phong.component", own)
        self.assertEqual(self.drawn(CUBE, *SMALL, "-t", "phong").corner, (128, 128, 128))
        self.assertEqual(self.drawn(CUBE, *SMALL, "-t", "phong", "--data", "own").corner, (0, 255, 0))

    def test_first_folder_wins(self):
        for name, color in (("one", "1 0 0"), ("two", "0 1 0")):
            self.write(f"{name}/techniques/own.technique", f"pass render_base x {{ clear_color {color} ; }} ;\n")
        for order, color in ((("one", "two"), (255, 0, 0)), (("two", "one"), (0, 255, 0))):
            folders = [word for name in order for word in ("--data", name)]
            self.assertEqual(self.drawn(CUBE, *SMALL, *folders, "-t", "own").corner, color)

    def test_own_shader(self):
        self.write("own/shaders/own.glsl", BLUE_SHADER)
        self.write("own/techniques/own.technique",
                   'pass simple_render x { vertex_program "default:default_transform" ; fragment_program "own:blue" ; } ;\n')
        for api in ("gl", "gles"):
            picture = self.drawn(CUBE, *SMALL, "--data", "own", "-t", "own", "--gl", api)
            self.assertEqual((picture.centre, picture.corner), ((0, 0, 255), (128, 128, 128)))

    def test_broken_technique_does_not_hide_the_others(self):
        self.write("own/techniques/broken.technique", "pass render_fong x {} ;\n")
        listing = self.said("list", "--data", "own")
        self.assertIn("(broken: own/techniques/broken.technique:1:6: unknown component \"render_fong\"", listing)
        self.assertIn("\n  wireframe ", listing)


class SourceText(program.ProgramTest):
    """Seed C's listings as written (row F1, F2), in place of the shipped components of those names."""

    LEFT_OUT = ('component "render_normals" does not fit what replaced a component that it inherits from, and is left out: '
                "{data}/components/surface.component:")

    def drawn_with_listings(self, *arguments):
        outcome = self.croquis("render", CUBE, *SMALL, "--data", SEED_C, *arguments, "-o", "out.png")
        self.assertEqual(outcome.status, 0, outcome.errors)
        for line in outcome.errors.splitlines():
            self.assertTrue(line.startswith(self.placed(f"croquis: warning: {self.LEFT_OUT}")), line)
        return program.png.read(self.folder / "out.png")

    def test_edge_detector(self):
        """Program 2.1 on the cube: lines on a ground of one colour."""
        picture = self.drawn_with_listings("-t", "program_2_1")
        self.assertEqual(set(picture.pixels), {(0, 0, 0), (255, 255, 255)})
        self.assertTrue(0.005 < picture.share(lambda pixel: pixel == (0, 0, 0)) < 0.1)

    def test_edge_detector_is_the_shipped_one(self):
        self.drawn_with_listings("-t", "program_2_1")
        self.said("render", CUBE, *SMALL, "-t", "edges_depth_2nd", "--reference", "out.png", "--threshold", "0.5")

    def test_phong(self):
        picture = self.drawn_with_listings("-t", "phong")
        self.assertEqual(picture.corner, (128, 128, 128))
        self.assertGreater(picture.share_drawn(), 0.1)

    def test_copy_to_texture(self):
        self.write("own.technique", 'pass render_phong phong {} ;\npass copy_to_texture copy { texture "copied" ; } ;\n'
                                    'pass process_texture show { texture "<generated>:copied" ; fragment_program "image:copy" ; } ;\n')
        copied = self.drawn_with_listings("-t", "own.technique")
        self.assertEqual(copied.rows, self.drawn_with_listings("-t", "phong").rows)


if __name__ == "__main__":
    program.main()
