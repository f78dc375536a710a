#!/usr/bin/env python3
"""Works the Python package at random: scenes of arrays and files, settings, pictures.

    pipelines.py --seed 1 --minutes 60 [--memory MIB] MOTE DATA...

Wants PYTHONPATH to name the package. Whatever is done may fail with an exception of the documented
kinds alone. The same scene must give the same picture whenever it is drawn, and after the whole run
that of its beginning; memory may not grow. The last steps are told where it fails, and the exit code
is 1.
"""

import ctypes
import gc
import os
import random
import resource
import subprocess
import sys
import time

import mote
import numpy as np

from table import options_of, value
from words import parser_of

# What wrong arguments give.
DOCUMENTED = (mote.Error, TypeError, ValueError, KeyError, IndexError, OSError)
LIBC = ctypes.CDLL(None)
SMALL = {"size": (48, 36), "samples": 1}
# Settings of films, windows and files are not of scenes.
GROUPS = ("Colour", "Selection", "Cuts", "Radius", "Structure", "Volume", "Slices", "Flow", "Camera",
          "Light", "Silhouettes", "Picture")


def resident():
    """MiB."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20


class Pipelines:
    def __init__(self, arguments):
        self.arguments = arguments
        self.random = random.Random(arguments.seed)
        self.numbers = np.random.default_rng(arguments.seed)
        table = subprocess.run([arguments.mote, "help", "--format", "markdown"], check=True,
                               stdout=subprocess.PIPE).stdout.decode()
        self.options = [o for group in GROUPS for o in options_of(table)[group]]
        self.scenes = []
        self.done = []
        self.refused = self.drawn = 0
        self.memory = []

    # ---------------------------------------------------------------- what is done

    def some_settings(self):
        given = {}
        for option in self.random.sample(self.options, self.random.choice([0, 0, 1, 1, 2, 4])):
            words = value(option, self.random)
            name = option.name[2:].replace("-", "_")
            given[name] = True if not words else words[0] if len(words) == 1 else words
        return given

    def make_particles(self):
        count = self.random.choice([0, 1, 2, 100, 3000])
        kind = self.random.choice(["<f4", "<f8", "<i4", ">f8"])
        points = (self.numbers.normal(size=(count, 3)) * 5).astype(kind)
        if self.random.random() < 0.1 and count:
            points = points.astype("<f8")
            points[self.random.randrange(count)] = self.random.choice([np.nan, np.inf, 1e300])
        if self.random.random() < 0.2:
            points = np.asfortranarray(points)
        radius = self.random.choice([None, 0.3, self.numbers.random(count), -1, np.zeros(count + 1)])
        color = self.random.choice([None, "tomato", self.numbers.random(count),
                                    self.numbers.random((count, 3)), np.arange(count), "nothing"])
        return mote.particles(points, radius=radius, color=color, **self.some_settings())

    def make_mesh(self):
        count = self.random.choice([3, 50, 400])
        points = self.numbers.random((count, 3))
        triangles = self.numbers.integers(0, count + (self.random.random() < 0.1), size=(2 * count, 3))
        return mote.mesh(points, triangles, color=self.random.choice([None, points[:, 0]]),
                         **self.some_settings())

    def make_volume(self):
        shape = [self.random.choice([1, 2, 5, 12]) for _ in range(3)]
        grid = self.numbers.random(shape).astype(self.random.choice(["<f4", "<f8", "|u1"]))
        return mote.volume(grid, **self.some_settings())

    def read(self):
        return mote.read(self.random.choice(self.arguments.data), **self.some_settings())

    def make(self):
        kind = self.random.choice([self.make_particles, self.make_mesh, self.make_volume, self.read])
        self.note(kind.__name__)
        self.scenes.append(kind())
        del self.scenes[:-6]

    def change(self):
        scene = self.random.choice(self.scenes)
        given = self.some_settings()
        self.note("with_settings %r" % given)
        self.scenes.append(scene.with_settings(**given))
        del self.scenes[:-6]

    def join(self):
        few = [scene for scene in self.scenes if len(scene.data) <= 2]
        if not few:
            return
        self.note("+")
        self.scenes.append(self.random.choice(few) + self.random.choice(few))
        del self.scenes[:-6]

    def look(self):
        scene = self.random.choice(self.scenes)
        self.note("look at %r" % scene)
        for name in scene:
            found = np.asarray(scene[name])
            if self.random.random() < 0.3:
                scene["more"] = found * 2
        if len(scene) and self.random.random() < 0.3:
            scene.at(self.random.choice([-1, 0, 1, 5]))

    def draw(self):
        scene = self.random.choice(self.scenes)
        given = self.some_settings()
        self.note("render %r %r" % (scene, given))
        picture = scene.render(**{**given, **SMALL})
        self.drawn += 1
        if picture.array.shape != (36, 48, 3):
            raise AssertionError("a picture of %s" % (picture.array.shape,))
        if self.random.random() < 0.2:
            again = scene.render(**{**given, **SMALL}).array
            if not np.array_equal(again, picture.array):
                off = np.abs(again.astype(int) - picture.array)
                raise AssertionError("another picture of the same scene: %d numbers differ, by up to %d; "
                                     "of %r" % (np.count_nonzero(off), off.max(), scene.settings))

    # ---------------------------------------------------------------- the whole

    def note(self, text):
        self.done.append(text)
        del self.done[:-20]

    def act(self):
        kinds = [self.make] * 3 + [self.draw] * 5 + [self.change] * 2 + [self.join, self.look]
        kind = self.random.choice(kinds) if self.scenes else self.make
        try:
            kind()
        except DOCUMENTED as refusal:
            self.refused += 1
            if not str(refusal):
                raise AssertionError("a refusal without a word: %r" % refusal) from refusal

    def fixed_picture(self):
        """The same whenever it is drawn."""
        points = np.random.default_rng(7).random((2000, 3))
        return mote.particles(points, radius=0.02, color=points[:, 2], shadows="hard").render(
            size=(160, 120), samples=2).array

    def work(self):
        first = self.fixed_picture()
        end = time.time() + 60 * self.arguments.minutes
        acts = 0
        while time.time() < end:
            self.act()
            acts += 1
            if acts % 100 == 0: # what is left when nothing is kept
                self.scenes.clear()
                gc.collect()
                LIBC.malloc_trim(0) # what is free and kept for later is nobody's
                self.memory.append(resident())
        if not np.array_equal(first, self.fixed_picture()):
            raise AssertionError("another picture at the end than at the beginning")
        # The first third meets everything once. Medians: a single measure may be high where something
        # large has just been let go.
        third = len(self.memory) // 3
        early, late = (np.median(part) if part else 0.0
                       for part in (self.memory[third:2 * third], self.memory[2 * third:]))
        print("%d acts, %d pictures, %d refusals; MiB: %s" % (acts, self.drawn, self.refused, " ".join(
            "%.0f" % m for m in self.memory[::max(1, len(self.memory) // 20)])))
        if third and late > early + self.arguments.memory:
            raise AssertionError("memory grows: %.0f MiB in the second third, %.0f in the last" % (early, late))


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--memory", type=float, default=50.0,
                        help="MiB more that the last third may take than the second")
    arguments = parser.parse_args()
    arguments.data = [os.path.abspath(name) for name in arguments.data] + ["missing.dump", "pump:0.03"]
    work = Pipelines(arguments)
    try:
        work.work()
    except Exception:
        print("FAILED with --seed %d, after\n  %s" % (arguments.seed, "\n  ".join(work.done)), flush=True)
        raise


if __name__ == "__main__":
    sys.exit(main())
