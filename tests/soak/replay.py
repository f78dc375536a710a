"""Meshes for the soak to look at, and sessions that should be alike."""

import json
import math

# What a session says of where things are kept, and not of what is seen.
ELSEWHERE = ("output",)


def write_mesh(path, rows=120):
    """A ball with bumps, and a height at each of its points, as PLY."""
    columns = 2 * rows
    points, triangles = [], []
    for row in range(rows + 1):
        for column in range(columns):
            a, b = math.pi * row / rows, 2 * math.pi * column / columns
            r = 1 + 0.15 * math.sin(5 * a) * math.sin(4 * b)
            points.append((r * math.sin(a) * math.cos(b), r * math.sin(a) * math.sin(b),
                           r * math.cos(a)))
    for row in range(rows):
        for column in range(columns):
            here, right = row * columns + column, row * columns + (column + 1) % columns
            triangles += [(here, here + columns, right), (right, here + columns, right + columns)]
    with open(path, "w") as file:
        file.write("ply\nformat ascii 1.0\nelement vertex %d\n" % len(points))
        file.write("".join("property float %s\n" % name for name in "xyz"))
        file.write("element face %d\nproperty list uchar int vertex_indices\nend_header\n" %
                   len(triangles))
        file.writelines("%.6g %.6g %.6g\n" % point for point in points)
        file.writelines("3 %d %d %d\n" % triangle for triangle in triangles)


def flat(value, name=""):
    """Every value of a session by its path."""
    if not isinstance(value, dict):
        return {name: value}
    found = {}
    for key, inner in value.items():
        found.update(flat(inner, name + "/" + key if name else key))
    return found


def differences(first, second):
    """Lines that tell where two session files differ."""
    with open(first) as a, open(second) as b:
        one, other = flat(json.load(a)), flat(json.load(b))
    return ["%s: %r, %r" % (name, one.get(name), other.get(name))
            for name in sorted(set(one) | set(other))
            if name.split("/")[0] not in ELSEWHERE and one.get(name) != other.get(name)]
