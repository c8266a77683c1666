#!/usr/bin/env python3
"""Redo the speed tables of seeds A and B: their figures beside ours, as Markdown.

paper_tables.py --croquis PROGRAM [--model FILE] [--seconds S]

Each table is measured by one run of `croquis bench`, on copies of the model with as many triangles as the paper's objects.
Frames a second are of different machines: what compares is each renderer's share of the speed of the paper's default or base
rendering. Columns of techniques that the program does not have are left out, with a note on standard error.
"""

import argparse
import json
import pathlib
import subprocess
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent

TEXTURE = ROOT / "data/textures/paper/watercolour.png"
DEER = (578, 870, 1284, 2162, 5488, 10648)  # faces of seed A's objects, its table 3


class Column(NamedTuple):
    """One renderer of a paper: what it calls it, our technique, its frames a second for each number of faces."""

    paper_name: str
    technique: str
    fps: tuple
    is_textured: bool = False  # drawn with an image on the model: a run of its own


class Table(NamedTuple):
    """A table of a paper. The first column is what the others are compared with."""

    title: str
    faces: tuple
    columns: list


TABLES = [
    Table("Seed A, table 12: comic renderers against the default renderer", DEER, [
        Column("Default", "phong", (530, 508, 480, 435, 282, 170)),
        Column("Default, textured", "phong", (481, 443, 426, 400, 275, 167), is_textured=True),
        Column("Standard comic", "comic", (454.04, 347.35, 255.62, 175.22, 76.63, 41.01)),
        Column("Extended comic", "comic_extended", (412.1, 324.17, 248.29, 168.92, 76.74, 41.85)),
    ]),
    Table("Seed A, table 11: extended comic with a coloured silhouette, and with a base texture", DEER, [
        Column("Extended comic", "comic_extended", (412.10, 324.17, 248.29, 168.92, 76.74, 41.85)),
        Column("Coloured silhouette", "comic_coloured", (406.33, 317.04, 242.04, 164.82, 75.09, 41.07)),
        Column("With base texture", "comic_extended", (314.12, 264.01, 199.72, 135.21, 57.69, 31.04), is_textured=True),
    ]),
    # Figure 54 is a plot: the text alone gives its range, 30 to 270 frames a second.
    Table("Seed A, figure 54: hatching by vertex transparency and by multi-texturing", DEER, [
        Column("Default", "phong", (530, 508, 480, 435, 282, 170)),
        Column("Vertex transparency", "hatching_vertex", (270, None, None, None, None, 30)),
        Column("Multi-texturing", "hatching_projective", (270, None, None, None, None, 30)),
    ]),
    Table("Seed B, table 4.1", (1224, 5000), [
        Column("Base rendering", "base", (60, 49)),
        Column("Outlining with the stencil buffer", "outline_stencil", (54, 41)),
        Column("Outlining using front-face culling", "outline_front_face", (57, 43)),
        Column("Gouraud shading", "gouraud", (59, 48)),
        Column("Cel shading", "cel", (57, 46)),
        Column("'Simple' crosshatch shading", "hatching_simple", (50, 36)),
        Column("'Fine' crosshatch shading", "hatching_fine", (24, 12)),
    ]),
]


def arguments():
    parser = argparse.ArgumentParser(description="Redo the speed tables of seeds A and B.")
    parser.add_argument("--croquis", required=True, help="the program")
    parser.add_argument("--model", default=ROOT / "data/models/torus_knot.obj", type=pathlib.Path,
                        help="of at least 2,662 triangles, which are subdivided; a torus knot where none is named")
    parser.add_argument("--seconds", default="1", help="of measuring for each technique and size")
    return parser.parse_args()


def known_techniques(program):
    done = subprocess.run([program, "list", "--json"], check=True, capture_output=True, text=True)
    return {technique["name"] for technique in json.loads(done.stdout)["techniques"]}


def measure(asked, faces, columns):
    """Our frames a second: {column: [one for each number of faces]}."""
    techniques = ",".join(dict.fromkeys(column.technique for column in columns))
    command = [asked.croquis, "bench", asked.model, "--techniques", techniques, "--seconds", asked.seconds,
               "--subdivide", "1", "--triangles", ",".join(map(str, faces)), "--json", "-"]
    if columns[0].is_textured:
        command += ["--texture", TEXTURE]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"paper_tables: {done.stderr.strip()}")
    levels = [{one["technique"]: one["fps"] for one in level["techniques"]} for level in json.loads(done.stdout)["levels"]]
    return {column: [level[column.technique] for level in levels] for column in columns}


def cell(value, form):
    return "" if value is None else format(value, form)


def share(value, whole):
    return None if value is None else value / whole


def markdown(table, columns, ours):
    """A row a renderer and number of faces: theirs and ours, in frames a second and as a share of the first column."""
    first = columns[0]
    lines = [f"### {table.title}", "",
             f"| | faces | fps there | fps here | share of *{first.paper_name}* there | here |",
             "|---|---:|---:|---:|---:|---:|"]
    for column in columns:
        for i, faces in enumerate(table.faces):
            mine = ours[column][i]
            lines.append("| " + " | ".join([
                f"{column.paper_name} (`{column.technique}`)" if i == 0 else "",
                f"{faces:,}",
                cell(column.fps[i], "g"),
                cell(mine, ".0f"),
                cell(share(column.fps[i], first.fps[i]), ".2f"),
                cell(mine / ours[first][i], ".2f"),
            ]) + " |")
    return "\n".join(lines) + "\n"


def main():
    asked = arguments()
    known = known_techniques(asked.croquis)
    for table in TABLES:
        columns = [column for column in table.columns if column.technique in known]
        for column in table.columns:
            if column not in columns:
                print(f"{table.title}: no technique {column.technique}: left out", file=sys.stderr)
        if len(columns) < 2:
            continue
        ours = {}
        for is_textured in (False, True):
            alike = [column for column in columns if column.is_textured == is_textured]
            if alike:
                ours |= measure(asked, table.faces, alike)
        print(markdown(table, columns, ours))


if __name__ == "__main__":
    main()
