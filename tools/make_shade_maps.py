"""Make data/textures/shade: maps from light to the tones of comic shading.

Source: seeds A, 3.3 and 3.6.1 with its figures 22, 24 and 26. A map of one row stands for the
diffuse light N.L of 0 to 1 from left to right. A square map has the specular light (R.V)^n
from bottom to top beside it. Those called "shares" hold shares of light, not tones: there the
component makes the tones, and 0 is not black. The maps need clamping and must not be mipmapped.
"""

from make_toon_maps import METAL, grey, ramp
from shared import blend, smoothstep, write_png

WIDTH = 256
SIDE = 128


def bands(tones, edges):
    """Flat tones (numbers or colours); edges[i] is where tones[i] becomes tones[i + 1]."""

    def tone(diffuse):
        found = tones[sum(diffuse >= edge for edge in edges)]
        return found if isinstance(found, tuple) else grey(found)

    return tone


def with_highlight(diffuse_tone, colour, edge):
    """The tones of diffuse light, and one colour where specular light is above an edge."""

    def tone(diffuse, specular):
        return colour if specular >= edge else diffuse_tone(diffuse)

    return tone


def with_stripes(diffuse_tone, edges, highlight_edge, half_width):
    """Black stripes where two tones meet, and around the highlight (figure 26c)."""

    def tone(diffuse, specular):
        # The highlight's stripe is wider: specular light falls fast.
        if abs(specular - highlight_edge) < 2.5 * half_width:
            return grey(0.0)
        if specular >= highlight_edge:
            return grey(1.0)
        if any(abs(diffuse - edge) < half_width for edge in edges):
            return grey(0.0)
        return diffuse_tone(diffuse)

    return tone


def checkerboard(diffuse, specular):
    """Fields of light and dark by turns, lighter towards the light (figure 26d)."""
    # Large ones: on a body of many bulges smaller fields are noise.
    column, row = int(diffuse * 4), int(specular * 3)
    mean = 0.4 + 0.1 * column + 0.06 * row
    return grey(min(mean + 0.2, 1.0) if (column + row) % 2 == 1 else mean - 0.16)


def polished(diffuse, specular):
    """Bands of mirrored surroundings, which the highlight moves and outshines (figure 26e)."""
    mirrored = ramp(METAL)(diffuse, min(diffuse + 0.25 * specular, 1.0) * (WIDTH - 1))
    return blend(mirrored, grey(1.0), smoothstep(0.35, 0.6, specular))


def additive(diffuse, specular):
    """Red specular light and green diffuse light, together white (figure 24b)."""
    return (specular, diffuse, specular * diffuse)


def smooth(diffuse, specular):
    """Near to Phong's model: the surface's own colour at 0.7, white above."""
    return grey(min(0.2 + 0.5 * diffuse + 0.5 * specular, 1.0))


INDIGO, PLUM, CORAL, AMBER, CREAM = (
    (0.13, 0.12, 0.36),
    (0.45, 0.16, 0.44),
    (0.89, 0.36, 0.34),
    (0.99, 0.68, 0.32),
    (1.00, 0.95, 0.80),
)
NAVY, PAPER = (0.09, 0.20, 0.38), (0.98, 0.93, 0.82)
GREYS, GREY_EDGES = [0.34, 0.56, 0.76], [0.18, 0.55]

ROWS = {
    "two_shares": bands([0.0, 1.0], [0.35]),
    "three_shares": bands([0.0, 0.6, 1.0], [0.15, 0.5]),
    "duotone": bands([NAVY, PAPER], [0.38]),
}

SQUARES = {
    "flat_highlight": with_highlight(bands([0.55, 0.8], [0.3]), grey(1.0), 0.5),
    "banded": with_highlight(bands(GREYS, GREY_EDGES), grey(1.0), 0.3),
    "striped": with_stripes(bands(GREYS, GREY_EDGES), GREY_EDGES, 0.4, 0.018),
    "checker": checkerboard,
    "polished": polished,
    "additive": additive,
    "smooth": smooth,
    "sunset": with_highlight(bands([INDIGO, PLUM, CORAL, AMBER], [0.12, 0.36, 0.68]), CREAM, 0.5),
}


def centre(texel, texels):
    return (texel + 0.5) / texels


def make(out):
    folder = out / "textures" / "shade"
    for name, tone in ROWS.items():
        write_png(folder / f"{name}.png", [[tone(centre(x, WIDTH)) for x in range(WIDTH)]])
    for name, tone in SQUARES.items():
        rows = [
            [tone(centre(x, SIDE), centre(y, SIDE)) for x in range(SIDE)]
            for y in reversed(range(SIDE))
        ]
        write_png(folder / f"{name}.png", rows)
