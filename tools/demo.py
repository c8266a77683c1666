#!/usr/bin/python3
"""Draw a real model in every technique, on one sheet: demo.py --croquis PROGRAM --output FOLDER

The model is a two-cylinder engine of Debian's assimp-testmodels; without that package, the teapot of data/models.
"""

import argparse
import pathlib
import subprocess
import sys

from PIL import Image

from contact_sheet import Drawing, make_sheet, technique_names

ENGINE = pathlib.Path("/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb")
TEAPOT = pathlib.Path(__file__).resolve().parent.parent / "data/models/teapot.obj"
# The side with the gears: the eye behind, above and to the right.
ENGINE_VIEW = ("--view=0.5,0.6,-1",)
COLUMNS = 6
CELL = (480, 360)


def arguments():
    parser = argparse.ArgumentParser(description="Draw a real model in every technique, on one sheet.")
    parser.add_argument("--croquis", required=True, help="the program")
    parser.add_argument("--output", required=True, type=pathlib.Path, help="folder for the sheet")
    return parser.parse_args()


def model_and_options():
    if ENGINE.exists():
        return ENGINE, ENGINE_VIEW
    print("Debian's assimp-testmodels is not installed: drawing the built-in teapot instead.")
    return TEAPOT, ()


def main():
    asked = arguments()
    model, options = model_and_options()
    try:
        names = technique_names(asked.croquis)
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"demo: {asked.croquis} does not run: {error}")
    print(f"Drawing {model.name} in {len(names)} techniques.", flush=True)
    sheet = asked.output / "techniques.png"
    drawings = [Drawing(name, str(model), name, options) for name in names]
    complaints = make_sheet(asked.croquis, drawings, COLUMNS, CELL, sheet)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    if complaints:
        print(f"{len(complaints)} of {len(names)} techniques failed.")
    with Image.open(sheet) as picture:
        print(f"{sheet} ({picture.width} x {picture.height} pixels)")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
