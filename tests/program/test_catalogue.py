"""list, describe, doctor, --version and --help: what the program says of itself agrees with its data."""

import json
import re

import program
from program import DATA

COMMANDS = ["render", "lines", "bench", "list", "describe", "doctor"]
# Options that each command's help must name.
OPTIONS = {
    "render": ["--output", "--technique", "--set", "--size", "--view", "--eye", "--target", "--up", "--fov", "--fit",
               "--projection", "--light", "--light-color", "--background", "--samples", "--animation", "--time",
               "--texture", "--simplify", "--subdivide", "--scheme", "--seed", "--reference", "--threshold", "--list-passes", "--input-dir", "--data", "--gl",
               "--device"],
    "lines": ["--output", "--format", "--size", "--paper", "--landscape", "--margin", "--view", "--views", "--classes",
              "--width", "--hidden", "--hidden-width", "--crease-angle", "--fill", "--stroke", "--plotter", "--clean",
              "--exact", "--visibility", "--finder", "--subdivide", "--scheme", "--seed", "--timings", "--repeat"],
    "bench": ["--techniques", "--size", "--view", "--texture", "--subdivide", "--scheme", "--coverage", "--turn", "--levels",
              "--triangles", "--frames", "--seconds", "--passes", "--stability", "--json", "--plot", "--data", "--gl", "--device"],
    "list": ["--json", "--data"],
    "describe": ["--json", "--data", "name"],
    "doctor": ["--gl", "--device"],
}
NUMBER_TYPES = {"int", "number", "vector2", "vector3", "vector4", "rgb", "rgba"}
TOKEN = re.compile(r'#[^\n]*|"([^"\n]*)"|([{};:])|([^\s{};:"#]+)')


def tokens(text):
    """The words of a descriptor file; quoted ones come as ("text",)."""
    found = []
    for match in TOKEN.finditer(text):
        if match[1] is not None:
            found.append((match[1],))
        elif match[2] or match[3]:
            found.append(match[2] or match[3])
    return found


def block(words, start):
    """Where the block that opens at words[start] ends."""
    depth = 0
    for i in range(start, len(words)):
        depth += {"{": 1, "}": -1}.get(words[i], 0)
        if depth == 0:
            return i
    raise ValueError("a block is not closed")


def properties(words):
    """A variable's block as {name: [words]}."""
    found, current = {}, []
    for word in words:
        if word == ";":
            found.setdefault(current[0], current[1:])
            current = []
        else:
            current.append(word)
    return found


def variables(words):
    """The variables that a component's block declares: {name: (type, properties)}."""
    found, i = {}, 0
    while i < len(words):
        if words[i] == "modify":
            i = block(words, i + 2) + 1
        elif words[i] == "help":
            i = words.index(";", i)
        elif words[i] != ";":
            kind, name, inside = words[i], words[i + 1], []
            if words[i + 2] == "{":
                end = block(words, i + 2)
                inside, i = words[i + 3 : end], end
            else:
                i += 2
            found[name] = (kind, properties(inside))
        i += 1
    return found


def declared_components():
    """The shipped descriptors, read anew: {name: (parent, variables)}."""
    found = {}
    for path in (DATA / "components").glob("*.component"):
        words, i = tokens(path.read_text()), 0
        while i < len(words):
            if words[i] == "component":
                opening = words.index("{", i)
                end = block(words, opening)
                parent = words[i + 3] if words[i + 2] == ":" else None
                found[words[i + 1]] = (parent, variables(words[opening + 1 : end]))
                i = end
            i += 1
    return found


def as_json(kind, words):
    """A property's words as the JSON value that stands for them."""
    if kind == "bool":
        return words[0] in ("true", "1")
    if kind not in NUMBER_TYPES:
        return words[0][0]
    numbers = [float(word) for word in words]
    return numbers[0] if kind in ("int", "number") else numbers


class Catalogue(program.ProgramTest):
    def test_list_names_everything_with_its_help(self):
        listing = json.loads(self.said("list", "--json"))
        self.assertEqual([each["name"] for each in listing["techniques"]], program.technique_names())
        components = declared_components().keys() - {"every_component"}  # which lends its variables to the others
        self.assertEqual({each["name"] for each in listing["components"]}, components)
        text = self.said("list")
        for each in listing["techniques"] + listing["components"]:
            self.assertGreater(len(each["help"]), 10, each)
            self.assertIn(f"\n  {each['name']} ", text)
            self.assertIn(each["help"], text)

    def test_describe_agrees_with_the_descriptors(self):
        for name, (parent, own) in declared_components().items():
            if name == "every_component" or name in program.technique_names():
                continue  # the one is none to use; of two of one name, the technique is described
            with self.subTest(component=name):
                described = json.loads(self.said("describe", "--json", name))
                self.assertEqual((described["name"], described.get("inherits")), (name, parent))
                found = {each["name"]: each for each in described["variables"]}
                for variable, (kind, said) in own.items():
                    self.assertEqual(found[variable]["type"], kind)
                    for key in ("default", "minimum", "maximum"):
                        if key in said:
                            self.assertEqual(found[variable][key], as_json(kind, said[key]), (variable, key))
                self.assertIn("render", found)

    def test_describe_in_words(self):
        text = self.said("describe", "wireframe")
        self.assertRegex(text, r"(?m)^technique wireframe$")
        text = self.said("describe", "wireframe", "--component")
        self.assertRegex(text, r"(?m)^component wireframe$")
        text = self.said("describe", "edge_detect_normals")
        self.assertRegex(text, r"(?m)^component edge_detect_normals : edge_detector$")
        self.assertIn("    number threshold = 0.7  (from -1 to 100)\n", text)
        self.assertNotIn("fragment_program", text)

    def test_describe_every_technique(self):
        for name in program.technique_names():
            with self.subTest(technique=name):
                described = json.loads(self.said("describe", "--json", name))
                self.assertEqual(described["name"], name)
                self.assertGreater(len(described["passes"]), 0)
                for each in described["passes"]:
                    self.assertTrue(all("value" in variable for variable in each["variables"]))
                self.assertIn(described["help"], self.said("describe", name))

    def test_values_of_a_technique_are_those_of_its_file(self):
        described = json.loads(self.said("describe", "--json", "ink_lines"))
        edges = next(each for each in described["passes"] if each["name"] == "edges")
        values = {variable["name"]: variable["value"] for variable in edges["variables"]}
        self.assertEqual((values["blend"], values["non_edge_color"]), ("over", [0, 0, 0, 0]))

    def test_describe_a_file(self):
        self.write("own.technique", 'help "Mine." ;\npass render_base surfaces { clear_color 1 0 0 ; } ;\n')
        described = json.loads(self.said("describe", "--json", "own.technique"))
        self.assertEqual((described["name"], described["help"]), ("own", "Mine."))

    def test_doctor(self):
        said = self.said("doctor")
        for line in (r"OpenGL 3\.3     works: .+", r"OpenGL ES 3\.0  works: .+", r"chosen         .+",
                     rf"data folder    {re.escape(str(DATA))}",
                     rf"techniques     {len(program.technique_names())} found, 0 broken",
                     r"models         \.obj \.md2 \.wrl \.off \.ase \.ply \.stl \.gltf \.glb \.3ds",
                     r"nothing is missing"):
            self.assertRegex(said, rf"(?m)^{line}$")

    def test_doctor_names_a_broken_technique(self):
        self.write("own/techniques/broken.technique", "pass render_fong x {} ;\n")
        outcome = self.croquis("doctor", "--data", "own")
        self.assertEqual((outcome.status, outcome.errors), (1, ""))
        said = outcome.output.decode()
        for api in ("OpenGL 3.3", "OpenGL ES 3.0"):
            self.assertIn(f"broken         technique broken on {api}: own/techniques/broken.technique:1:6: ", said)
        self.assertNotIn("nothing is missing", said)

    def test_version(self):
        self.assertRegex(self.said("--version"), r"\Acroquis \d+\.\d+\.\d+\n\Z")

    def test_help(self):
        text = self.said("--help")
        for command in COMMANDS:
            self.assertIn(f"  {command} ", text)
            said = self.said(command, "--help")
            for option in OPTIONS[command]:
                self.assertIn(option, said)


if __name__ == "__main__":
    program.main()
