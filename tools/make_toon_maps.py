"""Make data/textures/toon: maps from light intensity to the tone that is painted.

Source: seeds C, section 4.2. A map is a picture of 256 x 1 texels. Texel k stands for the
intensity I from k/256 to (k + 1)/256 of equation 4.4, I = diffuse + specular; what is above 1
is clamped to the right end. Diffuse light alone reaches 1 only where a surface faces the
light exactly, so a highlight is the LAST texel and nothing else: a shiny surface shows it
where diffuse and specular light together exceed 1, a matte one has at most a speck. Read
with the coordinate I * 255/256, the last texel means I > 1 and the speck is gone too.
The maps need clamping and must not be mipmapped.
"""

import colorsys

from shared import blend, smoothstep, write_png

WIDTH = 256


def grey(value):
    return (value, value, value)


def steps(tones, edges, highlight=None):
    """Flat tones; edges[i] is the intensity where tones[i] becomes tones[i + 1]."""

    def tone(intensity, texel):
        if highlight is not None and texel == WIDTH - 1:
            return grey(highlight)
        return grey(tones[sum(intensity >= edge for edge in edges)])

    return tone


def soft_steps(tones, edges, highlight, half_width):
    """The same with a smooth ramp at each edge; the highlight takes the last four texels."""

    def tone(intensity, texel):
        value = tones[0]
        for edge, low, high in zip(edges, tones, tones[1:]):
            value += (high - low) * smoothstep(edge - half_width, edge + half_width, intensity)
        value += (highlight - tones[-1]) * smoothstep(WIDTH - 5, WIDTH - 1, texel)
        return grey(value)

    return tone


def ramp(keys):
    """Smooth transitions between (intensity, colour) keys."""

    def tone(intensity, texel):
        position = texel / (WIDTH - 1)
        for (start, first), (end, second) in zip(keys, keys[1:]):
            if position <= end:
                return blend(first, second, smoothstep(start, end, position))
        return keys[-1][1]

    return tone


def line(first, last):
    return lambda intensity, texel: blend(first, last, texel / (WIDTH - 1))


def spectrum(intensity, texel):
    """Red over yellow, green and blue to violet: hue 0 to 280 degrees."""
    return colorsys.hsv_to_rgb(280 / 360 * texel / (WIDTH - 1), 0.9, 1.0)


# Bands of a polished surface that mirrors floor, horizon and sky (figure 4.4).
METAL = [
    (0.00, (0.16, 0.17, 0.20)),
    (0.14, (0.46, 0.47, 0.50)),
    (0.26, (0.24, 0.25, 0.29)),
    (0.44, (0.84, 0.86, 0.88)),
    (0.54, (0.40, 0.42, 0.47)),
    (0.62, (0.52, 0.54, 0.59)),
    (0.76, (0.96, 0.97, 0.98)),
    (0.85, (0.66, 0.68, 0.73)),
    (0.95, (1.00, 1.00, 1.00)),
    (1.00, (1.00, 1.00, 1.00)),
]

# Shadows in comics are a darker colour, not black.
MAPS = {
    "flat": steps([1.0], []),
    "two_tone": steps([0.55, 1.0], [0.4]),
    "three_tone": steps([0.45, 0.8], [0.35], highlight=1.0),
    "four_tone": steps([0.38, 0.6, 0.82], [0.22, 0.58], highlight=1.0),
    "soft_three_tone": soft_steps([0.45, 0.8], [0.35], highlight=1.0, half_width=0.035),
    "gradient": line((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)),
    "monochrome": steps([0.0, 1.0], [0.3]),
    "metal": ramp(METAL),
    "spectrum": spectrum,
    "warm_cool": line((0.34, 0.42, 0.80), (1.00, 0.92, 0.62)),
}


def make(out):
    for name, tone in MAPS.items():
        row = [tone((texel + 0.5) / WIDTH, texel) for texel in range(WIDTH)]
        write_png(out / "textures" / "toon" / f"{name}.png", [row])
