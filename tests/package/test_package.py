"""The package that `cmake --install` makes: its files, README.md's C++ example built against it, and its data found."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["CROQUIS_SOURCE"])
BUILD = pathlib.Path(os.environ["CROQUIS_BUILD"])
CMAKE = os.environ["CMAKE"]
HERE = pathlib.Path(__file__).parent

sys.path.insert(0, str(HERE.parent / "program"))
import png

# Nothing may lead the installed files to the source tree's data.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "CROQUIS_DATA"}


def code_block(text, language):
    """The first fenced block of a language in a Markdown text."""
    return re.search(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)[1]


def run(*command, folder, environment=None):
    """Standard output of a command that must succeed."""
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False,
                          env={**ENVIRONMENT, **(environment or {})})
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def installed_prefix(folder):
    """Installs below a folder; returns the prefix."""
    prefix = folder / "prefix"
    run(CMAKE, "--install", BUILD, "--prefix", prefix, folder=folder)
    return prefix


def built(source, prefix, folder):
    """Builds the CMake project `source` against an installed package; returns its build folder."""
    run(CMAKE, "-S", source, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release", folder=source)
    run(CMAKE, "--build", folder, folder=source)
    return folder


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="package-", dir=BUILD))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.prefix = installed_prefix(cls.folder)

    def library(self):
        """The installed shared library, as the linker names it."""
        return next(self.prefix.rglob("libcroquis.so"))

    def test_files(self):
        headers = {path.name for path in (SOURCE / "include/croquis").iterdir()}
        self.assertEqual({path.name for path in (self.prefix / "include/croquis").iterdir()}, headers)
        self.assertEqual([path.name for path in (self.prefix / "include").iterdir()], ["croquis"])
        self.assertEqual([path.name for path in (self.prefix / "bin").iterdir()], ["croquis"])
        for name in ("LICENSE", "README.md"):
            self.assertEqual((self.prefix / "share/doc/croquis" / name).read_bytes(), (SOURCE / name).read_bytes())
        shipped = {path.relative_to(SOURCE / "data") for path in (SOURCE / "data").rglob("*")}
        installed = {path.relative_to(self.prefix / "share/croquis") for path in (self.prefix / "share/croquis").rglob("*")}
        self.assertEqual(installed, shipped)
        self.assertFalse(list(self.prefix.rglob("*.a")))

    def test_library_shows_its_own_names_alone(self):
        symbols = run("nm", "-DC", "--defined-only", self.library(), folder=self.folder).splitlines()
        self.assertGreater(len(symbols), 20)
        name = re.compile(r"^[0-9a-f]+ . ((typeinfo( name)?|vtable) for )?croquis::(compare_face_orientations|draw_lines|line_classes|Error|LineDrawing|Model|Paper|Picture|Renderer|Technique|View)\b")
        self.assertEqual([line for line in symbols if not name.match(line)], [])

    def test_library_has_a_version(self):
        said = run("readelf", "-d", self.library(), folder=self.folder)
        self.assertRegex(said, r"SONAME.*\[libcroquis\.so\.\d+\.\d+\]")
        self.assertRegex(self.library().resolve().name, r"^libcroquis\.so\.\d+\.\d+\.\d+$")

    def test_example_of_the_readme(self):
        text = (SOURCE / "README.md").read_text()
        project = self.folder / "example"
        project.mkdir()
        recipe = code_block(text, "cmake")
        name, source = re.search(r"add_executable\((\w+) ([\w.]+)\)", recipe).groups()
        (project / "CMakeLists.txt").write_text(recipe)
        (project / source).write_text(code_block(text, "cpp"))
        program = built(project, self.prefix, self.folder / "example_build") / name
        self.assertEqual(run(program, SOURCE / "data/models/two_material_cube.obj", folder=self.folder), "")
        picture = png.read(self.folder / f"{name}.png")
        self.assertEqual((picture.width, picture.height), (1024, 768))
        self.assertTrue(0.05 < picture.share_drawn() < 0.95)

    def test_data_is_found_from_another_program(self):
        program = built(HERE / "consumer", self.prefix, self.folder / "consumer_build") / "data_folder"
        complaint = 'unknown technique "cartoom"; did you mean "cartoon"?'
        moved = self.folder / "moved"
        shutil.copytree(self.prefix, moved, symlinks=True)
        for prefix in (self.prefix, moved):
            with self.subTest(prefix=prefix.name):
                libraries = str((prefix / self.library().relative_to(self.prefix)).parent)
                said = run(program, folder=self.folder, environment={"LD_LIBRARY_PATH": libraries}).splitlines()
                self.assertEqual([os.path.normpath(said[0]), said[1]], [str(prefix / "share/croquis"), complaint])

    def test_installed_program_finds_its_data(self):
        said = run(self.prefix / "bin/croquis", "doctor", folder=self.folder)
        self.assertIn(f"data folder    {self.prefix / 'share/croquis'}\n", said)


if __name__ == "__main__":
    unittest.main()
