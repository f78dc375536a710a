#!/usr/bin/env python3
"""Reads curves back from a chart in SVG: functions for the tests of charts.

Pixels become values by the numbers at the ticks alone, as who reads the chart has them.
"""
import xml.etree.ElementTree as tree

NAMESPACE = "{http://www.w3.org/2000/svg}"


RAISED = dict(zip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))


def number(text):
    return float(text.replace("\u2212", "-"))


def factor(title):
    """What the numbers of an axis are multiplied by, as its title says."""
    power = title.rpartition("×10")[2] if "×10" in title else "⁰"
    return 10.0 ** int("".join(RAISED[digit] for digit in power))


class Panel:
    """A frame of a chart: its curves as lists of (x, y), and their colours."""

    def __init__(self, rect, texts, groups):
        self.left, self.top = float(rect.get("x")), float(rect.get("y"))
        self.right = self.left + float(rect.get("width"))
        self.bottom = self.top + float(rect.get("height"))
        self.across, self.up = [], []  # pixel and value of ticks
        self.factor = 1.0  # of the values upwards
        for text in texts:
            x, y, width = (float(text.get(key)) for key in ("x", "y", "textLength"))
            if text.get("transform") and self.top < y < self.bottom:
                self.factor = factor(text.text)
            try:
                value = number(text.text)
            except ValueError:
                continue
            size = float(text.get("font-size"))
            if x + width <= self.left and self.top - size < y < self.bottom + size:
                self.up.append((y - 0.36 * size, value))  # the middle of its digits
            elif self.left - width < x < self.right and y > self.bottom:
                self.across.append((x + width / 2, value))
        self.groups = groups
        self.curves, self.colors, self.pixels = {}, {}, {}

    def read(self, across):
        for name, points, color in self.groups:
            self.pixels[name] = points
            self.colors[name] = color
            self.curves[name] = [
                (at(across, x), self.factor * at(self.up, y)) for x, y in points]


def at(ticks, pixel):
    (a, low), (b, high) = min(ticks), max(ticks)
    return low + (pixel - a) / (b - a) * (high - low)


def panels_of(file):
    """The panels, from the top, and all texts."""
    root = tree.parse(file).getroot()
    texts = [text for text in root.iter(NAMESPACE + "text")]
    groups = {}
    for group in root.iter(NAMESPACE + "g"):
        title = group.find(NAMESPACE + "title")
        points, color = [], None
        for line in group.iter(NAMESPACE + "polyline"):
            points += [tuple(map(float, point.split(","))) for point in line.get("points").split()]
            color = line.get("stroke")
        groups.setdefault(group.get("clip-path")[5:-1], []).append(
            (title.text if title is not None else "", points, color))
    panels = []
    for clip in root.iter(NAMESPACE + "clipPath"):
        rect = clip.find(NAMESPACE + "rect")
        panels.append(Panel(rect, texts, groups.get(clip.get("id"), [])))
    for panel in panels:
        panel.read(panels[-1].across)  # the numbers of all stand below the last
    return panels, [text.text for text in texts]


def same(curve, expected, reaches=None):
    """Whether a curve has the points that were expected, up to a hundredth of their ranges, or of
    those that are given."""
    assert len(curve) == len(expected), (len(curve), len(expected))
    for axis in (0, 1):
        values = [point[axis] for point in expected]
        reach = reaches[axis] if reaches else max(values) - min(values) or abs(values[0]) or 1.0
        for point, value in zip(curve, values):
            assert abs(point[axis] - value) < 0.01 * reach, (axis, point, value, reach)
