#!/usr/bin/python3
"""Draw models in several techniques and lay the pictures out on one labelled sheet.

contact_sheet.py --croquis PROGRAM --model M [M ...] --techniques a,b,c|all --output SHEET.png
                 [--columns 4] [--cell 480x360] [-- further options of `croquis render`]

Needs Pillow and the DejaVu fonts (Debian: python3-pil, fonts-dejavu-core).
"""

import argparse
import concurrent.futures
import dataclasses
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
AT_ONCE = 2  # the software renderer already uses all cores within a frame
MARGIN = 24
FRAME_COLOUR = (214, 214, 214)
LABEL_COLOUR = (40, 40, 40)


@dataclasses.dataclass(frozen=True)
class Drawing:
    """One picture to draw, and what stands below it on a sheet."""

    label: str
    model: str
    technique: str
    options: tuple = ()


def size_of(text):
    """480x360 as two numbers."""
    try:
        width, height = (int(word) for word in text.lower().split("x"))
    except ValueError:
        raise argparse.ArgumentTypeError(f"expected WIDTHxHEIGHT, found {text}") from None
    if width < 1 or height < 1:
        raise argparse.ArgumentTypeError(f"expected WIDTHxHEIGHT, found {text}")
    return width, height


def technique_names(croquis):
    listing = subprocess.run([croquis, "list", "--json"], check=True, capture_output=True, text=True)
    return [technique["name"] for technique in json.loads(listing.stdout)["techniques"]]


def render(croquis, drawing, size, path):
    """Draws one picture. Returns the program's complaint, empty when all went well."""
    command = [croquis, "render", drawing.model, "--technique", drawing.technique]
    command += ["--size", "{}x{}".format(*size), "--samples", "4", "--output", str(path), *drawing.options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 0 and path.exists():
        return ""
    return done.stderr.strip() or f"{drawing.technique}: exit status {done.returncode} without a word"


def render_all(croquis, drawings, size, paths):
    """Draws several pictures, two at a time. Returns the complaints."""
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        complaints = pool.map(lambda job: render(croquis, job[0], size, job[1]), zip(drawings, paths))
        return [complaint for complaint in complaints if complaint]


def compose(labels, paths, columns, size, label_height=44):
    """The pictures in a grid on white, each in a thin frame with its label below. A missing one stays empty."""
    rows = math.ceil(len(paths) / columns)
    step = (size[0] + MARGIN, size[1] + label_height)
    sheet = Image.new("RGB", (columns * step[0] + MARGIN, rows * step[1] + MARGIN), "white")
    draw = ImageDraw.Draw(sheet)
    font = ImageFont.truetype(FONT, max(12, round(size[1] / 20)))
    for number, (label, path) in enumerate(zip(labels, paths)):
        left = MARGIN + number % columns * step[0]
        top = MARGIN + number // columns * step[1]
        if path.exists():
            with Image.open(path) as picture:
                sheet.paste(picture.convert("RGB"), (left, top))
        draw.rectangle((left - 1, top - 1, left + size[0], top + size[1]), outline=FRAME_COLOUR)
        draw.text((left + size[0] / 2, top + size[1] + 8), label, LABEL_COLOUR, font, anchor="ma")
    return sheet


def save_whole(picture, path):
    """Writes a PNG beside its name and renames it, so that it appears whole or not at all."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(path.name + ".part")
    picture.save(beside, format="PNG", optimize=True)
    beside.replace(path)


def make_sheet(croquis, drawings, columns, size, output):
    """Draws and lays out. Returns the complaints; the sheet is written all the same."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [pathlib.Path(folder) / f"{number}.png" for number in range(len(drawings))]
        complaints = render_all(croquis, drawings, size, paths)
        save_whole(compose([drawing.label for drawing in drawings], paths, columns, size), output)
    return complaints


def arguments():
    parser = argparse.ArgumentParser(description="Draw models in several techniques on one labelled sheet.",
                                     epilog="What follows -- goes to croquis render, --view front for one.")
    parser.add_argument("--croquis", required=True, help="the program")
    parser.add_argument("--model", required=True, nargs="+", help="model files")
    parser.add_argument("--techniques", default="all", help="names with commas between them, or all")
    parser.add_argument("--columns", type=int, default=4)
    parser.add_argument("--cell", type=size_of, default="480x360", help="size of each picture")
    parser.add_argument("--output", required=True, help="PNG to write")
    words, options = sys.argv[1:], []
    if "--" in words:
        options = words[words.index("--") + 1 :]
        words = words[: words.index("--")]
    return parser.parse_args(words), tuple(options)


def main():
    asked, options = arguments()
    names = technique_names(asked.croquis) if asked.techniques == "all" else asked.techniques.split(",")
    several = len(asked.model) > 1
    drawings = [
        Drawing(f"{pathlib.Path(model).stem}: {name}" if several else name, model, name, options)
        for model in asked.model
        for name in names
    ]
    complaints = make_sheet(asked.croquis, drawings, max(1, asked.columns), asked.cell, asked.output)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    print(asked.output)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
