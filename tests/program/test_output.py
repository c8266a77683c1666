"""Pictures appear whole or not at all, wherever they are sent and whatever happens meanwhile."""

import os
import pty
import resource
import signal
import subprocess
import time

import png
import program
from program import MODELS, SMALL

CUBE = MODELS / "cube.obj"
DRAW = ("render", CUBE, *SMALL)
FULL = "/dev/full"


def no_large_files():
    """Lets this process write 100 bytes to a file, and then no more: a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))


def on_terminal(arguments, folder):
    """What a run of the program says when its standard error is a terminal."""
    ours, theirs = pty.openpty()
    with subprocess.Popen([program.PROGRAM, *map(str, arguments)], cwd=folder, stderr=theirs, stdout=subprocess.PIPE) as run:
        os.close(theirs)
        said = b""
        try:
            while part := os.read(ours, 4096):
                said += part
        except OSError:  # the other end was closed
            pass
        os.close(ours)
        run.wait(timeout=program.MOST_SECONDS_SLOW)
    return run.returncode, said.decode()


class Places(program.ProgramTest):
    def test_default_name(self):
        self.said(*DRAW)
        self.assertEqual(self.files(), {"cube.png"})
        self.said("render", *SMALL)
        self.assertEqual(self.files(), {"cube.png", "teapot.png"})

    def test_standard_output_is_the_same_file(self):
        self.said(*DRAW, "-o", "out.png")
        outcome = self.croquis(*DRAW, "-o", "-")
        self.assertEqual((outcome.status, outcome.errors), (0, ""))
        self.assertEqual(outcome.output, (self.folder / "out.png").read_bytes())
        self.assertEqual(self.files(), {"out.png"})

    def test_places_that_take_no_picture(self):
        (self.folder / "folder").mkdir()
        for place, message in [
            ("missing/out.png", "missing/out.png: folder missing does not exist"),
            ("folder", "folder: expected a file name, found a folder"),
            (".", ".: expected a file name, found a folder"),
            (FULL, f"{FULL}: cannot write: No space left on device"),
            ("/proc/out.png", "/proc/out.png: cannot write: No such file or directory"),
            ("x" * 300 + ".png", "x" * 300 + ".png: cannot write: File name too long"),
            ("new\nline/out.png", "new\\x0aline/out.png: folder new\\x0aline does not exist"),
        ]:
            self.refused(message, *DRAW, "-o", place)

    def test_full_disk_behind_standard_output(self):
        with open(FULL, "wb") as full:
            outcome = self.croquis(*DRAW, "-o", "-", output=full)
        self.assert_refused(outcome, "standard output: cannot write: No space left on device")

    def test_full_disk_leaves_nothing(self):
        self.write("out.png", b"older picture")
        for name in ("out.png", "new.png"):
            environment = {"MESA_SHADER_CACHE_DISABLE": "true"}
            self.refused(f"{name}: cannot write: File too large", *DRAW, "-o", name,
                         preexec_fn=no_large_files, restore_signals=False, environment=environment)
        self.assertEqual((self.folder / "out.png").read_bytes(), b"older picture")

    def test_folder_that_cannot_be_written_to(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere; /proc stands for this case elsewhere")
        (self.folder / "closed").mkdir(mode=0o555)
        self.refused("closed/out.png: cannot write: Permission denied", *DRAW, "-o", "closed/out.png")

    def test_refusal_keeps_the_older_picture(self):
        self.write("out.png", b"older picture")
        self.refused("missing.obj: no such file", "render", "missing.obj", "-o", "out.png")
        self.assertEqual((self.folder / "out.png").read_bytes(), b"older picture")

    def test_killed_half_way(self):
        """Whenever it is killed, the final name holds a whole picture or does not exist."""
        command = [program.PROGRAM, "render", "--size", "2000x1500", "-o", "out.png"]
        whole = 0
        for step in range(8):
            with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL) as run:
                time.sleep(0.05 + 0.1 * step)
                run.kill()
            path = self.folder / "out.png"
            if path.exists():
                whole += 1
                data = path.read_bytes()
                self.assertEqual(list(png.chunks(data))[-1][0], b"IEND")
                path.unlink()
        self.assertLess(whole, 8)

    def test_closed_pipe(self):
        """Nobody reads standard output: the program ends, by the signal for that or with status 2."""
        reader, writer = os.pipe()
        os.close(reader)
        run = subprocess.run([program.PROGRAM, *map(str, DRAW), "-o", "-"], cwd=self.folder, stdout=writer,
                             stderr=subprocess.PIPE, timeout=program.MOST_SECONDS, check=False)
        os.close(writer)
        self.assertIn(run.returncode, (2, -signal.SIGPIPE))


class References(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.said(*DRAW, "-o", "reference.png")

    def test_same_picture(self):
        self.said(*DRAW, "--reference", "reference.png", "--threshold", "0,0")
        self.assertEqual(self.files(), {"reference.png"})

    def test_different_picture_is_status_1_and_is_written(self):
        outcome = self.croquis(*DRAW, "-t", "phong", "--reference", "reference.png", "-o", "other.png")
        self.assertEqual((outcome.status, outcome.output), (1, b""))
        self.assertRegex(
            outcome.errors,
            r"\Acroquis: reference\.png: the picture differs: mean \d+\.\d{3}, maximum \d+ "
            r"\(allowed: mean 0\.5, maximum 255\)\n\Z",
        )
        self.assertEqual(self.files(), {"reference.png", "other.png"})

    def test_difference_is_the_mean_over_four_channels(self):
        one, other = self.drawn(*DRAW[1:]), self.drawn(*DRAW[1:], "--background", "red")
        pairs = [(a, b) for p, q in zip(one.pixels, other.pixels) for a, b in zip(p, q)]
        mean = sum(abs(a - b) for a, b in pairs) / (160 * 120 * 4)
        outcome = self.croquis(*DRAW, "--background", "red", "--reference", "reference.png", "--threshold", "0,0")
        self.assertIn(f"mean {mean:.3f}, maximum {max(abs(a - b) for a, b in pairs)} ", outcome.errors)

    def test_size_that_differs(self):
        self.refused("expected pictures of one size, found 20x10 and 160x120",
                     "render", CUBE, "--size", "20x10", "--reference", "reference.png", "-o", "out.png")

    def test_reference_that_is_no_picture(self):
        self.write("junk.png", "junk\n")
        self.refused("junk.png: expected an image, found 5 bytes that are none (unknown image type)",
                     *DRAW, "--reference", "junk.png", "-o", "out.png")


class Terminal(program.ProgramTest):
    def test_says_what_it_wrote(self):
        self.assertEqual(on_terminal([*DRAW, "-o", "out.png"], self.folder), (0, "wrote out.png\r\n"))

    def test_counts_through_a_folder(self):
        for name in ("a.obj", "b.obj"):
            self.write(f"models/{name}", CUBE.read_bytes())
        status, said = on_terminal(["render", "--input-dir", "models", *SMALL], self.folder)
        self.assertEqual(status, 0)
        for part in ("[1/2] models/a.obj", "[2/2] models/b.obj", "wrote ./a.png", "wrote ./b.png"):
            self.assertIn(part, said)

    def test_quiet_in_pipes(self):
        self.write("models/a.obj", CUBE.read_bytes())
        self.assertEqual(self.said("render", "--input-dir", "models", *SMALL), "")


if __name__ == "__main__":
    program.main()
