#!/usr/bin/env python3
"""svg_pixels.py CHART.svg CHART.png: the curves of the one have their colours on the other, and in
the frames there is nothing else but them and the faint grid."""
import sys

from compare_png import rows
from svg_curves import panels_of

panels, _ = panels_of(sys.argv[1])
picture, n = rows(sys.argv[2])


def pixel(x, y):
    return tuple(picture[int(y)][n * int(x) : n * int(x) + 3])


def near(color, wanted):
    return max(abs(a - b) for a, b in zip(color, wanted)) < 12


for panel in panels:
    colored = 0
    for name, points in panel.pixels.items():
        color = panel.colors[name]
        wanted = tuple(int(color[i : i + 2], 16) for i in (1, 3, 5))
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for share in (0.1, 0.5, 0.9):
                x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
                assert near(pixel(x, y), wanted), (name, x, y, pixel(x, y), wanted)
            colored += max(abs(x1 - x0), abs(y1 - y0))
    drawn = sum(max(pixel(x, y)) - min(pixel(x, y)) > 60
                for y in range(int(panel.top), int(panel.bottom))
                for x in range(int(panel.left), int(panel.right)))
    assert colored < drawn < 8 * colored, (colored, drawn)
