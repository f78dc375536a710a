#!/usr/bin/env python3
"""Makes calls of mote to the system fail, one at a time, and asks what became of its files.

    faults.py --library LIBRARY --folder FOLDER [--case NAME] [--most N] MOTE DATA

Each case is a command. It runs once as it is, and tells each place of the program that opens, reads,
writes, flushes, renames, links or maps a file of the case, or takes a large block of memory. Then it
runs for each of these places: once where the first call fails, and once where all fail from there on.
Each time it must end in good order: with success and the same results as before, or with exit code 1,
a sentence, the old files as they were, and nothing left over. Where it writes it is killed, too, and
each file must be old or new as a whole. The exit code is 1 where something is not so.
"""

import argparse
import collections
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys

OLD = b"what stood here before\n"
# VTK's reader of PLY ends the program where a file ends before it should, and that of XML leaves out
# the time where it cannot be read. Mote's checks have read the whole file then, and told of it.
NOT_OURS = ("mesh.ply", "swirl.0.vtu")
# Data of the cases are small: so are the blocks of memory that count.
LARGE = 1 << 20

# When a picture was made, in its header.
MOMENT = re.compile(rb"\d{4}:\d\d:\d\d \d\d:\d\d:\d\d")
TIME = re.compile(r"[0-9][0-9.,]* (ms|s|min|million a second)\b")

Case = collections.namedtuple("Case", "name inputs words outputs")
SMALL = " --size 200x150 --samples 1"
CASES = [
    Case("convert", ["hopper.dump.gz"], "convert hopper.dump.gz out.mote", ["out.mote"]),
    Case("convert-text", ["hopper.dump"], "convert hopper.dump out.mote", ["out.mote"]),
    Case("convert-pieces", ["hopper.dump"], "convert hopper.dump out.mote --memory 1K",
         ["out.mote"]),
    Case("convert-mesh", ["mesh.ply"], "convert mesh.ply out.mote", ["out.mote"]),
    Case("convert-vtp", ["hopper.dump"], "convert hopper.dump --show x=0: out.vtp", ["out.vtp"]),
    Case("convert-vtu", ["swirl.0.vtu"], "convert swirl.0.vtu --show x=0: out.vtu", ["out.vtu"]),
    Case("convert-vtm", ["hopper.dump", "swirl.0.vtu"], "convert hopper.dump swirl.0.vtu out.vtm",
         ["out.vtm", "out/out_0.vtp", "out/out_1.vtu"]),
    Case("convert-xyz", ["hopper.dump"], "convert hopper.dump out.xyz.gz", ["out.xyz.gz"]),
    Case("render", ["hopper.dump"], "render hopper.dump -o out.png --shadows hard "
         "--save-session out.json" + SMALL, ["out.png", "out.json"]),
    Case("render-large", [], "render random:200000:0.01 -o out.exr" + SMALL, ["out.exr"]),
    Case("render-mote", ["hopper.mote"], "render hopper.mote -o out.png" + SMALL, ["out.png"]),
    Case("render-volume", ["swirl.0.vtu"], "render swirl.0.vtu -o out.png" + SMALL, ["out.png"]),
    Case("render-mesh", ["mesh.ply"], "render mesh.ply -o out.jpg" + SMALL, ["out.jpg"]),
    Case("session", ["hopper.dump", "session.json"], "render session.json -o out.png", ["out.png"]),
    Case("bake", ["hopper.mote"], "bake hopper.mote -o out.moteao --samples 4", ["out.moteao"]),
    Case("film", ["hopper.mote"], "animate hopper.mote -o out.ogv --orbit 9 --frames 3" + SMALL,
         ["out.ogv"]),
    Case("info", ["hopper.dump", "swirl.0.vtu", "mesh.ply"],
         "info hopper.dump swirl.0.vtu mesh.ply", []),
    Case("average", ["swirl.0.vtu"], "average swirl.0.vtu --array p -o out.csv --resolution 20",
         ["out.csv"]),
    Case("average-svg", ["swirl.0.vtu"], "average swirl.0.vtu --array p -o out.svg --resolution 20",
         ["out.svg"]),
    Case("probe", ["swirl.0.vtu"], "probe swirl.0.vtu --from -0.01,0,0 --to 0.01,0,0.05 -o out.csv",
         ["out.csv"]),
    Case("integrate", ["swirl.0.vtu"], "integrate swirl.0.vtu --boundary -o out.json",
         ["out.json"]),
]

# Every fsync fails. The first is that of the result; that of its folder comes later, and may fail.
NO_FSYNC = "fsync:1+"

Result = collections.namedtuple("Result", "code said told files left")


def content_of(path):
    """What is the same whenever it is written. Films have numbers at random in their pages."""
    if not path.exists():
        return None
    content = MOMENT.sub(b"a moment", path.read_bytes())
    return content if path.suffix != ".ogv" or content == OLD else b"%d bytes" % len(content)


class Faults:
    def __init__(self, arguments):
        self.arguments = arguments
        self.folder = pathlib.Path(arguments.folder).resolve()
        self.mote = os.path.abspath(arguments.mote)
        self.environment = dict(os.environ, HOME=str(self.folder / "home"),
                                XDG_CONFIG_HOME=str(self.folder / "home"), LC_ALL="C")
        for name in ("MOTE_FAULT", "MOTE_FAULT_LOG"):
            self.environment.pop(name, None)
        self.runs = 0
        self.wrong = []

    def make_inputs(self):
        """What the cases read, made once from the bundled data."""
        self.inputs = self.folder / "inputs"
        self.inputs.mkdir(parents=True)
        data = pathlib.Path(self.arguments.data).resolve()
        for name in ("hopper.dump.gz", "swirl.0.vtu"):
            shutil.copy(data / name, self.inputs / name)
        with open(self.inputs / "hopper.dump", "wb") as file:
            subprocess.run(["gzip", "-dc", self.inputs / "hopper.dump.gz"], stdout=file, check=True)
        sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "soak"))
        from replay import write_mesh
        write_mesh(self.inputs / "mesh.ply", rows=90)
        for words in ("convert hopper.dump hopper.mote",
                      "render hopper.dump -o session.png --size 64x48 --samples 1 "
                      "--save-session session.json"):
            subprocess.run([self.mote, *words.split()], cwd=self.inputs, env=self.environment,
                           check=True, stdout=subprocess.DEVNULL)

    def run(self, case, fault=None, log=None):
        """The case in a folder of its own, which has old files in place of results."""
        place = self.folder / "run"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        for name in case.inputs:
            shutil.copy(self.inputs / name, place / name)
            (place / name).chmod(0o444)  # which the injector knows them by
        for name in case.outputs:
            (place / name).parent.mkdir(exist_ok=True)
            (place / name).write_bytes(OLD)
        environment = dict(self.environment, LD_PRELOAD=self.arguments.library,
                           MOTE_FAULT_IN=str(place), MOTE_FAULT_BYTES=str(LARGE))
        if fault:
            environment["MOTE_FAULT"] = fault
        if log:
            environment["MOTE_FAULT_LOG"] = log
        # Full paths are what the injector knows.
        words = [str(place / word) if word in case.inputs + case.outputs else word
                 for word in case.words.split()]
        self.runs += 1
        try:
            done = subprocess.run([self.mote, *words], cwd=place, env=environment, timeout=100,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            code, told = done.returncode, done.stderr.decode(errors="replace")
            said = TIME.sub("some time", done.stdout.decode(errors="replace"))
        except subprocess.TimeoutExpired:
            code, said, told = "no end", "", ""
        files = {name: content_of(place / name) for name in case.outputs}
        there = {str(p.relative_to(place)) for p in place.rglob("*") if not p.is_dir()}
        left = sorted(there - set(case.inputs) - set(case.outputs))
        return Result(code, said, told, files, left)

    def places(self, case):
        """The first call of each kind from each place of the program."""
        log = self.folder / "log"
        log.unlink(missing_ok=True)
        good = self.run(case, log=str(log))
        if good.code != 0 or good.left:
            sys.exit("%s fails without a fault: %s" % (case.name, good))
        found = {}
        for line in log.read_text().split("\n") if log.exists() else []:
            if line:
                call, number, place = line.split()
                found.setdefault((call, place), int(number))
        again = self.run(case)
        self.alike = again.files == good.files and again.said == good.said
        return good, [(call, number) for (call, _), number in found.items()
                      if call != "read" or not set(case.inputs) & set(NOT_OURS)]

    def judge(self, good, got, is_cut):
        """None, or what is wrong."""
        lines = [line for line in got.told.split("\n") if line]
        if got.left:
            return "left over: " + " ".join(got.left)
        # A file that was cut before it was opened for good gives what it has then.
        if got.code == 0 and is_cut and "damaged" in got.told:
            return None
        if got.code == 0:
            if got.said != good.said:
                return "success, but it said something else"
            for name, content in got.files.items():
                if content != good.files[name] and (self.alike or content in (OLD, None)):
                    return "success, but %s is not what it was" % name
            return None
        if got.code != 1:
            return "exit code %s" % got.code
        if not lines or not lines[-1].startswith("mote: "):
            return "no sentence"
        for name, content in got.files.items():
            # Of two results the first may stand before the second fails.
            if content != OLD and (self.alike and content != good.files[name] or
                                   len(got.files) == 1):
                return "failure, but %s is not the old one" % name
        return None

    def some_of(self, places):
        """Spread over all, which come in the order of the first call."""
        most = len(places) if os.environ.get("MOTE_TEST_ALL") else self.arguments.most
        return places[::max(1, -(-len(places) // most))]

    def judge_killed(self, good, got):
        if got.code != -signal.SIGKILL:
            return None if got.code in (0, 1) else "exit code %s" % got.code  # no such call this time
        left = [name for name in got.left if ".part." not in name and ".new." not in name
                and not os.path.basename(name).startswith(".mote-")]
        if left:
            return "left over: " + " ".join(left)
        for name, content in got.files.items():
            if content != OLD and (content != good.files[name] if self.alike else not content):
                return "killed, and %s is neither old nor new" % name
        return None

    def attempt(self, case, good, fault):
        got = self.run(case, fault)
        wrong = (self.judge_killed(good, got) if fault.endswith("!") else
                 self.judge(good, got, fault.startswith("cut")))
        if fault == NO_FSYNC and got.code == 0:
            wrong = "success, but nothing came to the disk for sure"
        if self.arguments.verbose or wrong:
            print("%s %s: %s %s" % (case.name, fault, wrong or "in order, exit code %s" % got.code,
                                    got.told.strip()[-300:]), flush=True)
        if wrong:
            self.wrong.append((case.name, fault, wrong))

    def work(self):
        self.make_inputs()
        for case in CASES:
            if self.arguments.case and case.name not in self.arguments.case.split(","):
                continue
            good, places = self.places(case)
            counts = collections.Counter(call for call, _ in places)
            differ = "" if self.alike else " (results differ from run to run)"
            print("%s%s: %s" % (case.name, differ, ", ".join(
                "%d x %s" % (n, call) for call, n in sorted(counts.items()))), flush=True)
            if counts["fsync"]:
                self.attempt(case, good, NO_FSYNC)
            for call, number in self.some_of(places):
                self.attempt(case, good, "%s:%d" % (call, number))
                self.attempt(case, good, "%s:%d+" % (call, number))
                if call in ("write", "fsync", "rename", "link"):
                    self.attempt(case, good, "%s:%d!" % (call, number))
        print("%d runs, %d of them in disorder" % (self.runs, len(self.wrong)))
        return 1 if self.wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--library", required=True)
    parser.add_argument("--folder", required=True, help="is made anew")
    parser.add_argument("--case", help="names between commas")
    parser.add_argument("--most", type=int, default=1000000,
                        help="places of a case that are tried; all where MOTE_TEST_ALL is set")
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("mote")
    parser.add_argument("data")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    sys.exit(Faults(arguments).work())


if __name__ == "__main__":
    main()
