#!/usr/bin/env python3
"""Writes a small OpenFOAM case by formulas: the flow through the rotor of an axial pump.

    data/make-rotor.py rotor      # the folder rotor with rotor.foam, in seconds

Seven blades stand between hub and shroud. Upstream the water flows along the axis, z; the blades
turn it, and behind them it swirls as a free vortex, u = K / r. What a lossless rotor does follows
from K, the flow rate Q and the angular speed W:

    head = W K / g        torque of the water on the blades = -rho Q K        power = -rho Q K W

K varies by a tenth over the revolution that the ten time steps cover; at the last one it is the
mean. A pattern of pressure, as from a bend upstream, runs round against the rotor once; over all
blades it does nothing. p is pressure by density in m2/s2, as incompressible solvers write it; U is the velocity
in the frame at rest, in m/s. The mesh turns with the rotor and is written as it stands in its frame.
"""
import argparse
import math
import os

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
parser.add_argument("folder", help="folder to write, which must not be there")
parser.add_argument("--fine", type=int, default=1, help="factor on the cells along each direction")
args = parser.parse_args()

BLADES, RPM = 7, 960.0
HUB, SHROUD = 0.06, 0.10  # radii in m
BEGIN, LEADING, TRAILING, END = -0.04, 0.0, 0.04, 0.10  # along the axis in m
AXIAL = 6.0  # m/s, upstream
MEAN_SWIRL = 0.16  # K in m2/s
STEPS = 10
RHO, GRAVITY = 1000.0, 9.80665

omega = 2.0 * math.pi * RPM / 60.0
revolution = 60.0 / RPM
area = math.pi * (SHROUD**2 - HUB**2)
middle = 0.5 * (HUB + SHROUD)

pitch_cells = 12 * args.fine  # around, from blade to blade; a blade is `thick` of them thick
thick = args.fine
nr, na = 8 * args.fine, BLADES * pitch_cells
layers = [12 * args.fine, 16 * args.fine, 20 * args.fine]  # before, between and behind the blades
nz = sum(layers)
open_share = 1.0 - thick / pitch_cells  # of the area, between the blades


def along(k):
    """The place of layer k of points along the axis."""
    ends = [BEGIN, LEADING, TRAILING, END]
    for part, count in enumerate(layers):
        if k <= count:
            return ends[part] + (ends[part + 1] - ends[part]) * k / count
        k -= count
    raise ValueError


def turned(z):
    """The share of the swirl that the water has at z."""
    u = min(max((z - LEADING) / (TRAILING - LEADING), 0.0), 1.0)
    return u - math.sin(2.0 * math.pi * u) / (2.0 * math.pi)


def bend(z):
    """The angle of a blade at z: along the relative flow, at the middle radius."""
    steps = 200
    total = 0.0
    for i in range(steps):
        at = LEADING + (z - LEADING) * (i + 0.5) / steps
        slope = -(omega - MEAN_SWIRL * turned(at) / middle**2) / AXIAL
        total += slope * (z - LEADING) / steps if LEADING <= z <= TRAILING else 0.0
    if z > TRAILING:
        return bend(TRAILING)
    return total


bends = [bend(along(k)) for k in range(nz + 1)]


def is_blade(j, k):
    return j % pitch_cells < thick and layers[0] <= k < layers[0] + layers[1]


def point(i, j, k):
    r = HUB + (SHROUD - HUB) * i / nr
    angle = 2.0 * math.pi * j / na + bends[k]
    return r * math.cos(angle), r * math.sin(angle), along(k)


def point_number(i, j, k):
    return (k * na + j % na) * (nr + 1) + i


cells, places = {}, []  # numbers by (i, j, k), and the other way round
for k in range(nz):
    for j in range(na):
        for i in range(nr):
            if not is_blade(j, k):
                cells[i, j, k] = len(places)
                places.append((i, j, k))


def faces_of(i, j, k):
    """The six faces, outwards: where they lead to, and their points."""
    n = point_number
    return [
        ((i - 1, j, k), (n(i, j, k), n(i, j, k + 1), n(i, j + 1, k + 1), n(i, j + 1, k)), "hub"),
        ((i + 1, j, k), (n(i + 1, j, k), n(i + 1, j + 1, k), n(i + 1, j + 1, k + 1), n(i + 1, j, k + 1)), "shroud"),
        ((i, (j - 1) % na, k), (n(i, j, k), n(i + 1, j, k), n(i + 1, j, k + 1), n(i, j, k + 1)), "blades"),
        ((i, (j + 1) % na, k), (n(i, j + 1, k), n(i, j + 1, k + 1), n(i + 1, j + 1, k + 1), n(i + 1, j + 1, k)), "blades"),
        ((i, j, k - 1), (n(i, j, k), n(i, j + 1, k), n(i + 1, j + 1, k), n(i + 1, j, k)), "inlet" if k == 0 else "blades"),
        ((i, j, k + 1), (n(i, j, k + 1), n(i + 1, j, k + 1), n(i + 1, j + 1, k + 1), n(i, j + 1, k + 1)), "outlet" if k == nz - 1 else "blades"),
    ]


inner = []  # owner, neighbour, points
patches = {name: [] for name in ("inlet", "outlet", "hub", "shroud", "blades")}  # owner, points, centre
for number, (i, j, k) in enumerate(places):
    mine = []
    for side, (to, corners, name) in enumerate(faces_of(i, j, k)):
        other = cells.get(to)
        if other is None:
            ijk = [i + 0.5, j + 0.5, k + 0.5]
            ijk[side // 2] += -0.5 if side % 2 == 0 else 0.5
            patches[name].append((number, corners, ijk))
        elif other > number:
            mine.append((other, corners))
    inner += [(number, other, corners) for other, corners in sorted(mine)]


def between(values, at):
    low = min(int(at), len(values) - 2)
    return values[low] + (at - low) * (values[low + 1] - values[low])


heights = [along(k) for k in range(nz + 1)]


def fields_at(i, j, k, time):
    """p and U where the coordinates of the mesh are these."""
    swirl = MEAN_SWIRL * (1.0 + 0.1 * math.sin(2.0 * math.pi * time / revolution))
    r, z = HUB + (SHROUD - HUB) * i / nr, between(heights, k)
    angle = 2.0 * math.pi * j / na + between(bends, k)
    is_between = LEADING < z < TRAILING
    axial = AXIAL / open_share if is_between else AXIAL
    around = swirl * turned(z) / r
    p = omega * swirl * turned(z) - 0.5 * around**2 - 0.5 * (axial**2 - AXIAL**2)
    if is_between:
        # From the pressure side of one blade to the suction side of the next.
        u = (z - LEADING) / (TRAILING - LEADING)
        loading = 2.0 * math.sin(math.pi * u) ** 2 / (TRAILING - LEADING)
        across = (j % pitch_cells - thick) / (pitch_cells - thick)
        if j % pitch_cells == 0:
            across = 1.0  # the suction side, at the next blade
        p += 2.0 * math.pi * AXIAL * swirl / BLADES * loading * (0.5 - across)
    p += 1.5 * math.cos(angle + 2.0 * math.pi * time / revolution)
    return p, (-around * math.sin(angle), around * math.cos(angle), axial)


def write(path, kind, text, extra=""):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    name = os.path.basename(path)
    with open(path, "w") as file:
        file.write(f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n{extra}"
                   f"    object {name};\n}}\n\n{text}")


def listed(rows):
    return f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n"


def vector(v):
    return "(" + " ".join(f"{x:.7g}" for x in v) + ")"


def write_mesh(folder):
    note = (f'    note "nPoints:{(nr + 1) * na * (nz + 1)} nCells:{len(places)} '
            f'nFaces:{len(inner) + sum(map(len, patches.values()))} nInternalFaces:{len(inner)}";\n')
    points = [point(i, j, k) for k in range(nz + 1) for j in range(na) for i in range(nr + 1)]
    outer = [face for faces in patches.values() for face in faces]
    write(f"{folder}/points", "vectorField", listed([vector(p) for p in points]))
    every = [corners for _, _, corners in inner] + [corners for _, corners, _ in outer]
    write(f"{folder}/faces", "faceList", listed(["4(" + " ".join(map(str, c)) + ")" for c in every]))
    write(f"{folder}/owner", "labelList",
          listed([str(own) for own, _, _ in inner] + [str(own) for own, _, _ in outer]), note)
    write(f"{folder}/neighbour", "labelList", listed([str(other) for _, other, _ in inner]), note)
    start, entries = len(inner), []
    for name, faces in patches.items():
        kind = "patch" if name in ("inlet", "outlet") else "wall"
        entries.append(f"    {name}\n    {{\n        type {kind};\n        nFaces {len(faces)};\n"
                       f"        startFace {start};\n    }}")
        start += len(faces)
    write(f"{folder}/boundary", "polyBoundaryMesh", listed(entries))


def write_fields(folder, time):
    for which, name, kind, dimensions in ((0, "p", "Scalar", "[0 2 -2 0 0 0 0]"),
                                          (1, "U", "Vector", "[0 1 -1 0 0 0 0]")):
        text = (lambda values: vector(values[1])) if which else (lambda values: f"{values[0]:.7g}")
        of = f"nonuniform List<{kind.lower()}> "
        body = f"dimensions {dimensions};\n\ninternalField {of}\n"
        body += listed([text(fields_at(i + 0.5, j + 0.5, k + 0.5, time)) for i, j, k in places])
        body += ";\n\nboundaryField\n{\n"
        for patch, faces in patches.items():
            body += f"    {patch}\n    {{\n        type calculated;\n        value {of}\n"
            body += listed([text(fields_at(*at, time)) for _, _, at in faces]) + ";\n    }\n"
        write(f"{folder}/{name}", f"vol{kind}Field", body + "}\n")


os.mkdir(args.folder)
write(f"{args.folder}/system/controlDict", "dictionary",
      "application none;\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\n"
      f"endTime {revolution:g};\ndeltaT {revolution / STEPS:g};\nwriteControl timeStep;\nwriteInterval 1;\n")
open(f"{args.folder}/rotor.foam", "w").close()
write_mesh(f"{args.folder}/constant/polyMesh")
for step in range(1, STEPS + 1):
    time = revolution * step / STEPS
    write_fields(f"{args.folder}/{time:g}", time)

flow = AXIAL * area
print(f"{args.folder}/rotor.foam: {len(places)} cells, {STEPS} time steps to {revolution:g} s")
print(f"flow {flow:.5g} m3/s, head {omega * MEAN_SWIRL / GRAVITY:.4g} m, torque {-RHO * flow * MEAN_SWIRL:.4g} N m, "
      f"power {-RHO * flow * MEAN_SWIRL * omega:.5g} W at the last one, with 1000 kg/m3 at {RPM:g} turns a minute")
