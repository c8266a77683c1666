"""What the tests of the program share: running it in an empty folder, and what every run must keep to."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from typing import NamedTuple

import png

PROGRAM = os.environ["CROQUIS"]
DATA = pathlib.Path(os.environ["CROQUIS_DATA"])
MODELS = DATA / "models"
ASSIMP = pathlib.Path("/usr/share/assimp/models")  # Debian's assimp-testmodels
OWN_DATA = pathlib.Path(__file__).parent / "data"

MOST_SECONDS = 10  # of a refusal
MOST_SECONDS_SLOW = 30  # of anything else; more than a loaded machine needs
SMALL = ("--size", "160x120")

# The formats that are read, and a sound file of each.
SOUND_MODELS = {
    ".obj": MODELS / "cube.obj",
    ".md2": ASSIMP / "MD2/faerie.md2",
    ".wrl": ASSIMP / "WRL/Wuson.wrl",
    ".off": ASSIMP / "OFF/Cube.off",
    ".ase": ASSIMP / "ASE/ThreeCubesGreen.ASE",
    ".ply": ASSIMP / "PLY/cube_binary.ply",
    ".stl": ASSIMP / "STL/Spider_binary.stl",
    ".gltf": ASSIMP / "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf",
    ".glb": ASSIMP / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
    ".3ds": ASSIMP / "3DS/fels.3ds",
}


class Outcome(NamedTuple):
    """What a run of the program came to."""

    status: int
    output: bytes
    errors: str
    seconds: float


def technique_names():
    """The shipped techniques."""
    return sorted(path.stem for path in (DATA / "techniques").glob("*.technique"))


class ProgramTest(unittest.TestCase):
    """A test with an empty folder of its own, in which the program runs."""

    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="croquis-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def write(self, name, text):
        """Writes a file below the test's folder; returns its path."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def files(self):
        """All files below the test's folder."""
        return {str(path.relative_to(self.folder)) for path in self.folder.rglob("*")}

    def croquis(self, *arguments, environment=None, output=subprocess.PIPE, **options):
        """Runs the program; it must end by itself, and never by a signal."""
        command = [PROGRAM, *map(str, arguments)]
        start = time.monotonic()
        done = subprocess.run(
            command,
            cwd=self.folder,
            env={**os.environ, **(environment or {})},
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.PIPE,
            timeout=MOST_SECONDS_SLOW,
            check=False,
            **options,
        )
        errors = done.stderr.decode(errors="replace")
        self.assertGreaterEqual(done.returncode, 0, f"{command} was ended by a signal: {errors}")
        return Outcome(done.returncode, done.stdout or b"", errors, time.monotonic() - start)

    def said(self, *arguments, **options):
        """What a run that must succeed without complaint writes on standard output."""
        outcome = self.croquis(*arguments, **options)
        self.assertEqual((outcome.status, outcome.errors), (0, ""), arguments)
        return outcome.output.decode()

    def drawn(self, *arguments, warning="", **options):
        """The picture of `croquis render` with these arguments; `warning` is all it may complain about."""
        outcome = self.croquis("render", *arguments, "-o", "-", **options)
        expected = f"croquis: warning: {warning}\n" if warning else ""
        self.assertEqual((outcome.status, outcome.errors), (0, self.placed(expected)), arguments)
        return png.decode(outcome.output)

    def placed(self, message):
        """The message with {data} and {folder} filled in."""
        return message.replace("{data}", str(DATA)).replace("{folder}", str(self.folder))

    def assert_refused(self, outcome, message):
        """A user's mistake: status 2, one line on standard error, nothing on standard output, soon.

        The message is the whole line after "croquis: ", or a compiled expression for it.
        """
        self.assertEqual(outcome.status, 2, outcome.errors)
        self.assertEqual(outcome.output, b"")
        if isinstance(message, re.Pattern):
            self.assertRegex(outcome.errors, rf"\Acroquis: (?:{message.pattern})\n\Z")
            self.assertEqual(outcome.errors.count("\n"), 1)
        else:
            self.assertEqual(outcome.errors, f"croquis: {self.placed(message)}\n")
        self.assertLess(outcome.seconds, MOST_SECONDS)

    def refused(self, message, *arguments, **options):
        """Runs the program with arguments that it must refuse, leaving no file behind."""
        before = self.files()
        outcome = self.croquis(*arguments, **options)
        with self.subTest(arguments=list(map(str, arguments))):
            self.assert_refused(outcome, message)
            self.assertEqual(self.files(), before)


def main():
    """Runs the tests of the file that calls this."""
    unittest.main(verbosity=1)
