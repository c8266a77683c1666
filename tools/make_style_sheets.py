#!/usr/bin/python3
"""Make the contact sheets of docs/gallery/styles.md: every surface style on five models.

make_style_sheets.py --croquis PROGRAM --models FOLDER

FOLDER holds spot.obj, rocker-arm.obj and stanford-bunny.obj, which are not part of Croquis: they are the models of these
names that papers use. The MD2 and the glTF model come from Debian's assimp-testmodels.
"""

import argparse
import pathlib
import sys
import tempfile

from contact_sheet import Drawing, compose, render_all, technique_names

SHEETS = pathlib.Path(__file__).resolve().parent.parent / "docs/gallery/styles"
SAMPLES = pathlib.Path("/usr/share/assimp/models")
CELL, COLUMNS = (480, 400), 4
STYLES = ("comic", "cel", "cartoon_soft", "outline", "hidden_line", "edges_plane", "hatching")

MODELS = {
    "spot": ("spot.obj", ("--view=-0.9,0.35,-1",)),
    "rocker-arm": ("rocker-arm.obj", ()),
    "bunny": ("stanford-bunny.obj", ("--view=0.2,0.3,1",)),
    "faerie": (SAMPLES / "MD2/faerie.md2", ("--texture", str(SAMPLES / "MD2/faerie2.bmp"), "--view=0.7,0.2,1")),
    "engine": (SAMPLES / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", ("--view=1,0.6,0.8",)),
}


def styles(program):
    """The techniques shown: all whose names begin with one of STYLES, but for parts that others include."""
    return [name for name in technique_names(program) if name.startswith(STYLES) and not name.endswith("_lines")] + [
        "outline_lines"
    ]


def main():
    parser = argparse.ArgumentParser(description="Make the contact sheets of docs/gallery/styles.md.")
    parser.add_argument("--croquis", required=True, help="the program")
    parser.add_argument("--models", required=True, type=pathlib.Path, help="folder with spot, rocker-arm, stanford-bunny")
    arguments = parser.parse_args()
    names = sorted(styles(arguments.croquis))
    SHEETS.mkdir(exist_ok=True)
    for sheet, (model, options) in MODELS.items():
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / f"{name}.png" for name in names]
            drawings = [Drawing(name, str(arguments.models / model), name, options) for name in names]
            complaints = render_all(arguments.croquis, drawings, CELL, paths)
            if complaints:
                sys.exit("make_style_sheets: " + "\n".join(complaints))
            compose(names, paths, COLUMNS, CELL).save(SHEETS / f"{sheet}.jpg", quality=85, optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
