# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots on two logarithmic axes, as SVG, without any library."""

import math

WIDTH, HEIGHT, LEFT, BOTTOM = 640, 420, 80, 60
COLOURS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b",
           "#17becf", "#7f7f7f")


def limits(values):
    """Whole powers of ten around positive values."""
    low = math.floor(math.log10(min(values)))
    high = math.ceil(math.log10(max(values)))
    return low, max(high, low + 1)


def loglog(path, curves, x_label, y_label):
    """Writes a plot of curves {name: [(x, y), ...]}."""
    points = [p for curve in curves.values() for p in curve]
    x_low, x_high = limits([p[0] for p in points])
    y_low, y_high = limits([p[1] for p in points])
    right = WIDTH - 180

    def place(x, y):
        return (LEFT + (math.log10(x) - x_low)/(x_high - x_low)*(right - LEFT),
                HEIGHT - BOTTOM
                - (math.log10(y) - y_low)/(y_high - y_low)
                * (HEIGHT - BOTTOM - 20))

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" '
           f'height="{HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for power in range(x_low, x_high + 1):
        x, y = place(10.0**power, 10.0**y_low)
        out += [f'<line x1="{x}" y1="20" x2="{x}" y2="{y}" stroke="#ddd"/>',
                f'<text x="{x}" y="{y + 18}" text-anchor="middle">1e{power}'
                '</text>']
    for power in range(y_low, y_high + 1):
        x, y = place(10.0**x_low, 10.0**power)
        out += [f'<line x1="{x}" y1="{y}" x2="{right}" y2="{y}" '
                'stroke="#ddd"/>',
                f'<text x="{x - 6}" y="{y + 4}" text-anchor="end">1e{power}'
                '</text>']
    for i, (name, curve) in enumerate(curves.items()):
        colour = COLOURS[i % len(COLOURS)]
        places = [place(*p) for p in sorted(curve)]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        out.append(f'<polyline points="{line}" fill="none" '
                   f'stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>'
                for x, y in places]
        y = 30 + 18*i
        out += [f'<rect x="{right + 12}" y="{y - 9}" width="12" height="4" '
                f'fill="{colour}"/>',
                f'<text x="{right + 30}" y="{y - 3}">{name}</text>']
    out += [f'<text x="{(LEFT + right)/2}" y="{HEIGHT - 15}" '
            f'text-anchor="middle">{x_label}</text>',
            f'<text transform="translate(18 {HEIGHT/2}) rotate(-90)" '
            f'text-anchor="middle">{y_label}</text>', "</svg>"]
    with open(path, "w", encoding="ascii") as stream:
        stream.write("\n".join(out) + "\n")
