#!/usr/bin/env python3
"""Changes a copy of the sources in one place after the other, and runs the unit tests each time.

    mutate.py SOURCE BUILD [--count N] [--seed S] [--room ROOM] [--at FILE:LINE...]

SOURCE is the copy, BUILD its build folder. A change that no test notices survives: it gets a line
with its place, and the exit code is 1. What makes the same machine code, or none, does not count.
known.txt beside this program lists survivors that make no difference, with the reason.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import random
import subprocess
import sys
import time

from changes import apply, changes, line_of

ROOMS = ("rendering/kernels", "filters/io")
# Programs of tests by the folder that they look at most; the others come after these.
NEAR = {
    "rendering/kernels/core": ["kernels-core", "kernels-scene"],
    "rendering/kernels/hexahedra": ["kernels-hexahedra", "kernels-walk", "kernels-volume"],
    "rendering/kernels/imaging": ["kernels-imaging"],
    "rendering/kernels/meshes": ["kernels-meshes", "kernels-volume"],
    "rendering/kernels/particles": ["kernels-structures", "kernels-particles"],
    "rendering/kernels/occlusion": ["kernels-bake", "kernels-scene"],
    "rendering/kernels/scene": ["kernels-scene", "kernels-volume"],
    "rendering/kernels/shading": ["kernels-scene", "kernels-volume"],
    "rendering/kernels/tracing": ["kernels-scene", "kernels-volume"],
    "filters/io": ["TestFiltersIOParser", "TestFiltersIO"],
}
KERNELS = ["kernels-core", "kernels-imaging", "kernels-bake", "kernels-hexahedra", "kernels-scene",
           "kernels-structures", "kernels-volume", "kernels-particles", "kernels-walk",
           "kernels-meshes"]
READERS = ["TestFiltersIOParser", "TestFiltersIO"]
# A change that builds more than this takes too long for what it tells.
MOST_STEPS = 60

Site = collections.namedtuple("Site", "file change")


class Tests:
    def __init__(self, build):
        self.build = build
        self.seconds = {}

    def run(self, program, limit):
        """None where all tests pass, else what failed."""
        began = time.time()
        path = os.path.join(self.build, "tests", program)
        try:
            done = subprocess.run(
                [path, "--gtest_fail_fast", "--gtest_brief=1"], cwd=self.build, timeout=limit,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        except subprocess.TimeoutExpired:
            return "no end within %d s" % limit
        finally:
            self.seconds.setdefault(program, time.time() - began)
        if done.returncode == 0:
            return None
        text = done.stdout.decode(errors="replace")
        failed = [line for line in text.split("\n") if line.startswith("[  FAILED  ] ")]
        return failed[0].split("] ")[1].split(",")[0].split(" (")[0] if failed else (
            "exit code %d" % done.returncode)

    def order(self, folder):
        all_of = READERS if folder == "filters/io" else KERNELS
        near = [n for n in NEAR.get(folder.removesuffix("/detail"), []) if n in all_of]
        return near + [name for name in all_of if name not in near]

    def first_that_notices(self, folder):
        for program in self.order(folder):
            failed = self.run(program, 10 + 4 * self.seconds[program])
            if failed:
                return "%s: %s" % (program, failed)
        return None


class Builder:
    def __init__(self, build):
        self.build = build
        self.libraries = ["lib/libMoteKernels.so", "lib/libMoteFiltersIO.so", "tests/TestFiltersIOParser"]

    def ninja(self, targets, *options):
        return subprocess.run(["ninja", "-C", self.build, *options, *targets], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def steps(self, targets):
        text = self.ninja(targets, "-n").stdout.decode(errors="replace")
        return text.count("Building CXX object")

    def code(self):
        """What the machine would run."""
        found = hashlib.sha256()
        for name in self.libraries:
            path = os.path.join(self.build, name)
            if os.path.exists(path):
                found.update(pathlib.Path(path).read_bytes())
        return found.hexdigest()


def sites_of(source, room, at):
    """Every place of the room's files where something can be changed."""
    if at:
        places = {(name, int(line)) for name, line in (place.rsplit(":", 1) for place in at)}
        files = sorted({source / name for name, _ in places})
    else:
        folders = [room] if room else ROOMS
        files = [path for folder in folders for path in sorted((source / folder).rglob("*"))
                 if path.suffix in (".cpp", ".cxx", ".h")]
    found = []
    for path in files:
        name = path.relative_to(source).as_posix()
        found += [Site(name, change) for change in changes(path.read_text())
                  if not at or (name, change.line) in places]
    return found


def known_ones():
    """Changes that make no difference: file | line as it stands | old > new | why."""
    path = pathlib.Path(__file__).with_name("known.txt")
    lines = [line for line in path.read_text().split("\n") if line and not line.startswith("#")]
    return {tuple(part.strip() for part in line.split(" | ")[:3]) for line in lines}


class Mutations:
    def __init__(self, arguments):
        self.source = pathlib.Path(arguments.source)
        self.builder = Builder(arguments.build)
        self.tests = Tests(arguments.build)
        self.counts = collections.Counter()
        self.survivors = []
        self.known = known_ones()

    def prepare(self, sites):
        folders = {os.path.dirname(site.file) for site in sites}
        self.targets = sorted({name for folder in folders for name in self.tests.order(folder)})
        built = self.builder.ninja(self.targets)
        if built.returncode != 0:
            sys.exit("the sources do not compile as they are:\n" + built.stdout.decode()[-3000:])
        self.base = self.builder.code()
        for program in self.targets:
            failed = self.tests.run(program, 1000)
            if failed:
                sys.exit("%s fails before anything is changed: %s" % (program, failed))

    def outcome(self, site):
        if self.builder.steps(self.targets) > MOST_STEPS:
            return "left out", "many files would be compiled"
        if self.builder.ninja(self.targets).returncode != 0:
            return "no code", "does not compile"
        if self.builder.code() == self.base:
            return "same code", "the same machine code"
        noticed = self.tests.first_that_notices(os.path.dirname(site.file))
        return ("noticed", noticed) if noticed else ("survived", "")

    def attempt(self, site):
        path = self.source / site.file
        text = path.read_text()
        line = line_of(text, site.change.line)
        began = time.time()
        if (site.file, line, "%s > %s" % (site.change.old, site.change.new)) in self.known:
            kind, why = "known", "makes no difference"
        else:
            try:
                path.write_text(apply(text, site.change))
                kind, why = self.outcome(site)
            finally:
                path.write_text(text)
        self.counts[kind] += 1
        report = "%s:%d: %s > %s: %s" % (site.file, site.change.line, site.change.old,
                                         site.change.new or "nothing", kind)
        print("%s%s (%d s)\n    %s" % (report, " by " + why if kind == "noticed" else "",
                                       time.time() - began, line), flush=True)
        if kind == "survived":
            self.survivors.append("%s\n    %s" % (report, line))

    def tried(self):
        return self.counts["noticed"] + self.counts["survived"]

    def end(self):
        self.builder.ninja(self.targets)
        print("%d changes make a difference or might: %d noticed, %d survived; of the others "
              "%s" % (self.tried(), self.counts["noticed"], self.counts["survived"],
                      ", ".join("%d %s" % (self.counts[kind], kind) for kind in
                                ("same code", "known", "no code", "left out"))))
        for survivor in self.survivors:
            print(survivor)
        return 1 if self.survivors else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("source")
    parser.add_argument("build")
    parser.add_argument("--count", type=int, default=20, help="changes that make a difference")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--room", help="a folder, such as rendering/kernels/shading")
    parser.add_argument("--at", action="append", help="FILE:LINE: all changes of this line")
    arguments = parser.parse_args()
    work = Mutations(arguments)
    sites = sites_of(work.source, arguments.room, arguments.at)
    if not sites:
        sys.exit("nothing there can be changed")
    work.prepare(sites)
    if not arguments.at:
        random.Random(arguments.seed).shuffle(sites)
    for site in sites:
        if not arguments.at and work.tried() >= arguments.count:
            break
        work.attempt(site)
    sys.exit(work.end())


if __name__ == "__main__":
    main()
