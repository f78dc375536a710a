#!/usr/bin/env python3
"""Writes small files of a format, for libFuzzer to begin with.

    fuzz/seeds.py FORMAT FOLDER
"""

import gzip
import pathlib
import sys

dump = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
3
ITEM: BOX BOUNDS {box}
{bounds}
ITEM: ATOMS {columns}
{rows}
"""
plain = dict(step=0, box="pp pp ff", bounds="0 2\n-1 1\n0 3", columns="id type x y z radius",
             rows="1 1 0 0 0 0.5\n2 2 1.5 -0.5 1e0 0.25\n3 1 nan inf -1 .5")
scaled = dict(step=100, box="xy xz yz pp pp pp", bounds="0 2 0.5\n0 2 0\n0 2 -0.5",
              columns="id element xs ys zs ix iy iz q", rows="7 Cu 0 0 0 0 0 0 1\n"
              "8 Zr 0.5 0.5 0.5 -1 0 2 -2.5e-3\n9 Cu 1 1 1 0 0 0 12345678901234567890")
pdb_atom = "ATOM  {n:5d}  CA  ALA A{n:4d}    {x:8.3f}{x:8.3f}{x:8.3f}  1.00 10.00           C"

seeds = {
    "dump": [
        dump.format(**plain), dump.format(**plain) + dump.format(**scaled),
        "ITEM: UNITS\nmetal\nITEM: TIME\n0.25\n" + dump.format(**scaled),
        dump.format(**{**plain, "rows": ""}).replace("\n3\n", "\n0\n"),
        gzip.compress(dump.format(**plain).encode(), mtime=0)
    ],
    "xyz": [
        "2\na comment\nCu 0 0 0\nO 1.5 2 -3e1\n",
        "1\nfirst\n1 0 0 0\n1\nsecond\n1 1 0 0\n",
        '2\nLattice="2 0 0 0 2 0 0.5 0 2" Properties=species:S:1:pos:R:3:f:R:3:id:I:1 Time=0.5 '
        'pbc="T F T"\nH 0 0 0 1 2 3 7\nHe 1 1 1 -1 -2 -3 8\n'
    ],
    "pts": ["0 0 0\n1 2 3\n-1e3 nan 5\n", "1,2,3\n4,5,6\n"],
    "csv": [
        "x,y,z,v\n0,0,0,1\n1,2,3,-1e5\n", 'x;y;z;"a name"\n0;0;0;one\n1;1;1;two\n',
        "a\tb\tc\n1\t2\t3\n", "x,y,z\n1,2\n3,4,5,6\n"
    ],
    "pdb": [
        "\n".join(pdb_atom.format(n=n, x=0.5 * n) for n in (1, 2, 3)) + "\nEND\n",
        "HEADER    A TEST\nHETATM    1  O   HOH A   1       1.000   2.000   3.000\nTER\nEND\n"
    ],
    "ply": [
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n",
        b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
        b"property float y\nproperty float z\nend_header\n" + bytes(12)
    ],
    "expression": [
        "x + 2*y^2 - z", "v.x > 0.5 && mag(v) <= 2 || !(y == 1)", "'v'.1 ? sqrt(abs(z)) : -pi",
        "max(1, 2, min(x, y)) + sum(x, y, z) + rint(1e-3)", "gradient(v).x", '"v" * 0.1e+2'
    ],
}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in seeds:
        sys.exit("usage: fuzz/seeds.py " + "|".join(seeds) + " FOLDER")
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds[sys.argv[1]]):
        data = seed if isinstance(seed, bytes) else seed.encode()
        (folder / f"seed-{number}").write_bytes(data)


if __name__ == "__main__":
    main()
