"""croquis view in a real window: what a person does with mouse, keys and files, on a virtual display."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import unittest

from program import DATA, MODELS, PROGRAM, ProgramTest, main

sys.path.insert(0, str(DATA.parent / "tools"))
from virtual_window import VirtualWindow  # noqa: E402

SIZE = (720, 450)
MIDDLE = (330, 225)  # of the drawing, between the panels
KNOB = (61, 133, 224)  # of a slider
MISTAKE = (255, 153, 128)  # the colour of what is told

TOOLS = all(map(shutil.which, ("Xvfb", "xdotool", "xclip"))) and all(map(importlib.util.find_spec, ("PIL", "Xlib")))

# A square that a texture lies on as it is.
BOARD = """v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1
f 1/1/1 2/2/1 3/3/1 4/4/1\n"""


def colors(picture):
    """How many pixels of a picture have which colour, red, green and blue."""
    return {color[:3]: count for count, color in picture.convert("RGB").getcolors(1 << 24)}


def tells_a_mistake(window):
    return MISTAKE in colors(window.shown())


def first_knob(window):
    """The middle of the uppermost slider's knob."""
    picture = window.shown().convert("RGB")
    for y in range(picture.height):
        row = [x for x in range(picture.width * 3 // 5, picture.width) if picture.getpixel((x, y)) == KNOB]
        if len(row) > 5:
            return row[len(row) // 2], y + 6
    raise AssertionError("no slider is shown")


@unittest.skipUnless(TOOLS, "no virtual display here")
class WindowTest(ProgramTest):
    def open_window(self, *arguments, **options):
        window = VirtualWindow(PROGRAM, self.folder, SIZE, *arguments, **options)
        self.enterContext(window)
        window.move(*MIDDLE)
        window.wait_until_idle()
        return window

    def picture(self, window):
        """What F12 writes."""
        from PIL import Image
        with Image.open(window.picture()) as picture:
            return picture.convert("RGBA")

    def by_command(self, command):
        """The picture of a command that was copied, run by a shell as by a person."""
        from PIL import Image
        path = f"{pathlib.Path(PROGRAM).parent}{os.pathsep}{os.environ['PATH']}"
        subprocess.run(command, shell=True, cwd=self.folder, env=dict(os.environ, PATH=path), check=True, timeout=60)
        with Image.open(self.folder / "drawing.png") as picture:
            return picture.convert("RGBA")

    def assert_same(self, one, other, most=0):
        """Pictures of one size that differ nowhere by more than `most` of 255."""
        from PIL import ImageChops
        self.assertEqual(one.size, other.size)
        difference = ImageChops.difference(one, other)
        self.assertLessEqual(max(high for _, high in difference.getextrema()), most, difference.getbbox())

    def assert_closes(self, window):
        self.assertEqual(window.close(), (0, ""))

    def test_a_session(self):
        """Drag, keys, another technique, pictures, and what is remembered at the end."""
        window = self.open_window(MODELS / "teapot.obj", "-t", "cartoon")
        first = self.picture(window)
        window.drag(MIDDLE, (390, 180))
        turned = self.picture(window)
        window.wheel(3)
        nearer = self.picture(window)
        window.key("Home")
        again = self.picture(window)
        window.key("Down")
        other = self.picture(window)
        window.key("Tab")
        self.assert_closes(window)
        self.assertNotEqual(first, turned)
        self.assertNotEqual(turned, nearer)
        self.assert_same(first, again)
        self.assertNotEqual(first, other)
        remembered = window.settings.read_text()
        self.assertIn("technique = 'cartoon_metal'", remembered.replace('"', "'"))
        self.assertIn("shows_panels = false", remembered)
        self.assertIn("teapot.obj", remembered)

    def test_keys_change_what_is_shown_and_change_it_back(self):
        window = self.open_window(MODELS / "teapot.obj", "-t", "cartoon")
        plain = window.shown()
        seen = [plain]
        keys = [("w", "w"), ("p", "p"), ("F1", "h"), ("F2", "F2"), ("Tab", "Tab"), ("q", "e"), ("plus", "minus")]
        for there, back in keys + [(digit, "Home") for digit in "1234567"]:
            with self.subTest(key=there):
                window.key(there)
                changed = window.shown()
                window.key(back)
                self.assertEqual(window.shown(), plain)
                self.assertNotIn(changed, seen)
                seen.append(changed)
        for shape in ("round", "square", "sphere"):
            with self.subTest(lens=shape):
                window.hold("m")
                lens = window.shown()
                window.let_go("m")
                window.key("shift+m")
                self.assertEqual(window.shown(), plain)
                self.assertNotIn(lens, seen)
                seen.append(lens)
        self.assert_closes(window)

    def test_the_first_picture_is_what_render_draws(self):
        """Without panels, for else the model is moved to where they leave it free."""
        self.write("viewer.toml", "shows_panels = false\n")
        window = self.open_window(MODELS / "teapot.obj", "-t", "cartoon")
        picture = window.picture()
        self.assert_closes(window)
        self.said("render", MODELS / "teapot.obj", "-t", "cartoon", "--size", f"{SIZE[0]}x{SIZE[1]}", "--samples", "4",
                  "--reference", picture, "--threshold", "0.05")

    def test_tuning(self):
        """A slider; its value in the copied command and the saved technique, which draw the same; files that change."""
        technique = self.write("mine.technique", "pass wireframe lines {} ;")
        window = self.open_window(MODELS / "teapot.obj", technique)
        before = self.picture(window)
        x, y = first_knob(window)
        window.drag((x, y), (x + 30, y))
        tuned = self.picture(window)
        self.assertNotEqual(before, tuned)

        window.key("ctrl+c")
        command = window.clipboard()
        width = re.search(r" --set lines\.width=(\S+) ", command)[1]
        self.assertNotEqual(float(width), 1)
        self.assert_same(self.by_command(command), tuned)
        window.key("ctrl+s")
        window.hold("Return")
        window.let_go("Return")
        saved = window.wait_for_file("my_mine.technique")
        self.assertRegex(saved.read_text(), rf"\bwidth {re.escape(width)} ;")
        command = command.replace(f" --set lines.width={width}", "").replace(str(technique), str(saved))
        self.assert_same(self.by_command(command), tuned)

        def draws(color):
            return colors(self.picture(window)).get(color, 0) > 100

        technique.write_text("pass wireframe lines { color 1 0 0 ; } ;")
        window.wait_until(lambda: draws((255, 0, 0)), "the changed file is drawn")
        window.key("ctrl+c")
        self.assertIn(f" --set lines.width={width} ", window.clipboard(), "what was tuned stays so")
        last_good = self.picture(window)
        technique.write_text("pass wireframe lines { colour 0 0 1 ; } ;")
        window.wait_until(lambda: tells_a_mistake(window), "the mistake is told")
        self.assert_same(self.picture(window), last_good)
        technique.write_text("pass wireframe lines { color 0 0 1 ; } ;")
        window.wait_until(lambda: draws((0, 0, 255)), "the mended file is drawn")
        self.assertFalse(tells_a_mistake(window))
        self.assert_closes(window)

    def test_files_are_dropped(self):
        """What is wrong is told, and ends nothing."""
        self.write("viewer.toml", "shows_panels = false\n")
        window = self.open_window(MODELS / "cube.obj", "-t", "phong")
        window.drop(self.write("board.obj", BOARD))
        window.wait_until(lambda: window.picture().name.startswith("board"), "the model that was dropped is shown")
        white = self.picture(window)
        window.drop(DATA / "textures" / "toon" / "two_tone.png")
        window.wait_until(lambda: self.picture(window) != white, "the texture is seen")
        window.drop(self.write("red here.technique", "pass wireframe lines { color 1 0 0 ; width 6 ; } ;"))
        window.wait_until(lambda: colors(self.picture(window)).get((255, 0, 0), 0) > 100, "the technique draws")
        window.key("ctrl+c")
        self.assertRegex(window.clipboard(), r" render \S*/board\.obj -t '\S*/red here\.technique' .* --texture ")
        good = self.picture(window)
        self.assert_same(self.by_command(window.clipboard()), good)
        wrong = {"broken.obj": "v 0 0 0\nf 1 2 x\n", "broken.technique": "pass nothing ;", "empty.obj": "",
                 "empty.png": "", "notes.txt": "hello", "folder.obj/file": ""}
        for name, text in wrong.items():
            with self.subTest(wrong=name):
                window.drop(self.folder / self.write(name, text).relative_to(self.folder).parts[0])
                window.wait_until(lambda: tells_a_mistake(window), f"{name} is told")
                self.assert_same(self.picture(window), good)
                window.drop(self.folder / "board.obj", self.folder / "red here.technique")
                window.wait_until(lambda: not tells_a_mistake(window), "good files end what was told")
        self.assert_closes(window)

    def test_sizes_and_focus(self):
        self.write("viewer.toml", "shows_panels = false\n")
        window = self.open_window(MODELS / "teapot.obj", "-t", "cartoon", screen=(5000, 500))
        shown, picture = window.shown(), self.picture(window)
        window.resize(1, 1)
        window.resize(*SIZE)
        self.assert_same(self.picture(window), picture)
        window.minimise()
        self.assertNotEqual(window.shown(), shown)
        window.restore()
        self.assert_same(self.picture(window), picture)
        window.hold("m")
        window.set_focus(False)
        window.key("w")  # goes nowhere
        window.set_focus(True)
        window.wait_until(lambda: window.shown() == shown, "neither the lens nor a wireframe is left")
        self.assert_same(self.picture(window), picture)
        window.let_go("m")
        window.resize(5000, SIZE[1])
        wide = self.picture(window)
        self.assertEqual(wide.size, (5000, SIZE[1]))
        window.key("ctrl+c")
        self.assert_same(self.by_command(window.clipboard()), wide)
        self.assert_closes(window)

    def test_doing_nothing_costs_nothing(self):
        """And what is told for a while goes by itself meanwhile."""
        window = self.open_window(MODELS / "teapot.obj", "-t", "cartoon")
        shown = window.shown()
        window.picture()
        before, begun = window.processor_seconds(), time.monotonic()
        self.assertNotEqual(window.shown(), shown, "that a picture was written is told")
        time.sleep(5)
        share = (window.processor_seconds() - before) / (time.monotonic() - begun)
        self.assertEqual(window.shown(), shown)
        self.assert_closes(window)
        self.assertLess(share, 0.02)

    def test_an_option_is_refused(self):
        self.refused("--ui-scale: expected a number from 0.5 to 4, found 50", "view", "--ui-scale", "50")
        self.refused("--ui-scale: expected a number from 0.5 to 4, found -1", "view", "--ui-scale", "-1")

    def test_a_display_is_asked_for_in_words(self):
        self.refused(re.compile(r"no window: .*; croquis render needs none"), "view", environment={"DISPLAY": ""})


if __name__ == "__main__":
    main()
