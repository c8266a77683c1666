"""What the program says to wrong words: exact lines, for messages are interface."""

import re

import program
from program import DATA, MODELS

CUBE = MODELS / "cube.obj"
PHONG = "{data}/techniques/phong.technique:3:1: pass \"surfaces\""
CARTOON = "{data}/techniques/cartoon.technique:3:1: pass \"surfaces\""
TEXTURE_FORMS = "expected a texture as directory:image, directory:image:0, directory:image:1 or <generated>:name, found"
COLOR_FORMS = "expected a colour as R,G,B from 0 to 1, #RRGGBB or a name, found"
ENDINGS = ".obj .md2 .wrl .off .ase .ply .stl .gltf .glb .3ds"

# Arguments of `croquis render cube.obj -o out.png`, and what is said to them.
WRONG_OPTIONS = [
    # names
    (["--technique", "cartoom"], 'unknown technique "cartoom"; did you mean "cartoon"?'),
    (["--technique", "nothing_like_it"], 'unknown technique "nothing_like_it"'),
    (["--techniqe", "cartoon"], 'unknown argument "--techniqe"; did you mean "--technique"?'),
    (["--set", "surface.toon_map=x"], 'technique cartoon has no pass "surface"; did you mean "surfaces"?'),
    (["--set", "surfaces.toon_mop=x"], 'pass "surfaces" has no variable "toon_mop"; did you mean "toon_map"?'),
    (["--view", "fron"], 'unknown view "fron"; did you mean "front"?'),
    (["--projection", "paralel"], '--projection: expected perspective or parallel, found "paralel"; did you mean "parallel"?'),
    (["--gl", "vulkan"], 'expected the API to be gl, gles, found "vulkan"'),
    (["--device", "toaster"], 'expected the device to be auto, hardware, software, found "toaster"'),
    (["--animation", "run"], f'{CUBE}: expected animation clip "run", found a model without clips'),
    (["--data", "nodata"], "nodata: no such data folder"),
    (["another.obj"], 'unknown argument "another.obj"'),
    # textures
    (["--set", "surfaces.toon_map=ton:three_tone"], f'{CARTOON}, variable "toon_map": no texture directory "ton"; did you mean "toon"?'),
    (["--set", "surfaces.toon_map=toon:three_ton"], f'{CARTOON}, variable "toon_map": no image "three_ton" in texture directory "toon"; did you mean "three_tone"?'),
    (["--set", "surfaces.toon_map=3"], f'{CARTOON}, variable "toon_map": {TEXTURE_FORMS} "3"'),
    (["--set", "surfaces.toon_map=toon:flat:2"], f'{CARTOON}, variable "toon_map": {TEXTURE_FORMS} "toon:flat:2"'),
    (["--texture", "missing.png"], "missing.png: no such file"),
    (["--background", "papr:plain"], 'no texture directory "papr"; did you mean "paper"?'),
    (["--background", "paper:plan"], 'no image "plan" in texture directory "paper"; did you mean "plain"?'),
    # names that reach outside their folders
    (["--technique", "../techniques/phong"], 'expected a name inside its data folder, found "../techniques/phong"'),
    (["--technique", "/etc/passwd"], 'expected a name inside its data folder, found "/etc/passwd"'),
    (["--background", "../textures/paper:plain"], 'expected a name inside its data folder, found "../textures/paper"'),
    (["--background", "paper:../paper/plain"], 'expected a name inside its data folder, found "../paper/plain"'),
    (["--background", "/etc:passwd"], 'expected a name inside its data folder, found "/etc"'),
    (["--set", "surfaces.toon_map=../toon:flat"], f'{CARTOON}, variable "toon_map": expected a name inside its data folder, found "../toon"'),
    (["--set", "surfaces.fragment_program=../toon:toon"], f'{CARTOON}: expected a name inside its data folder, found "../toon"'),
    # shader functions
    (["--set", "surfaces.fragment_program=toon:ton"], f'{CARTOON}: {{data}}/shaders/toon.glsl: no shader function "ton"; did you mean "toon"?'),
    (["--set", "surfaces.fragment_program=tooon:toon"], f'{CARTOON}: no shader file "tooon"; did you mean "toon"?'),
    (["--set", "surfaces.fragment_program=toon"], f'{CARTOON}: expected a shader function as file:function, found "toon"'),
    # values of the wrong type
    (["--set", "surfaces"], 'expected pass.variable=value, found "surfaces"'),
    (["--set", "surfaces.clear_color=3"], 'surfaces.clear_color: expected 3 numbers (red green blue), found "3"'),
    (["--set", "edges.normal_threshold=abc"], 'edges.normal_threshold: expected a number, found "abc"'),
    (["--set", "edges.normal_threshold=nan"], 'edges.normal_threshold: expected a number, found "nan"'),
    (["--set", "edges.normal_threshold=1e99"], 'edges.normal_threshold: expected a number of at most 3.4e+38, found "1e99"'),
    (["--set", "edges.detect_ids=maybe"], 'edges.detect_ids: expected true or false, found "maybe"'),
    (["--samples", "x"], '--samples: expected a whole number, found "x"'),
    (["--seed", "-1"], '--seed: expected a whole number, found "-1"'),
    (["--time", "soon"], '--time: expected a number, found "soon"'),
    (["--time", "nan"], '--time: expected a number, found "nan"'),
    (["--size", "large"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "large"'),
    (["--size", "0x10"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "0x10"'),
    (["--size", "10x-10"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "10x-10"'),
    (["--size", "1e300x10"], '--size: expected a size in pixels as WIDTHxHEIGHT, found "1e300x10"'),
    (["--view", "1,x,2"], '--view: expected a name or a direction as X,Y,Z, found "1,x,2"'),
    (["--eye", "1,2"], '--eye: expected three numbers as X,Y,Z, found "1,2"'),
    (["--target", "1,2,3,4"], '--target: expected three numbers as X,Y,Z, found "1,2,3,4"'),
    (["--light", "1,2"], '--light: expected three numbers as X,Y,Z, found "1,2"'),
    (["--light", "vewer:1,1,1"], '--light: expected viewer:, world: or point: before X,Y,Z, found "vewer:1,1,1"; did you mean "viewer"?'),
    (["--light-color", "1,2,3"], '--light-color: expected R,G,B from 0 to 1, found "1,2,3"'),
    (["--background", "blu"], f'--background: {COLOR_FORMS} "blu"; did you mean "blue"?'),
    (["--background", "#12"], f'--background: {COLOR_FORMS} "#12"'),
    (["--threshold", "x"], '--threshold: expected MEAN or MEAN,MAXIMUM from 0 to 255, found "x"'),
    # values that make no sense
    (["--samples", "5"], "expected 1, 4, 9 or 16 samples a pixel, found 5"),
    (["--samples", "0"], "expected 1, 4, 9 or 16 samples a pixel, found 0"),
    (["--fit", "0"], "expected the fit to be above 0 and at most 1, found 0"),
    (["--fov", "180"], "expected the field of view to be above 0.1 and below 178 degrees, found 180"),
    (["--fov", "inf"], '--fov: expected a number, found "inf"'),
    (["--fov", "0"], "expected the field of view to be above 0.1 and below 178 degrees, found 0"),
    (["--view", "0,0,0"], "expected the view to have a direction, found 0,0,0"),
    (["--up", "0,0,0"], "expected the up vector to have a length, found 0,0,0"),
    (["--light", "0,0,0"], "expected the light to have a direction, found 0,0,0"),
    (["--eye", "1,1,1", "--target", "1,1,1"], "expected the eye at a distance from the target, found 0"),
    (["--size", "100000x100000"], re.compile(r"expected a size of 1x1 to (\d+)x\1 pixels, found 100000x100000")),
    (["--size", "1000000000x1"], re.compile(r"expected a size of 1x1 to (\d+)x\1 pixels, found 1000000000x1")),
    (["--size", "16000x16000", "--samples", "16"], re.compile(r"expected a size of 1x1 to (\d+)x\1 pixels, found 16000x16000")),
]

# Whole command lines.
WRONG_COMMANDS = [
    ([], "expected a command: render, lines, bench, view, list, describe or doctor; croquis --help tells more"),
    (["rendr"], 'unknown argument "rendr"; did you mean "render"?'),
    (["--versio"], 'unknown argument "--versio"; did you mean "--version"?'),
    (["list", "x"], 'unknown argument "x"'),
    (["describe", "cartoom"], 'no technique or component "cartoom"; did you mean "cartoon"?'),
    (["describe", "render_fong"], 'no technique or component "render_fong"; did you mean "render_phong"?'),
    (["describe", "missing.technique"], "missing.technique: no such file"),
    (["list", "--data", "nodata"], "nodata: no such data folder"),
    (["render", "missing.obj"], "missing.obj: no such file"),
    (["render", "."], f".: expected a model file ({ENDINGS}), found no ending"),
    (["render", "model.objj"], f'model.objj: expected a model file ({ENDINGS}), found ending .objj; did you mean ".obj"?'),
    (["render", "--input-dir", "missing"], "missing: no such folder"),
    (["render", "--input-dir", ".", CUBE], "expected a model or --input-dir, found both"),
    (["render", "--input-dir", "."], ".: no model file in this folder"),
    (["render", "--input-dir", ".", "-o", "missing"], "missing: expected a folder for the pictures of --input-dir"),
    (["render", "--input-dir", ".", "--reference", "x.png"], "--reference compares one picture: it does not go with --input-dir"),
    (["render", CUBE, "--reference", "missing.png"], "missing.png: no such file"),
]

# Technique files `own.technique` that are refused.
WRONG_TECHNIQUES = [
    ("pass render_fong x {}", 'own.technique:1:6: unknown component "render_fong"; did you mean "render_phong"?'),
    ("pass render_phong x {\n  clear_colour 1 1 1 ;\n}", 'own.technique:2:3: pass "x" sets "clear_colour", which component render_phong does not have; did you mean "clear_color"?'),
    ("pass render_phong x {\n  clear_color red ;\n}", 'own.technique:2:15: variable "clear_color" of component render_phong expects 3 numbers (red green blue), found "red"'),
    ('include "edgs" ;', 'own.technique:1:9: unknown technique "edgs"; did you mean "edges"?'),
    ('include "../own" ;', 'own.technique:1:9: expected a name inside its data folder, found "../own"'),
    ('include "own" ;', "own.technique:1:9: the includes never end: own includes own"),
    ('include "beside" ;', "beside.technique:1:9: the includes never end: own includes beside includes own"),
    ("pass render_phong x {", "own.technique:1:22: expected a variable or '}', found the end of the file; the '{' of pass \"x\" in line 1 is not closed"),
    ("pass process_texture x {}", 'own.technique:1:1: pass "x" must set "texture": component process_texture gives it no default'),
    ('pass render_phong x { texture "images:missing" ; }', 'own.technique:1:1: pass "x", variable "texture": no image "missing" in texture directory "images"'),
    ('pass overlay x { texture "<generated>:missing" ; }', 'own.technique:1:1: pass "x", variable "texture": no pass generates the texture "missing"'),
    (b"\x7fELF\x02\x01\x01\0\0\0", "own.technique:1:1: found the control character U+007F"),
    (b"#" * (2 << 20), "own.technique: larger than the 1048576 bytes allowed here"),
]

# A file of a data folder of one's own, a technique that uses it, and what is said.
WRONG_DATA = [
    ("components/a.component", "component a : b {}\ncomponent b : a {}", "phong", 'own/components/a.component:1:15: component "a" inherits from itself: a inherits b inherits a'),
    ("components/a.component", "component a : a {}", "phong", 'own/components/a.component:1:15: component "a" inherits from itself: a inherits a'),
    ("components/a.component", "component a : render_fong {}", "phong", 'own/components/a.component:1:15: component "a" inherits from unknown component "render_fong"; did you mean "render_phong"?'),
    ("components/a.component", "component a { number b { default x ; } ; } ;", "phong", re.compile(r'own/components/a\.component:1:34: .*expects a number, found "x"')),
    ("shaders/own.glsl", '#ifdef FRAGMENT_STAGE\nvec4 own() {\n    return nothing;\n}\n#endif\n', "own", re.compile(r'own/techniques/own\.technique:1:1: pass "x": own/shaders/own\.glsl:3:\d+: .*nothing.*')),
    ("shaders/own.glsl", "#ifdef FRAGMENT_STAGE\nvec4 own( {\n#endif\n", "own", re.compile(r'own/techniques/own\.technique:1:1: pass "x": own/shaders/own\.glsl.*')),
    ("shaders/own.glsl", '\n#include "nothing"\nvec4 own() { return vec4(1.0); }\n', "own", 'own/techniques/own.technique:1:1: pass "x": own/shaders/own.glsl:2:1: no shader file "nothing"'),
    ("shaders/own.glsl", '#include "own.glsl"\nvec4 own() { return vec4(1.0); }\n', "own", 'own/techniques/own.technique:1:1: pass "x": own/shaders/own.glsl:1:1: shader includes form a cycle: own -> own'),
    ("shaders/own.glsl", b"\x00\x01\x02\xff" * 100, "own", re.compile(r'own/techniques/own\.technique:1:1: pass "x": own/shaders/own\.glsl.*')),
    ("textures/own/junk.png", b"junk\n", "textured", 'own/techniques/textured.technique:1:1: pass "x", variable "texture": own/textures/own/junk.png: expected an image, found 5 bytes that are none (unknown image type)'),
]
OWN_TECHNIQUES = {
    "own": 'pass simple_render x { vertex_program "default:default_transform" ; fragment_program "own:own" ; }',
    "textured": 'pass render_phong x { texture "own:junk" ; }',
}

# Values out of range: what is used in their place. Each draws all the same.
CLAMPED = [
    ("edges.normal_threshold", "1e9", "1000000000 is outside -1 to 100; using 100"),
    ("edges.normal_threshold", "-7", "-7 is outside -1 to 100; using -1"),
    ("surfaces.clear_color", "3 0.5 -1", "3 0.5 -1 is outside 0 0 0 to 1 1 1; using 1 0.5 0"),
    ("edges.edge_color", "0 0 0 2", "0 0 0 2 is outside 0 0 0 0 to 1 1 1 1; using 0 0 0 1"),
]


class Messages(program.ProgramTest):
    def test_wrong_options(self):
        for arguments, message in WRONG_OPTIONS:
            self.refused(message, "render", CUBE, "-o", "out.png", *arguments)

    def test_wrong_commands(self):
        for arguments, message in WRONG_COMMANDS:
            self.refused(message, *arguments)

    def test_wrong_techniques(self):
        self.write("beside.technique", 'include "own" ;')
        for text, message in WRONG_TECHNIQUES:
            self.write("own.technique", text)
            self.refused(message, "render", CUBE, "-t", "own.technique", "-o", "out.png")

    def test_wrong_data(self):
        for name, text, technique, message in WRONG_DATA:
            for own, passes in OWN_TECHNIQUES.items():
                self.write(f"own/techniques/{own}.technique", passes)
            path = self.write(f"own/{name}", text)
            self.refused(message, "render", CUBE, "--data", "own", "-t", technique, "-o", "out.png")
            path.unlink()

    def test_link_out_of_the_data_folder(self):
        outside = self.write("outside/picture.png", (DATA / "textures/paper/plain.png").read_bytes())
        (self.folder / "own/textures/own").mkdir(parents=True)
        (self.folder / "own/textures/own/link.png").symlink_to(outside)
        message = 'expected a name inside its data folder, found "link", a link out of it'
        self.refused(message, "render", CUBE, "--data", "own", "--background", "own:link", "-o", "out.png")

    def test_out_of_range_is_clamped(self):
        for variable, value, message in CLAMPED:
            with self.subTest(variable=variable, value=value):
                outcome = self.croquis("render", CUBE, *program.SMALL, "--set", f"{variable}={value}", "-o", "out.png")
                self.assertEqual(outcome.status, 0)
                self.assertRegex(outcome.errors, rf"\Acroquis: warning: {re.escape(variable)}: .*{re.escape(message)}\n\Z")
                used = message.rsplit("using ", 1)[1]
                self.drawn(CUBE, *program.SMALL, "--set", f"{variable}={used}")
                self.said("render", CUBE, *program.SMALL, "--set", f"{variable}={used}", "--reference", "out.png", "--threshold", "0")

    def test_out_of_range_in_a_file(self):
        self.write("own.technique", "pass render_phong x {\n  clear_color 2 0.5 -1 ;\n}\n")
        warning = 'own.technique:2:15: variable "clear_color" of component render_phong: 2 0.5 -1 is outside 0 0 0 to 1 1 1; using 1 0.5 0'
        picture = self.drawn(CUBE, *program.SMALL, "-t", "own.technique", warning=warning)
        self.assertEqual(picture.corner, (255, 128, 0))

    def test_wrong_environment(self):
        for name, message in [
            ("CROQUIS_GL", 'expected the API to be gl, gles, found "nothing"'),
            ("CROQUIS_DEVICE", 'expected the device to be auto, hardware, software, found "nothing"'),
            ("CROQUIS_DATA", 'expected CROQUIS_DATA to name a folder with components and techniques, found "nothing"'),
        ]:
            self.refused(message, "render", CUBE, "-o", "out.png", environment={name: "nothing"})


if __name__ == "__main__":
    program.main()
