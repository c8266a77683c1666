#!/usr/bin/env python3
"""Make everything in data/ that is made: textures, sample models and computed strokes.

make_data.py [OUT]   write into OUT, or into data/ beside this folder
make_data.py --check compare with what is there; name what differs and exit 1

Plain Python 3, no packages. The same Python and zlib write the same bytes again; --check
compares pictures by their pixels, since another zlib may pack them otherwise.
"""

import argparse
import pathlib
import sys
import tempfile

import make_hatching
import make_images
import make_models
import make_papers
import make_shade_maps
import make_strokes
import make_toon_maps
from shared import read_png

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
SCRIPTS = (make_toon_maps, make_shade_maps, make_images, make_papers, make_strokes, make_hatching, make_models)


def make(out):
    for script in SCRIPTS:
        script.make(out)


def same(first, second):
    if not second.is_file():
        return False
    if first.read_bytes() == second.read_bytes():
        return True
    return first.suffix == ".png" and read_png(first) == read_png(second)


def different_files(out):
    """The made files that 'out' lacks or holds otherwise."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = pathlib.Path(folder)
        make(fresh)
        files = sorted(path.relative_to(fresh) for path in fresh.rglob("*") if path.is_file())
        return [path for path in files if not same(fresh / path, out / path)]


def main():
    parser = argparse.ArgumentParser(description="Make the shipped textures and sample models.")
    parser.add_argument("out", nargs="?", type=pathlib.Path, default=DATA)
    parser.add_argument("--check", action="store_true", help="compare only; exit 1 if files differ")
    arguments = parser.parse_args()
    if not arguments.check:
        make(arguments.out)
        return 0
    different = different_files(arguments.out)
    for path in different:
        print(f"{arguments.out / path}: differs from what tools/make_data.py makes")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
