#!/usr/bin/python3
"""Make the generated pages and the pictures of docs/ from what the program says of itself.

make_docs.py --croquis PROGRAM          write docs/techniques.md, docs/pictures/ and the pictures of docs/gallery/
make_docs.py --croquis PROGRAM --check  compare the page and the gallery with what is there, look that each picture that
                                        a page shows exists and that no other does; name what differs and exit 1
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

import make_gallery
from contact_sheet import Drawing, render_all, save_whole, size_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
PICTURES = DOCS / "pictures"
CELL = size_of("480x360")

# What shows a technique best: its model in data/models and options of `croquis render`.
STILL_LIFE = ("scene", ("--eye=0.9,2.6,4.6", "--target=0,0.7,0", "--fov=34"))
MACHINE_PART = ("bearing", ("--view=0.75,0.6,1", "--fov=25", "--set", "lines.crease_angle=35"))
SHOWN_WITH = {
    "cartoon_metal": ("teapot", ()),
    "flat": ("torus_knot", ("--view=0.4,0.5,1",)),
    "metallic": ("teapot", ()),
    "normals": ("torus_knot", ("--view=0.4,0.5,1",)),
    "technical": MACHINE_PART,
    "white_creases": MACHINE_PART,
    "wireframe": ("torus_knot", ("--view=0.4,0.5,1",)),
}

# The README's picture: one view in three techniques, each over a slanted share of the width.
WIDE = (1600, 640)
WIDE_VIEW = ("--eye=0.2,2.1,5.2", "--target=-0.05,1.12,0", "--fov=38", "--background=paper:watercolour")
WIDE_TECHNIQUES = ("hatching_ink", "comic", "phong")
WIDE_CUTS = (0.37, 0.62)  # where the slanted cuts cross the middle, as shares of the width
SLANT = 90  # pixels from top to bottom


class Program:
    """What the program says of itself."""

    def __init__(self, path):
        self.path = path

    def ask(self, *words):
        done = subprocess.run([self.path, *words, "--json"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"make_docs: {' '.join(words)}: {done.stderr.strip()}")
        return json.loads(done.stdout)

    def catalogue(self):
        """All techniques and all components, in full."""
        listing = self.ask("list")
        techniques = [self.ask("describe", entry["name"]) for entry in listing["techniques"]]
        components = [self.ask("describe", entry["name"], "--component") for entry in listing["components"]]
        return techniques, components


# --- Text ------------------------------------------------------------------------------------


def plain(value):
    """A value as technique files have it, but text without its quotes."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return " ".join(plain(number) for number in value)
    return str(value)


def code(value):
    text = plain(value)
    return f"`{text}`" if text else "empty"


def limit(value):
    """An end of a range: one number where all of a vector's are alike."""
    if isinstance(value, list) and len(set(value)) == 1:
        value = value[0]
    return plain(value)


def range_of(variable):
    if "choices" in variable:
        return ", ".join(variable["choices"])
    low, high = variable.get("minimum"), variable.get("maximum")
    if low is not None and high is not None:
        return f"{limit(low)} to {limit(high)}"
    if low is not None:
        return f"from {limit(low)}"
    return f"to {limit(high)}" if high is not None else ""


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ").replace("*", "\\*").replace("<", "&lt;")


def table(headings, rows):
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def variable_row(variable, value):
    return [
        f"`{variable['name']}`",
        variable["type"],
        value,
        cell(range_of(variable)),
        cell(variable.get("unit", "")),
        cell(variable["help"]),
    ]


def pass_text(described, common):
    """A pass: its component and the variables that a person may set."""
    rows = [
        variable_row(variable, code(variable["value"]))
        for variable in described["variables"]
        if not (variable["internal"] or variable["read_only"])
        and (variable["name"] not in common or variable["value"] != variable.get("default"))
    ]
    name, component = described["name"], described["component"]
    heading = f"Pass `{name}`: [{component}](#{component})\n"
    if not rows:
        return heading
    return heading + "\n" + table(["variable", "type", "value", "range", "unit", "meaning"], rows)


def technique_text(technique, common):
    name = technique["name"]
    parts = [f"### {name}\n", f"{cell(technique['help'])}\n", f"![{name}](pictures/{name}.png)\n"]
    parts += [pass_text(described, common) for described in technique["passes"]]
    return "\n".join(parts)


def when_set(variable):
    return "at the start" if variable["internal"] or variable["read_only"] else "any time"


def component_text(component, by_name, common):
    """A component: what it adds to or changes of the one it inherits from."""
    parent = by_name.get(component.get("inherits"), {"variables": list(common.values())})
    inherited = {variable["name"]: variable for variable in parent["variables"]}
    rows = [
        [*variable_row(variable, code(variable["default"]) if "default" in variable else "must be set"),
         when_set(variable)]
        for variable in component["variables"]
        if inherited.get(variable["name"]) != variable
    ]
    parts = [f"### {component['name']}\n", f"{cell(component['help'])}\n"]
    if "inherits" in component:
        parts.append(f"Inherits from [{component['inherits']}](#{component['inherits']}).\n")
    if rows:
        parts.append(table(["variable", "type", "default", "range", "unit", "meaning", "changes"], rows))
    return "\n".join(parts)


def page(techniques, components, common):
    by_name = {component["name"]: component for component in components}
    index = [[f"[{t['name']}](#{t['name']})", cell(t["help"])] for t in techniques]
    common_rows = [variable_row(variable, code(variable["default"])) for variable in common.values()]
    parts = [
        "# Techniques and components\n",
        "Made by `make docs` from the descriptors and techniques in `data/`: change those, not this page.\n\n"
        "Each variable below can be changed with `--set PASS.VARIABLE=VALUE`, or in a technique file of your own: see\n"
        "[writing-techniques.md](writing-techniques.md).\n",
        table(["technique", "what it draws"], index),
        "## Variables of every pass\n",
        table(["variable", "type", "default", "range", "unit", "meaning"], common_rows),
        "## Techniques\n",
        *(technique_text(technique, common) for technique in techniques),
        "## Components\n",
        "The kinds of pass. A derived component is listed with what it changes. Variables that change *at the start* are\n"
        "fixed once a technique is open: a technique file or `--set` gives them.\n",
        *(component_text(component, by_name, common) for component in components),
    ]
    return "\n".join(parts)


# --- Pictures --------------------------------------------------------------------------------


def model_path(name):
    return str(ROOT / "data/models" / f"{name}.obj")


def draw(program, drawings, size, folder):
    paths = [folder / f"{number}.png" for number in range(len(drawings))]
    complaints = render_all(program.path, drawings, size, paths)
    if complaints:
        sys.exit("make_docs: " + "\n".join(complaints))
    pictures = []
    for path in paths:
        with Image.open(path) as picture:
            pictures.append(picture.convert("RGB"))
    return pictures


def draw_techniques(program, names, folder):
    drawings = []
    for name in names:
        model, options = SHOWN_WITH.get(name, STILL_LIFE)
        drawings.append(Drawing(name, model_path(model), name, options))
    for name, picture in zip(names, draw(program, drawings, CELL, folder)):
        save_whole(picture, PICTURES / f"{name}.png")


def draw_wide(program, folder):
    drawings = [Drawing(name, model_path("scene"), name, WIDE_VIEW) for name in WIDE_TECHNIQUES]
    first, *others = draw(program, drawings, WIDE, folder)
    width, height = WIDE
    for share, picture in zip(WIDE_CUTS, others):
        middle = share * width
        top, bottom = (middle + SLANT / 2, 0), (middle - SLANT / 2, height)
        right_of_cut = Image.new("L", WIDE, 0)
        ImageDraw.Draw(right_of_cut).polygon([top, (width, 0), (width, height), bottom], fill=255)
        first.paste(picture, (0, 0), right_of_cut)
        ImageDraw.Draw(first).line([top, bottom], fill="white", width=6)
    save_whole(first, PICTURES / "croquis.png")


# --- What is asked ---------------------------------------------------------------------------


def shown_pictures(generated):
    """The pictures of docs/pictures that README.md and the pages show."""
    pages = [path.read_text(encoding="utf-8") for path in [ROOT / "README.md", *DOCS.glob("*.md")]]
    return {name for text in [*pages, generated] for name in re.findall(r"\]\((?:docs/)?pictures/([^)]+)\)", text)}


def check(text):
    """What is out of date."""
    complaints = []
    path = DOCS / "techniques.md"
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        complaints.append(f"{path}: differs from what the descriptors say; run make docs")
    shown, found = shown_pictures(text), {picture.name for picture in PICTURES.glob("*")}
    complaints += [f"{PICTURES / name}: no such picture; run make docs" for name in sorted(shown - found)]
    complaints += [f"{PICTURES / name}: no page shows it" for name in sorted(found - shown)]
    return complaints


def write(program, text, names):
    with tempfile.TemporaryDirectory() as folder:
        draw_techniques(program, names, pathlib.Path(folder))
        draw_wide(program, pathlib.Path(folder))
    try:
        make_gallery.write(program.path)
    except make_gallery.GalleryError as error:
        sys.exit(f"make_docs: {error}")
    (DOCS / "techniques.md").write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description="Make the generated pages and pictures of docs/.")
    parser.add_argument("--croquis", required=True, help="the program")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when something is out of date")
    asked = parser.parse_args()

    program = Program(asked.croquis)
    techniques, components = program.catalogue()
    common = {variable["name"]: variable for variable in program.ask("describe", "every_component")["variables"]}
    text = page(techniques, components, common)
    if not asked.check:
        write(program, text, [technique["name"] for technique in techniques])
        return 0
    complaints = check(text) + make_gallery.check(program.path)
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
