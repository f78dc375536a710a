#!/usr/bin/env python3
"""Runs mote's commands with options, values and files at random, out of the table of settings.

    commands.py --seed 1 --minutes 60 --folder OUT MOTE DATA...

Each command must end by itself, or soon after Ctrl-C where it takes long: with success and what it
was to write, or with exit code 1 or 2 and a sentence; within the memory that is allowed, and with
nothing left over. Some run twice, and must write the same. A command that does not is printed so that
a shell takes it, and the exit code is 1.
"""

import collections
import os
import random
import shlex
import shutil
import signal
import subprocess
import sys
import time

from replay import write_mesh
from table import options_of, value
from words import parser_of

COMMANDS = {"render": ".png .jpg .tif .exr", "animate": ".ogv .png", "convert": ".mote", "info": "",
            "average": ".csv .png .svg", "bake": ".moteao", "integrate": ".csv .json .svg",
            "probe": ".csv .svg"}
# Groups of settings that a command takes besides its own.
GROUPS = {"render": None, "animate": None, "convert": ["Data", "Radius"], "info": ["Data"],
          "average": ["Data", "Colour"], "bake": ["Data", "Radius"], "integrate": ["Data"],
          "probe": ["Data"]}
MADE = ["random:2000:0.02", "lattice:8", "varied:500", "pump:0.03", "pump:0.03:rotor"]


class Commands:
    def __init__(self, arguments):
        self.arguments = arguments
        self.random = random.Random(arguments.seed)
        self.begin = time.time()
        self.codes = collections.Counter()
        self.most = 0
        self.wrong = 0
        table = subprocess.run([arguments.mote, "help", "--format", "markdown"], check=True,
                               stdout=subprocess.PIPE).stdout.decode()
        self.groups = options_of(table)
        self.files = MADE + arguments.data + self.make_files()

    def make_files(self):
        """A mesh, its .mote file, and what is wrong with files."""
        folder = os.path.join(self.arguments.folder, "files")
        os.makedirs(folder)
        write_mesh(os.path.join(folder, "mesh.ply"), rows=30)
        subprocess.run([self.arguments.mote, "convert", "mesh.ply", "mesh.mote"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
        for path in [*self.arguments.data, os.path.join(folder, "mesh.ply")]:
            with open(path, "rb") as file:
                whole = file.read()
            name, _, ending = os.path.basename(path).partition(".")
            with open(os.path.join(folder, name + " cut." + ending), "wb") as file:
                file.write(whole[:self.random.randrange(len(whole))])
        os.mkdir(os.path.join(folder, "folder.vtu"))
        with open(os.path.join(folder, "-empty.xyz"), "wb"):
            pass
        return [os.path.join(folder, name) for name in sorted(os.listdir(folder))] + ["missing.dump"]

    # ---------------------------------------------------------------- a command line

    def make(self):
        command = self.random.choice(["render"] * 6 + list(COMMANDS))
        groups = GROUPS[command] or [g for g in self.groups if not g.startswith("mote")]
        options = [o for g in groups + ["mote " + command] for o in self.groups.get(g, [])]
        words = [command]
        count = self.random.choice([0, 1, 1, 2, 3, 5])
        for option in self.random.sample(options, min(count, len(options))):
            values = value(option, self.random)
            if len(values) == 1:
                words.append("%s=%s" % (option.name, values[0]))
            else:
                words += [option.name, *values]
        if GROUPS[command] is None:
            words += ["--size", self.random.choice(["64x48", "160x120", "1x1", "301x7"])]
        if command == "animate":
            words += ["--frames", "3"]
        if command in ("average", "integrate") and self.random.random() < 0.8:
            words += ["--array", self.random.choice(["p", "U", "pressure", "velocity"])]
        if command == "probe" and self.random.random() < 0.8:
            words += ["--from", "0,0,0", "--to", "0.1,0.1,0.1"]
        words += self.random.choices(self.files, k=self.random.choice([1, 1, 1, 1, 2, 0]))
        output = None
        if COMMANDS[command]:
            output = "out" + self.random.choice(COMMANDS[command].split())
            words += [output] if command == "convert" else ["-o", output]
        return words, output

    # ---------------------------------------------------------------- and what it does

    def run(self, words, place):
        shutil.rmtree(place, ignore_errors=True)
        os.makedirs(place)
        with open(place + ".said", "w+b") as said, open(place + ".told", "w+b") as told:
            child = subprocess.Popen([self.arguments.mote, *words], cwd=place, stdout=said,
                                     stderr=told, env=dict(os.environ, DISPLAY=""))
            code, late = None, False
            end = time.time() + self.arguments.patience
            while code is None:
                pid, status, usage = os.wait4(child.pid, os.WNOHANG)
                if pid:
                    code = os.waitstatus_to_exitcode(status)
                elif time.time() > end + 30:
                    child.kill()
                elif time.time() > end and not late:
                    late = True
                    child.send_signal(signal.SIGINT)
                else:
                    time.sleep(0.01)
            child.returncode = code
            told.seek(0)
            lines = [line for line in told.read().decode(errors="replace").split("\n") if line]
        return code, late, lines, usage.ru_maxrss / 1024

    def judge(self, words, output, place):
        code, late, lines, memory = self.run(words, place)
        self.codes["late" if late else code] += 1
        self.most = max(self.most, memory)
        left = sorted(os.listdir(place))
        strange = [name for name in left if not name.startswith("out")]
        if strange:
            return "left over: %s" % strange
        if memory > self.arguments.memory:
            return "%d MiB" % memory
        if late:
            return None if code in (130, 0, 1, 2) else "exit code %s after Ctrl-C" % code
        if code not in (0, 1, 2):
            return "exit code %s" % code
        if code == 0 and output and words[0] != "bake" and not left:
            return "success, and no file"
        if code != 0 and not (lines and lines[-1].startswith("mote: ")):
            return "exit code %s without a sentence: %s" % (code, lines[-3:])
        if code != 0 and left:
            return "exit code %s, and a file" % code
        if code == 0 and output and self.random.random() < 0.1:
            return self.compare(words, place, left)
        return None

    def compare(self, words, place, names):
        """A second time must write the same, but for the moment in a header."""
        if output_differs_by_time(names):
            return None
        again = place + "-again"
        self.run(words, again)
        for name in names:
            with open(os.path.join(place, name), "rb") as one:
                with open(os.path.join(again, name), "rb") as other:
                    if one.read() != other.read():
                        return "%s is another the second time" % name
        return None

    def work(self):
        place = os.path.join(self.arguments.folder, "place")
        runs = 0
        while time.time() < self.begin + 60.0 * self.arguments.minutes:
            words, output = self.make()
            wrong = self.judge(words, output, place)
            runs += 1
            if wrong:
                self.wrong += 1
                print("%s\n    %s" % (wrong, shlex.join(["mote", *words])), flush=True)
        print("%d commands: %s; at most %d MiB; %d in disorder" % (
            runs, ", ".join("%d %s" % (n, "were interrupted" if code == "late" else
                                       "with exit code %s" % code)
                            for code, n in sorted(self.codes.items(), key=str)), self.most,
            self.wrong))
        return 1 if self.wrong else 0


def output_differs_by_time(names):
    return any(name.endswith((".exr", ".ogv", ".tif")) for name in names)


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--folder", required=True, help="is made anew")
    parser.add_argument("--memory", type=float, default=1500.0, help="MiB that a command may take")
    parser.add_argument("--patience", type=float, default=20.0, help="seconds until Ctrl-C")
    arguments = parser.parse_args()
    arguments.folder = os.path.abspath(arguments.folder)
    arguments.mote = os.path.abspath(arguments.mote)
    arguments.data = [os.path.abspath(name) for name in arguments.data]
    shutil.rmtree(arguments.folder, ignore_errors=True)
    os.makedirs(arguments.folder)
    return Commands(arguments).work()


if __name__ == "__main__":
    sys.exit(main())
