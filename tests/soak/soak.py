#!/usr/bin/env python3
"""Works mote's window at random, on the X server that DISPLAY names, and watches its memory.

    soak.py --seed 1 --minutes 60 --folder OUT MOTE DATA...

Clicks, drags, turns the wheel, presses keys, writes into fields, resizes, undoes and opens the other
data sets: all controls that the panel says it has (MOTE_CONTROLS). A triangle mesh that it makes, and
the .mote file of it, are among the data; it begins with both, and with values over time. Each start
of the program is recorded (--record), and the recording is kept where the program crashes, hangs or
fails; then the seed, the recording and the last actions are named, and the exit code is 1. So they
are where more memory is resident than the cache and --beside, or where the last recording, played
without a display, ends with other settings than the window did. The end is a table of memory by
minute.
"""

import json
import os
import random
import re
import subprocess
import sys
import time

from hands import Trouble, Window
from replay import differences, write_mesh
from words import parser_of

# Every key of the window but q, and some that are not bound.
KEYS = """plus minus r v x y z X Y Z o f p P i Delete u ctrl+c ctrl+e j c C m bracketleft bracketright
Left Right comma period Home End space b l a g d t e k K ctrl+z ctrl+y ctrl+s Escape Tab h
Down Up Return w F5 ctrl+a""".split()
TEXTS = ["3", "-1", "0.5", "1e300", "nan", "x > 0", "type == 1", "c_centro > 2 && z <", "speed=vx*2",
         "depth=z-20", "U", "viridis", "0:10", ":5", "1=0.5", "", "none", "2,2,1", "10%", "0.5px",
         "hello", "-30,40", "#ff0000", "navy", "4", "100000", "a b c", "%.2f", "%s%n", "7:3"]
# What goes beyond the window: pictures of large sizes and films take minutes each.
RARE = ("Save film", "Picture", "Session", "Save CSV")


class Soak:
    def __init__(self, arguments):
        self.arguments = arguments
        self.random = random.Random(arguments.seed)
        self.window = None
        self.starts = 0
        self.actions = 0
        self.done = []      # what was done, in words
        self.samples = []   # seconds, actions, start, data, resident bytes
        self.slowest = 0.0
        self.begin = time.time()
        self.data = ""
        self.waiting = []   # data that were not opened since the others were

    # ---------------------------------------------------------------- the program

    def start(self):
        self.starts += 1
        folder = os.path.join(self.arguments.folder, "start-%d" % self.starts)
        os.makedirs(folder, exist_ok=True)
        self.data = self.next_data()
        options = ["--size", "1000x760", "--cache", self.arguments.cache, "--samples", "4",
                   "--lod-error", self.random.choice("014")]
        if self.arguments.record:
            options += ["--record", os.path.join(folder, "recording.jsonl")]
        self.done.append("--- start %d with %s" % (self.starts, self.data))
        self.window = Window(self.arguments.mote, [self.data], folder, options)

    def next_data(self):
        """All in turn, each time in another order; the meshes first of all."""
        if not self.waiting:
            self.waiting = self.random.sample(self.arguments.data, len(self.arguments.data))
            if self.starts <= 1 and not self.actions:
                self.waiting.sort(key=lambda name: "soak-mesh" in name)
        return self.waiting.pop()

    def end(self):
        if self.arguments.record and not self.has_stopped_recording():
            self.play_again(self.window.save_session(self.arguments.patience))
        code = self.window.quit()
        if code != 0:
            raise Trouble("exit code %d after q" % code)
        self.window.kill()

    def has_stopped_recording(self):
        """Keys reach the button for it, too. What was done afterwards is not in the recording."""
        with open(os.path.join(self.window.folder, "recording.jsonl"), errors="replace") as file:
            last = json.loads(file.readlines()[-1])
        if last["what"] == "end":
            print("the recording was stopped after %.0f s: it is not played again" % last["time"])
        return last["what"] == "end"

    def play_again(self, session):
        """What was recorded, without a display, must end as the window did."""
        played = os.path.join(self.window.folder, "played.json")
        command = [self.arguments.mote, "render", "--play", "recording.jsonl", "-o", "played.png",
                   "--save-session", played]
        with open(os.path.join(self.window.folder, "played"), "wb") as said:
            code = subprocess.run(command, cwd=self.window.folder, stdout=said, stderr=said,
                                  timeout=20 * self.arguments.patience, check=False).returncode
        if code != 0:
            raise Trouble("exit code %d of %s" % (code, " ".join(command)))
        found = differences(session, played)
        if found:
            raise Trouble("played again, it ends with other settings (window, played):\n  " +
                          "\n  ".join(found))

    def sample(self):
        self.samples.append((time.time() - self.begin, self.actions, self.starts, self.data,
                             self.window.memory()))
        most = bytes_of(self.arguments.cache) + bytes_of(self.arguments.beside)
        if self.samples[-1][-1] > most:
            raise Trouble("%d MiB are resident, more than cache and --beside, %d MiB" % (
                self.samples[-1][-1] / 2**20, most / 2**20))

    # ---------------------------------------------------------------- what is done

    def place_in_view(self):
        width, height = self.window.size()
        return (self.random.randint(min(330, width // 2), max(331, width - 1)),
                self.random.randint(0, max(1, height - 1)))

    def control(self):
        # What is recorded is compared with the window at the end, and has to go on until then.
        controls = [c for c in self.window.controls()
                    if c[3] > c[1] and c[4] > c[2] and c[0] != "Stop recording"]
        width, height = self.window.size()
        controls = [c for c in controls if 0 <= c[1] < width and 0 <= c[2] < height]
        chosen = self.random.choice(controls) if controls else None
        if chosen and chosen[0] in RARE and self.random.random() > 0.1:
            return None
        return chosen

    def spot_on(self, control):
        _, left, top, right, bottom = control
        return (left + int(self.random.random() * (right - left)),
                top + int(self.random.random() * (bottom - top)))

    def click(self):
        control = self.control()
        if not control:
            return "nothing to click"
        # Lists and headers have their marks at the left.
        x, y = self.spot_on(control)
        if self.random.random() < 0.3:
            x = min(control[1] + 8, control[3])
        repeat = "2" if self.random.random() < 0.1 else "1"
        self.window.xdo("mousemove", str(x), str(y), "sleep", "0.02",
                        "click", "--repeat", repeat, "--delay", "60", "1")
        return "click %s at %d %d" % (control[0], x, y)

    def drag(self, button, places, held=()):
        words = ["mousemove", *map(str, places[0])]
        for key in held:
            words += ["keydown", key]
        words += ["sleep", "0.02", "mousedown", button]
        for place in places[1:]:
            words += ["mousemove", *map(str, place), "sleep", "0.02"]
        words += ["mouseup", button]
        for key in held:
            words += ["keyup", key]
        self.window.xdo(*words)

    def drag_control(self):
        control = self.control()
        if not control:
            return "nothing to drag"
        places = [self.spot_on(control)]
        for _ in range(self.random.randint(2, 8)):
            wide = list(control)
            if self.random.random() < 0.2:
                wide = [control[0], control[1] - 60, control[2] - 40, control[3] + 60,
                        control[4] + 40]
            places.append(tuple(max(0, n) for n in self.spot_on(wide)))
        self.drag("1", places)
        return "drag %s from %s to %s" % (control[0], places[0], places[-1])

    def drag_view(self):
        button = self.random.choice("11123")
        held = self.random.choice([(), (), ("Shift_L",), ("Control_L",)])
        places = [self.place_in_view() for _ in range(self.random.randint(2, 5))]
        self.drag(button, places, held)
        return "drag in the view: button %s %s %s" % (button, " ".join(held), places)

    def click_view(self):
        held = self.random.choice([(), (), ("Shift_L",)])
        place = self.place_in_view()
        self.drag("1", [place], held)
        return "click in the view at %d %d %s" % (*place, " ".join(held))

    def wheel(self):
        x, y = self.place_in_view()
        if self.random.random() < 0.6:
            x = self.random.randint(0, 300)
        button = self.random.choice("45")
        times = str(self.random.randint(1, 12))
        self.window.xdo("mousemove", str(x), str(y), "click", "--repeat", times, "--delay", "10",
                        button)
        return "wheel %s %s times at %d %d" % (button, times, x, y)

    def keys(self):
        keys = [self.random.choice(KEYS) for _ in range(self.random.randint(1, 4))]
        self.window.xdo("key", "--window", "0", *keys)
        return "keys " + " ".join(keys)

    def undo(self):
        key = self.random.choice(["ctrl+z", "ctrl+z", "ctrl+y"])
        keys = [key] * self.random.randint(1, 6)
        self.window.xdo("key", "--window", "0", *keys)
        return "keys " + " ".join(keys)

    def write(self):
        control = self.control()
        if not control:
            return "nowhere to write"
        text = self.random.choice(TEXTS)
        x, y = self.spot_on(control)
        self.window.xdo("mousemove", str(x), str(y), "sleep", "0.02", "click", "1", "sleep", "0.1",
                        "key", "--window", "0", "ctrl+a")
        self.window.xdo("type", "--window", "0", "--delay", "5", "--", text)
        self.window.xdo("key", "--window", "0", self.random.choice(["Return", "Return", "Escape",
                                                                    "Tab"]))
        return "write %r into %s" % (text, control[0])

    def resize(self):
        size = self.random.choice([(1000, 760), (1200, 900), (640, 400), (200, 150), (1000, 300),
                                   (self.random.randint(100, 1270), self.random.randint(100, 1000))])
        self.window.xdo("windowsize", self.window.window, *map(str, size))
        return "resize to %dx%d" % size

    def open(self):
        self.data = self.next_data()
        is_added = self.random.random() < 0.1
        self.window.open(self.data, is_added)
        return "open %s%s" % (self.data, " beside" if is_added else "")

    def rest(self):
        place = self.place_in_view()
        self.window.xdo("mousemove", *map(str, place), "sleep", "0.8")
        return "rest at %d %d" % place

    def named(self, name):
        return next((c for c in self.window.controls() if c[0] == name), None)

    def press_control(self, name):
        control = self.named(name)
        if control:
            self.window.xdo("mousemove", *map(str, self.spot_on(control)), "sleep", "0.02", "click", "1",
                            "sleep", "0.3")
        return control is not None

    def plot_over_time(self):
        """Of what is at a place in the view, where there is something."""
        self.click_view()
        time.sleep(0.5)
        if not self.named("Plot over time"):
            self.press_control("group Picked")
        return "plot over time: " + ("yes" if self.press_control("Plot over time") else "nothing is picked")

    def lower_detail(self):
        for group in ("group Picture", "group Colour", "group Selection"):
            if not self.named("lod-error"):
                self.press_control(group)  # which makes room, or brings it
        control = self.named("lod-error")
        if not control:
            return "no --lod-error in sight"
        places = [self.spot_on(control) for _ in range(3)]
        self.drag("1", places)
        return "drag lod-error from %s to %s" % (places[0], places[-1])

    def tour(self):
        """What half a minute at random would miss: meshes, their details, values over time."""
        for kind in (self.lower_detail, self.drag_view, self.open, self.lower_detail, self.click_view,
                     self.open, self.plot_over_time):
            self.note(kind)
            self.window.ask(self.arguments.patience)

    def note(self, kind):
        self.done.append("%6d %7.1f s  %s" % (self.actions, time.time() - self.begin, kind()))
        self.actions += 1

    def act(self):
        kinds = [(self.click, 30), (self.drag_control, 14), (self.drag_view, 8),
                 (self.click_view, 6), (self.wheel, 10), (self.keys, 16), (self.undo, 4),
                 (self.write, 8), (self.resize, 2), (self.open, 1.2), (self.rest, 1),
                 (self.plot_over_time, 1), (self.lower_detail, 1)]
        kind = self.random.choices([k for k, _ in kinds], [w for _, w in kinds])[0]
        self.note(kind)

    # ---------------------------------------------------------------- the whole

    def run(self):
        end = self.begin + 60.0 * self.arguments.minutes
        self.start()
        self.tour()
        while time.time() < end:
            self.act()
            if self.window.has_ended():
                # By a q that went to the view and not into a field: only that ends it so.
                if self.window.process.returncode != 0:
                    self.window.require_running()
                self.window.kill()
                self.start()
            elif self.actions % 12 == 0:
                taken = self.window.ask(self.arguments.patience)
                if taken > 20.0:
                    self.done.append("answered after %.0f s" % taken)
                self.slowest = max(self.slowest, taken)
                self.sample()
        self.window.ask(self.arguments.patience)
        self.sample()
        self.end()

    def tell_memory(self):
        print("minute  actions  start  resident MiB (least, most)  data at its end")
        by_minute = {}
        for seconds, actions, start, data, memory in self.samples:
            by_minute.setdefault(int(seconds // 60), []).append((actions, start, data, memory))
        for minute, rows in sorted(by_minute.items()):
            memory = [row[3] / 2.0**20 for row in rows]
            actions, start, data, _ = rows[-1]
            print("%6d %8d %6d %13.0f %13.0f  %s" % (minute + 1, actions, start, min(memory),
                                                   max(memory), os.path.basename(data)))
        print("%d actions, %d starts, slowest answer %.1f s" % (self.actions, self.starts,
                                                               self.slowest))


def bytes_of(text):
    number, unit = re.fullmatch(r"([0-9.]+)([KMG]?)", text).groups()
    return float(number) * {"": 1, "K": 2**10, "M": 2**20, "G": 2**30}[unit]


def with_meshes(arguments):
    """A mesh and the .mote file of it, besides the data that are given."""
    mesh = os.path.join(arguments.folder, "soak-mesh.ply")
    file = os.path.join(arguments.folder, "soak-mesh.mote")
    write_mesh(mesh)
    subprocess.run([arguments.mote, "convert", mesh, file], stdout=subprocess.DEVNULL, check=True)
    return arguments.data + [mesh, file]


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--folder", required=True, help="for recordings and what the program says")
    parser.add_argument("--cache", default="200M", help="of the program")
    parser.add_argument("--beside", default="1100M", help="memory that the program may take besides "
                        "the cache: itself, OpenGL in software, the data that are shown, and the "
                        "next ones while they are read")
    parser.add_argument("--patience", type=float, default=180.0, help="seconds for an answer")
    parser.add_argument("--no-record", dest="record", action="store_false")
    arguments = parser.parse_args()
    arguments.folder = os.path.abspath(arguments.folder)
    arguments.mote = os.path.abspath(arguments.mote)
    # What is no file is made by the program, such as pump:0.02.
    arguments.data = [os.path.abspath(name) if os.path.exists(name) else name
                      for name in arguments.data]
    os.makedirs(arguments.folder, exist_ok=True)
    arguments.data = with_meshes(arguments)
    soak = Soak(arguments)
    code = 0
    try:
        soak.run()
    except Trouble as trouble:
        code = 1
        print("FAILED with --seed %d: %s" % (arguments.seed, trouble))
        if soak.window:
            if not soak.window.has_ended():
                print("stacks of the program: " + soak.window.diagnose())
            print("recording: " + os.path.join(soak.window.folder, "recording.jsonl"))
            with open(os.path.join(soak.window.folder, "err"), errors="replace") as file:
                print("".join(file.readlines()[-10:]), end="")
        print("\n".join(soak.done[-25:]))
    finally:
        if soak.window:
            soak.window.kill()
        with open(os.path.join(arguments.folder, "actions"), "w") as file:
            file.write("\n".join(soak.done) + "\n")
    soak.tell_memory()
    return code


if __name__ == "__main__":
    sys.exit(main())
