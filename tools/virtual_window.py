"""The viewer's window on a display of its own, driven as by a person: Xvfb, xdotool, xclip and drops by Xlib."""

import os
import pathlib
import select
import subprocess
import time

LOOKS = 5  # that find everybody asleep, one after another
IDLE_LOOKS = 50
BETWEEN_LOOKS = 0.02
MOST_PAUSE = 6  # after a key or a move of the mouse, where something always moves


class VirtualWindow:
    """A display with `croquis view` over its upper left `size` (width, height). Use it in a `with` statement."""

    def __init__(self, program, folder, size, *arguments, screen=None):
        self.folder = pathlib.Path(folder)
        self.screen = screen or size
        self.settings = self.folder / "viewer.toml"
        self.command = [str(program), "view", "--size", f"{size[0]}x{size[1]}", "--settings", str(self.settings)]
        self.command += [str(argument) for argument in arguments]

    def __enter__(self):
        reading, writing = os.pipe()  # Xvfb takes a free number and tells it here
        self.server = subprocess.Popen(
            ["Xvfb", "-r", "-displayfd", str(writing), "-screen", "0", f"{self.screen[0]}x{self.screen[1]}x24"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as told:
            self.display = ":" + told.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.display)
        self.viewer = subprocess.Popen(self.command, cwd=self.folder, env=self.environment,
                                       stderr=subprocess.PIPE, text=True)
        self.window = self._do("search", "--sync", "--onlyvisible", "--name", "Croquis").split()[0]
        return self

    def __exit__(self, *_):
        for process in (self.viewer, self.server):
            if process.poll() is None:
                process.terminate()
            process.wait()
        self.viewer.stderr.close()

    def _do(self, *words):
        done = subprocess.run(["xdotool", *[str(word) for word in words]], env=self.environment, check=True,
                              timeout=30, capture_output=True, text=True)
        return done.stdout

    # ---- Waiting

    def _sleepers(self):
        """Every thread of viewer and server with how often it went to sleep; None while one of them is awake."""
        sleepers = []
        for process in (self.viewer, self.server):
            for thread in pathlib.Path(f"/proc/{process.pid}/task").iterdir():
                try:
                    status = (thread / "status").read_text()
                except (FileNotFoundError, ProcessLookupError):
                    return None  # it has just ended
                if "\nState:\tS" not in status:
                    return None
                sleepers.append((thread.name, status.split("\nvoluntary_ctxt_switches:")[1].split()[0]))
        return sorted(sleepers)

    def _rests(self, seconds):
        """True once nobody has woken for some looks on end: all that was asked for is done and shown."""
        deadline = time.monotonic() + seconds
        last, same = None, 0
        while same < LOOKS and time.monotonic() < deadline:
            time.sleep(BETWEEN_LOOKS)
            now = self._sleepers()
            same = same + 1 if now is not None and now == last else 0
            last = now
        return same == LOOKS

    def wait_until_idle(self, seconds=60):
        """Returns once the viewer has read and drawn what there is.

        It looks for files and models between sleeps of 0.4 s, so that to be found asleep for a moment says nothing.
        """
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            asleep, shown, used = 0, self.shown(), self.processor_seconds()
            for _ in range(IDLE_LOOKS):
                time.sleep(BETWEEN_LOOKS)
                asleep += self._sleepers() is not None
            is_still = asleep >= 0.8 * IDLE_LOOKS and self.processor_seconds() - used <= 0.02
            if is_still and self._rests(MOST_PAUSE) and self.shown() == shown:
                return
        raise TimeoutError(f"the viewer is still busy after {seconds} s")

    def wait_until(self, is_so, what, seconds=30):
        """Returns once `is_so()`."""
        deadline = time.monotonic() + seconds
        while not is_so():
            if time.monotonic() > deadline:
                raise TimeoutError(f"not within {seconds} s: {what}")
            time.sleep(0.05)

    def wait_for_file(self, name):
        """The path of a file that the viewer writes, once it is there."""
        path = self.folder / name
        self.wait_until(path.exists, f"{name} is written")
        return path

    # ---- Mouse and keys. The user interface sees them once a frame: each waits until it was seen.

    def _do_and_rest(self, *words):
        self._do(*words)
        self._rests(MOST_PAUSE)

    def move(self, x, y):
        self._do_and_rest("mousemove", x, y)

    def click(self, x, y):
        self.drag((x, y), (x, y), steps=0)

    def drag(self, start, end, steps=4):
        """Presses at a point, moves on to another and lets go."""
        self.move(*start)
        self._do_and_rest("mousedown", 1)
        for step in range(1, steps + 1):
            self.move(*(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
        self._do_and_rest("mouseup", 1)

    def wheel(self, notches):
        """Turns the wheel: up is positive."""
        for _ in range(abs(notches)):
            self._do_and_rest("click", 4 if notches > 0 else 5)

    def key(self, name):
        self._do_and_rest("key", name)

    def hold(self, name):
        self._do_and_rest("keydown", name)

    def let_go(self, name):
        self._do_and_rest("keyup", name)

    def drop(self, *paths):
        """Drops files on the middle of the window, as a file manager does: the source's side of the XDND protocol."""
        from Xlib import X, display, protocol
        server = display.Display(self.display)
        atom = server.intern_atom
        target = server.create_resource_object("window", int(self.window))
        source = server.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        text = "".join(pathlib.Path(path).resolve().as_uri() + "\r\n" for path in paths).encode()

        def send(name, *numbers):
            numbers = [source.id, *numbers, *[0] * (4 - len(numbers))]
            target.send_event(protocol.event.ClientMessage(
                window=target, client_type=atom(name), data=(32, numbers)))

        source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)
        size = target.get_geometry()
        send("XdndEnter", 5 << 24, atom("text/uri-list"))
        send("XdndPosition", 0, (size.width // 2) << 16 | size.height // 2, X.CurrentTime, atom("XdndActionCopy"))
        send("XdndDrop", 0, X.CurrentTime)
        server.flush()
        is_finished = False
        while not is_finished:
            if not server.pending_events() and not select.select([server], [], [], 30)[0]:
                raise TimeoutError("the window does not take what was dropped")
            event = server.next_event()
            if event.type == X.SelectionRequest:
                event.requestor.change_property(event.property, event.target, 8, text)
                event.requestor.send_event(protocol.event.SelectionNotify(
                    time=event.time, requestor=event.requestor, selection=event.selection, target=event.target,
                    property=event.property))
            is_finished = event.type == X.ClientMessage and event.client_type == atom("XdndFinished")
        server.close()

    # ---- The window. There is no window manager: it is told itself.

    def resize(self, width, height):
        self._do_and_rest("windowsize", self.window, width, height)

    def minimise(self):
        self._do_and_rest("windowunmap", self.window)

    def restore(self):
        self._do_and_rest("windowmap", self.window)
        self.set_focus(True)

    def set_focus(self, on):
        """Gives the window the keyboard, or takes it away."""
        from Xlib import X, display
        server = display.Display(self.display)
        server.set_input_focus(int(self.window) if on else X.NONE, X.RevertToNone, X.CurrentTime)
        server.sync()
        server.close()
        self._rests(MOST_PAUSE)

    # ---- What comes out

    def processor_seconds(self):
        """What the viewer has used so far."""
        fields = pathlib.Path(f"/proc/{self.viewer.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def shown(self):
        """The display as a picture of PIL."""
        from PIL import ImageGrab
        return ImageGrab.grab(xdisplay=self.display)

    def picture(self):
        """Presses F12; the path of the picture that it writes."""
        before = set(self.folder.glob("*.png"))
        self._do("key", "F12")
        self.wait_until(lambda: set(self.folder.glob("*.png")) - before, "a picture is written")
        self._rests(MOST_PAUSE)
        return (set(self.folder.glob("*.png")) - before).pop()

    def clipboard(self):
        """What the viewer copied."""
        return subprocess.run(["xclip", "-out", "-selection", "clipboard"], env=self.environment, check=True,
                              timeout=30, capture_output=True, text=True).stdout

    def close(self):
        """Ctrl+Q; the exit status, and what was said on standard error."""
        self._do("key", "ctrl+q")
        _, errors = self.viewer.communicate(timeout=30)
        return self.viewer.returncode, errors
