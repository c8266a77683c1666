"""The pictures of docs/gallery, each drawn by the commands of the page that shows it. make_docs.py calls this.

A page's sh blocks are taken in order, in an empty folder with links to data/ and tools/. A picture FOLDER/NAME.png of the
page is what the command with -o NAME.svg or -o NAME.png drew: rasterised, cut to what is on it, in few colours. Of a
plotter file NAME.svg, NAME_way.png shows the way of the lifted pen too.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops, ImageStat

from contact_sheet import save_whole

ROOT = pathlib.Path(__file__).resolve().parent.parent
GALLERY = ROOT / "docs/gallery"

SHELL_BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"!\[[^\]]*\]\(([\w/-]+\.(?:png|jpg))\)")
OF_OTHER_MODELS = "styles.md"  # a page whose pictures make_style_sheets.py draws, of models that are not at hand here
PATH = re.compile(r'<path[^>]* d="([^"]*)"')
PATH_TOKEN = re.compile(r"[A-Za-z]|-?(?:\d+\.?\d*|\.\d+)")

PIXELS_A_MILLIMETRE = 7.0
MARGIN, STEP = 8, 16  # pixels left round a drawing
COLOURS = 24
MOST_DIFFERENCE = 0.5  # in the mean, of 255: another version of librsvg rounds edges differently


class GalleryError(Exception):
    """What is wrong with a page or its commands, in one line."""


# --- Drawing ---------------------------------------------------------------------------------


def commands_of(text):
    """The lines of the page's sh blocks, continued lines joined, comments left out."""
    blocks = (block.replace("\\\n", " ").splitlines() for block in SHELL_BLOCK.findall(text))
    return [shlex.split(line) for block in blocks for line in block if line.strip() and not line.startswith("#")]


def run(words, program, folder):
    if words[0] == "croquis":
        words = [str(pathlib.Path(program).resolve()), *words[1:]]
    elif words[0].startswith("tools/"):
        words = [sys.executable, "-B", *words]
    else:
        raise GalleryError(f"a line that is not run: {shlex.join(words)}")
    environment = os.environ | {"CROQUIS_DATA": str(ROOT / "data")}
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        raise GalleryError(f"{shlex.join(words)}: {done.stderr.strip()}")


def rasterised(svg, folder):
    png = folder / "rasterised.png"
    # A picture's pixels are 96 to the inch; more of them keep thin lines apart.
    subprocess.run(["rsvg-convert", "--dpi-x=96", "--dpi-y=96", "--background-color=white",
                    f"--zoom={PIXELS_A_MILLIMETRE * 25.4 / 96}", f"--output={png}", str(svg)], check=True)
    with Image.open(png) as picture:
        return picture.convert("RGB")


def trimmed(picture):
    """What is drawn on, with a margin. In steps, so that a line that moves by a hair does not change the size."""
    white = Image.new("RGB", picture.size, "white")
    left, top, right, bottom = ImageChops.difference(picture, white).getbbox() or (0, 0, *picture.size)
    low = [max(0, side // STEP * STEP - MARGIN) for side in (left, top)]
    high = [-(-side // STEP) * STEP + MARGIN for side in (right, bottom)]
    return picture.crop((*low, min(high[0], picture.width), min(high[1], picture.height)))


def in_few_colours(picture):
    """As a PNG keeps it small; greys where there is nothing else, evenly spaced."""
    channels = picture.split()
    if all(ImageChops.difference(channels[0], other).getbbox() is None for other in channels[1:]):
        return channels[0].point([round(round(level / 17) * 17) for level in range(256)])
    return picture.quantize(COLOURS, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)


def drawn_lines(path):
    """Where the pen is put down and lifted for each part of an SVG path of M, L, l, C, c and Z."""
    command, numbers, place, lines = "", [], (0.0, 0.0), []
    for token in PATH_TOKEN.findall(path):
        if token == "Z":
            lines[-1][1] = place = lines[-1][0]
        elif token.isalpha():
            command, numbers = token, []
        else:
            numbers.append(float(token))
            if len(numbers) < (6 if command in "Cc" else 2):
                continue
            origin = place if command.islower() else (0.0, 0.0)
            place = (origin[0] + numbers[-2], origin[1] + numbers[-1])
            if command == "M":
                lines.append([place, place])
            lines[-1][1] = place
            numbers = []
    return lines


def with_pen_way(svg):
    """A plotter file's text with the way of the lifted pen in red."""
    place, way = (0.0, 0.0), []
    for path in PATH.findall(svg):
        for start, end in drawn_lines(path):
            way.append(f"M{place[0]} {place[1]}L{start[0]} {start[1]}")
            place = end
    red = f'<path fill="none" stroke="#e03020" stroke-width="0.2" d="{"".join(way)}"/>'
    return svg.replace("</svg>", red + "</svg>")


def draw(name, folder):
    """A picture of the page from what its commands left in the folder."""
    stem = pathlib.Path(name).stem
    source = folder / f"{stem}.svg"
    plotted = folder / f"{stem.removesuffix('_way')}.svg"
    if (folder / f"{stem}.png").exists():
        with Image.open(folder / f"{stem}.png") as picture:
            return trimmed(picture.convert("RGB"))
    if source.exists():
        return trimmed(rasterised(source, folder))
    if plotted.exists():
        source.write_text(with_pen_way(plotted.read_text(encoding="utf-8")), encoding="utf-8")
        return trimmed(rasterised(source, folder))
    raise GalleryError(f"no command draws {name}")


def pictures_of(page, program):
    """The page's pictures by their names, drawn anew."""
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory(prefix="croquis-gallery-") as name:
        folder = pathlib.Path(name)
        for link in ("data", "tools"):
            (folder / link).symlink_to(ROOT / link)
        try:
            for words in commands_of(text):
                run(words, program, folder)
            return {picture: in_few_colours(draw(picture, folder)) for picture in PICTURE.findall(text)}
        except GalleryError as error:
            raise GalleryError(f"{page.relative_to(ROOT)}: {error}") from None


# --- What make_docs.py asks for --------------------------------------------------------------


def drawn_pages():
    return [page for page in sorted(GALLERY.glob("*.md")) if page.name != OF_OTHER_MODELS]


def write(program):
    for page in drawn_pages():
        for name, picture in pictures_of(page, program).items():
            save_whole(picture, page.parent / name)


def differs(picture, path):
    with Image.open(path) as shown:
        if picture.size != shown.size:
            return True
        difference = ImageChops.difference(picture.convert("RGB"), shown.convert("RGB"))
    return sum(ImageStat.Stat(difference).mean) / 3 > MOST_DIFFERENCE


def check(program):
    """What is out of date."""
    sheets = GALLERY / OF_OTHER_MODELS
    complaints, shown = [], {GALLERY / name for name in PICTURE.findall(sheets.read_text(encoding="utf-8"))}
    for page in drawn_pages():
        try:
            drawn = pictures_of(page, program)
        except GalleryError as error:
            complaints.append(str(error))
            continue
        for name, picture in drawn.items():
            path = page.parent / name
            shown.add(path)
            if not path.exists() or differs(picture, path):
                complaints.append(f"{path}: not what the page's commands draw; run make docs")
    found = set(GALLERY.glob("*/*"))
    return complaints + [f"{path}: no page shows it" for path in sorted(found - shown)]
