#!/usr/bin/python3
"""Writes a LAMMPS text dump of many particles quickly, for measurements.

    data/make-large.py 10000000 large.dump

A jittered cubic lattice of unit spacing with spherical pores, so that rays meet empty space;
radii between 0.2 and 0.6, and a smooth `value`. The same arguments give the same file.
"""
import argparse
import sys

import numpy as np

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
parser.add_argument("count", type=int, help="number of particles, at least 1")
parser.add_argument("file", help="dump to write; - for standard output")
parser.add_argument("--jitter", type=float, default=0.3, help="largest shift along an axis")
parser.add_argument("--pores", type=float, default=0.3, help="share of empty space, 0 to 0.5")
parser.add_argument("--seed", type=int, default=1)
args = parser.parse_args()
if args.count < 1 or not 0 <= args.pores <= 0.5:
    parser.error("count must be at least 1, and --pores between 0 and 0.5")

# Pores: spheres around the points of a coarser lattice, one to a cell of size `cell`.
cell = 16.0
pore_radius = cell * (3 * args.pores / (4 * np.pi)) ** (1 / 3)
# A little too large, so that the last layer is cut rather than missing.
edge = int(np.ceil((args.count / (1 - args.pores)) ** (1 / 3) * 1.03)) + 2
random = np.random.default_rng(args.seed)
out = sys.stdout if args.file == "-" else open(args.file, "w")


def layer(z):
    """The particles of the lattice plane z: columns x y z radius value."""
    y, x = np.divmod(np.arange(edge * edge), edge)
    p = np.stack([x, y, np.full(x.size, z)], 1) + random.uniform(-args.jitter, args.jitter, (x.size, 3))
    from_pore = (p / cell) % 1.0 - 0.5
    p = p[np.einsum("ij,ij->i", from_pore, from_pore) > (pore_radius / cell) ** 2]
    radius = 0.2 * 3 ** random.uniform(0, 1, len(p))
    value = np.sin(p * 0.1).sum(1)
    return np.column_stack([p, radius, value])


out.write(f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{args.count}\nITEM: BOX BOUNDS ff ff ff\n")
out.write(f"{-1} {edge}\n" * 3)
out.write("ITEM: ATOMS id type radius x y z value\n")
written, z = 0, 0
while written < args.count:
    rows = layer(z)[: args.count - written]
    ids = np.arange(written + 1, written + len(rows) + 1)
    kind = 1 + (rows[:, 3] > 0.35)
    columns = np.column_stack([ids, kind, rows[:, 3], rows[:, :3], rows[:, 4]])
    out.write(("%d %d %.3f %.3f %.3f %.3f %.3f\n" * len(rows)) % tuple(columns.ravel().tolist()))
    written += len(rows)
    z += 1
out.close()
