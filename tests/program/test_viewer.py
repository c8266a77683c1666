"""croquis view in a real window: what a person does with mouse and keys, on a virtual display."""

import re
import shutil
import sys
import time
import unittest

from program import DATA, MODELS, PROGRAM, ProgramTest, main

sys.path.insert(0, str(DATA.parent / "tools"))
from virtual_window import VirtualWindow  # noqa: E402

SIZE = (900, 560)


@unittest.skipUnless(shutil.which("Xvfb") and shutil.which("xdotool"), "no virtual display here")
class WindowTest(ProgramTest):
    def open_window(self, *arguments):
        return VirtualWindow(PROGRAM, self.folder, SIZE, *arguments)

    def test_a_session(self):
        """Drag, keys, a click on another technique, pictures, and what is remembered at the end."""
        with self.open_window(MODELS / "teapot.obj", "-t", "cartoon") as window:
            window.wait_until_idle()
            window.key("F12")
            first = window.wait_for_file("teapot-1.png").read_bytes()
            window.drag((450, 280), (520, 220))
            window.wait_until_idle()
            window.key("F12")
            turned = window.wait_for_file("teapot-2.png").read_bytes()
            window.key("Home")
            window.key("F12")
            again = window.wait_for_file("teapot-3.png").read_bytes()
            window.key("Down")
            window.key("F12")
            other = window.wait_for_file("teapot-4.png").read_bytes()
            window.key("Tab")
            status, errors = window.close()
        self.assertEqual((status, errors), (0, ""))
        self.assertNotEqual(first, turned)
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)
        remembered = window.settings.read_text()
        self.assertIn("technique = 'cartoon_metal'", remembered.replace('"', "'"))
        self.assertIn("shows_panels = false", remembered)
        self.assertIn("teapot.obj", remembered)

    def test_the_first_picture_is_what_render_draws(self):
        """Without panels, for else the model is moved to where they leave it free."""
        self.write("viewer.toml", "shows_panels = false\n")
        with self.open_window(MODELS / "teapot.obj", "-t", "cartoon") as window:
            window.wait_until_idle()
            window.key("F12")
            window.wait_for_file("teapot-1.png")
            window.close()
        self.said("render", MODELS / "teapot.obj", "-t", "cartoon", "--size", f"{SIZE[0]}x{SIZE[1]}", "--samples", "4",
                  "--reference", "teapot-1.png", "--threshold", "0.05")

    def test_doing_nothing_costs_nothing(self):
        with self.open_window(MODELS / "teapot.obj", "-t", "cartoon") as window:
            window.wait_until_idle()
            before, begun = window.processor_seconds(), time.monotonic()
            time.sleep(4)
            share = (window.processor_seconds() - before) / (time.monotonic() - begun)
            window.close()
        self.assertLess(share, 0.02)

    def test_a_display_is_asked_for_in_words(self):
        self.refused(re.compile(r"no window: .*; croquis render needs none"), "view", environment={"DISPLAY": ""})


if __name__ == "__main__":
    main()
