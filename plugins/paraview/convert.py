"""Cuts the particles of a file into a piece for each rank, compact in space; scripts/paraview convert runs it.

Each rank reads its share, sends each particle to the rank of its box, and writes its piece: none ever holds all.
"""

import argparse
import os
import sys

from opened import open_file, time_of
from paraview import simple

parser = argparse.ArgumentParser(prog="scripts/paraview convert", description=__doc__.split(";")[0] + ".")
parser.add_argument("file", metavar="FILE")
parser.add_argument("-o", "--output", metavar="PIECES", required=True,
                    help="the name of a .pvtp file; the pieces lie in a folder beside it")
parser.add_argument("--step", type=int, default=1, help="time step, from 1")


def stamp_of(name):
    """When a file was written; None where there is none. SaveData does not tell whether it could."""
    return os.stat(name).st_mtime_ns if os.path.isfile(name) else None


def main():
    options = parser.parse_args()
    if not options.output.endswith(".pvtp"):
        sys.exit(f"{options.output}: the name of pieces of particles ends in .pvtp")
    source = open_file(options.file)
    time = time_of(source, options.file, options.step)
    pieces = simple.DistributeParticlesMote(Input=source, Ghosts=0, ReleaseInput=1)
    pieces.UpdatePipeline(*([] if time is None else [time]))
    count = pieces.GetDataInformation().GetNumberOfPoints()
    if count == 0:
        sys.exit(f"{options.file}: it has no points")
    before = stamp_of(options.output)
    simple.SaveData(options.output, proxy=pieces)
    if stamp_of(options.output) in (None, before):
        sys.exit(f"{options.output}: cannot be written")
    print(f"{options.output}: {count:,} particles", flush=True)


main()
