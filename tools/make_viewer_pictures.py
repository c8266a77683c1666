#!/usr/bin/python3
"""Make the pictures of docs/viewer.md: the viewer's window on a virtual display, driven as the page tells.

make_viewer_pictures.py --croquis PROGRAM [--model FILE]    write docs/pictures/viewer_*.png
"""

import argparse
import pathlib
import tempfile

from virtual_window import VirtualWindow

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs" / "pictures"
SIZE = (1280, 720)


def save(window, name):
    """The window as an indexed picture: a third of the bytes, and no difference to be seen."""
    window.shown().quantize(128, dither=0).save(PICTURES / f"viewer_{name}.png", optimize=True)


def make_pictures(program, model, folder):
    """The page's pictures, in its order."""
    with VirtualWindow(program, folder, SIZE, model, "--technique", "cartoon") as window:
        window.wait_until_idle()
        save(window, "window")
        window.drag((640, 400), (760, 340))
        window.wait_until_idle()
        save(window, "turned")
        window.move(580, 450)
        window.hold("m")
        window.wait_until_idle()
        save(window, "magnifier")
        window.let_go("m")
        window.key("F1")
        window.wait_until_idle()
        save(window, "help")
        window.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--croquis", required=True, type=pathlib.Path)
    parser.add_argument("--model", type=pathlib.Path, default=ROOT / "data" / "models" / "scene.obj")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        make_pictures(arguments.croquis.resolve(), arguments.model.resolve(), folder)


if __name__ == "__main__":
    main()
