#!/usr/bin/python3
"""How long it takes from an array of NumPy to a picture, and the next one, and what memory that takes.

    PYTHONPATH=build/release/lib/python3/dist-packages benchmarks/python/points.py [COUNT]
"""

import resource
import sys
import time

import mote
import numpy as np

count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000_000
points = np.random.default_rng(1).random((count, 3), np.float32)


def megabytes():
    """The most that the process has taken so far."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


before = megabytes()
for what, settings in (("first picture", {}), ("from elsewhere", {"azimuth": 20}), ("a half", {"show": {"x": (0.5, 1)}})):
    begin = time.perf_counter()
    if not settings:
        scene = mote.particles(points, radius=0.3 * count ** (-1 / 3))
    scene.render(size=(1024, 1024), samples=1, **settings)
    print(f"{what}: {time.perf_counter() - begin:.2f} s")
print(f"memory beside the points, of {points.nbytes / 2**20:.0f} MB: {megabytes() - before:.0f} MB")
