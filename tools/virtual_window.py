"""The viewer's window on a display of its own, driven as by a person: Xvfb and xdotool."""

import os
import pathlib
import subprocess
import time

PAUSE = 0.12  # between move, press and release: the user interface sees the mouse once a frame


class VirtualWindow:
    """A display of `size` (width, height) with `croquis view` over all of it. Use it in a `with` statement."""

    def __init__(self, program, folder, size, *arguments):
        self.folder = pathlib.Path(folder)
        self.size = size
        self.settings = self.folder / "viewer.toml"
        self.command = [str(program), "view", "--size", f"{size[0]}x{size[1]}", "--settings", str(self.settings)]
        self.command += [str(argument) for argument in arguments]

    def __enter__(self):
        reading, writing = os.pipe()  # Xvfb takes a free number and tells it here
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{self.size[0]}x{self.size[1]}x24"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as told:
            self.display = ":" + told.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.display)
        self.viewer = subprocess.Popen(self.command, cwd=self.folder, env=self.environment,
                                       stderr=subprocess.PIPE, text=True)
        self._do("search", "--sync", "--onlyvisible", "--name", "Croquis")
        return self

    def __exit__(self, *_):
        for process in (self.viewer, self.server):
            if process.poll() is None:
                process.terminate()
            process.wait()
        self.viewer.stderr.close()

    def _do(self, *words):
        subprocess.run(["xdotool", *[str(word) for word in words]], env=self.environment, check=True, timeout=30,
                       stdout=subprocess.DEVNULL)

    def move(self, x, y):
        self._do("mousemove", x, y)
        time.sleep(PAUSE)

    def click(self, x, y):
        self.drag((x, y), (x, y))

    def drag(self, start, end, steps=6):
        """Presses at a point, moves on to another and lets go."""
        self.move(*start)
        self._do("mousedown", 1)
        time.sleep(PAUSE)
        for step in range(1, steps + 1):
            self.move(*(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
        self._do("mouseup", 1)
        time.sleep(PAUSE)

    def key(self, name):
        self._do("key", name)
        time.sleep(PAUSE)

    def hold(self, name):
        self._do("keydown", name)
        time.sleep(PAUSE)

    def let_go(self, name):
        self._do("keyup", name)
        time.sleep(PAUSE)

    def processor_seconds(self):
        """What the viewer has used so far."""
        fields = pathlib.Path(f"/proc/{self.viewer.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def wait_until_idle(self, seconds=60):
        """Returns once the viewer has used next to nothing for a while: it has read and drawn what there is."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            before = self.processor_seconds()
            time.sleep(1.0)
            if self.processor_seconds() - before <= 0.03:
                return
        raise TimeoutError(f"the viewer is still busy after {seconds} s")

    def shown(self):
        """The display as a picture of PIL."""
        from PIL import ImageGrab
        return ImageGrab.grab(xdisplay=self.display)

    def wait_for_file(self, name, seconds=30):
        """The path of a file that the viewer writes, once it is there."""
        path = self.folder / name
        deadline = time.monotonic() + seconds
        while not path.exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        return path

    def close(self):
        """Ctrl+Q; the exit status, and what was said on standard error."""
        self.key("ctrl+q")
        _, errors = self.viewer.communicate(timeout=30)
        return self.viewer.returncode, errors
