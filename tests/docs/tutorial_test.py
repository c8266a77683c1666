#!/usr/bin/python3
"""Follow docs/tutorial-component.md to the letter, in a copy of the sources, and look at what it draws.

tutorial_test.py SOURCES FOLDER [--update]: copies the sources into FOLDER (only what changed since the last time), puts
the page's blocks into their files, builds the program and the page's test there, and runs both. Objects that another
build of the same sources made come from ccache: CCACHE_BASEDIR makes the two trees look alike. --update writes the page's
picture instead of comparing with it.
"""

import collections
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

from PIL import Image, ImageChops, ImageStat

from markdown import blocks, commands

PAGE = "docs/tutorial-component.md"
COPIED = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "apps", "bench", "cmake", "data", "include", "src",
          "tests", "docs", "tools")
PICTURE = "docs/pictures/tutorial.png"
MOST_DIFFERENCE = 0.5  # in the mean, of 255: drivers round edges differently
PRESET_FOLDER = "build/release"  # where the page's reader builds, and as deep as any other build
FILE_LANGUAGES = {"component", "glsl", "cpp", "technique", "cmake"}


# --- The copy ----------------------------------------------------------------------------------


def apply(tree, block):
    """Puts a block into its file of `tree`, a dictionary from names to contents."""
    if block.at_end:
        tree[block.file] += block.text.encode()
    elif block.after:
        lines = tree[block.file].decode().split("\n")
        places = [number for number, line in enumerate(lines) if line.strip() == block.after]
        if len(places) != 1:
            sys.exit(f"{PAGE}:{block.line}: {block.file} has {len(places)} lines {block.after}")
        lines[places[0] + 1 : places[0] + 1] = block.text.rstrip("\n").split("\n")
        tree[block.file] = "\n".join(lines).encode()
    else:
        if block.file in tree:
            sys.exit(f"{PAGE}:{block.line}: {block.file} exists already")
        tree[block.file] = block.text.encode()


def sources(root):
    """All files of the copy by name."""
    paths = [root / name for name in COPIED]
    paths += [path for folder in paths for path in folder.rglob("*")]
    return {str(path.relative_to(root)): path.read_bytes() for path in paths
            if path.is_file() and "__pycache__" not in path.parts}


def write_changed(tree, folder):
    """Writes what differs, so that the next build makes only that anew, and removes what is gone."""
    for name, content in tree.items():
        path = folder / name
        if path.exists() and path.read_bytes() == content:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    for name in COPIED:
        for path in (folder / name).rglob("*"):
            if path.is_file() and str(path.relative_to(folder)) not in tree:
                path.unlink()


# --- Building and running ----------------------------------------------------------------------


def run(command, folder, **variables):
    environment = {name: value for name, value in os.environ.items() if name != "CROQUIS_DATA"} | variables
    done = subprocess.run(command, cwd=folder, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(map(str, command))}: exit status {done.returncode}\n{done.stdout[-4000:]}")
    return done.stdout


def build(folder):
    output = folder / PRESET_FOLDER
    if not (output / "build.ninja").exists():
        run(["cmake", "--preset", "release"], folder)
    run(["cmake", "--build", str(output), "--target", "croquis_program", "test_echoes"], folder,
        CCACHE_BASEDIR=str(folder))


def run_page(page, folder):
    """Runs the page's commands where it says that one stands: in the root of the sources."""
    for block in page:
        for line in commands(block) if block.language == "sh" and block.is_run else []:
            words = shlex.split(line)
            if words[0] != "croquis":
                sys.exit(f"{PAGE}:{block.line}: a line that no test runs: {line}")
            run([folder / PRESET_FOLDER / "croquis", *words[1:]], folder)


# --- What the page says of its pictures --------------------------------------------------------


def drawn(path):
    """The box of what is not white: left, top, right, bottom."""
    with Image.open(path) as picture:
        rgb = picture.convert("RGB")
    return Image.eval(rgb, lambda level: 255 - level).getbbox(), rgb


def check_pictures(folder):
    plain, _ = drawn(folder / "cartoon.png")
    speed, picture = drawn(folder / "speed.png")
    upwards, _ = drawn(folder / "upwards.png")
    assert speed[0] < plain[0] - 20, "the copies trail to the left"
    assert abs(speed[2] - plain[2]) <= 2 and abs(speed[1] - plain[1]) <= 2, "and nowhere else"
    assert upwards[1] < plain[1] - 20 and upwards[2] > plain[2] + 10, "other steps go up and to the right"

    # Left of the cartoon there is nothing but the copies, and their blue comes in at least as many tones.
    strip = [picture.getpixel((x, y)) for x in range(speed[0], plain[0]) for y in range(picture.height)]
    tones = collections.Counter(pixel for pixel in strip if pixel != (255, 255, 255))
    assert all(red <= green <= blue for red, green, blue in tones), "the copies are bluish"
    flat = [tone for tone, pixels in tones.items() if pixels > 100]
    assert len(flat) >= 5, f"five copies, each fainter than the last: found the tones {flat}"


def check_page_picture(drawn_now, on_page):
    """The page shows what its commands draw."""
    with Image.open(drawn_now) as now, Image.open(on_page) as shown:
        assert now.size == shown.size, f"{PICTURE} has another size: run {pathlib.Path(__file__).name} --update"
        difference = ImageChops.difference(now.convert("RGB"), shown.convert("RGB"))
    mean = sum(ImageStat.Stat(difference).mean) / 3
    assert mean <= MOST_DIFFERENCE, f"{PICTURE} differs by {mean:.2f}: run {pathlib.Path(__file__).name} --update"


def main():
    root, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    page = blocks((root / PAGE).read_text(encoding="utf-8"))
    tree = sources(root)
    for block in page:
        if block.language in FILE_LANGUAGES:
            apply(tree, block)
    write_changed(tree, folder)
    build(folder)
    run_page(page, folder)
    for gl in ("gl", "gles"):
        test = folder / PRESET_FOLDER / "tests/components/test_echoes"
        run([test], folder, CROQUIS_GL=gl, CROQUIS_DATA=str(folder / "data"))
    check_pictures(folder)
    if "--update" in sys.argv:
        shutil.copyfile(folder / "speed.png", root / PICTURE)
    check_page_picture(folder / "speed.png", root / PICTURE)


if __name__ == "__main__":
    main()
