#!/usr/bin/env python3
"""Measures the window as a user sees it: what changes on the screen, and when.

    xvfb-run -a -s '-screen 0 1600x1100x24 -noreset' python3 benchmarks/window/window.py \\
        build/release/bin/mote [drag] [panel] [fps] [steps] [turn] [slice] [volumesteps]
        [--volume FILE] [--slice-of FILE] [--options "..."]

drag   frames a range slider brings while it is dragged, 8 million particles
panel  frames of the panel alone, while the mouse moves over it; and what it adds to frames of a
       view of 1024x1024 that turns
fps    frames while the view turns with --fps 5, 10, 20: how many are held within 20 %
steps  from the key to the first changed pixel, 2 million particles: a time step that was read
       ahead, and one that was not but that the system has in its memory
turn   frames while a volume turns, in a view of 1024x1024 without the panel; --volume names it,
       else the pump with 129,000 cells, and --options what else the program is told
slice  frames that the slider of a slice brings while it is dragged, in a view of 1024x1024;
       --slice-of names the volume, else the pump's rotor of 1,288,000 cells
volumesteps  from the key to the first changed pixel: a time step of --volume with its walls, a
       slice and the cloud, read ahead, and in the system's memory

Needs xdotool's libraries (libX11, libXtst) and a display of 1600x1100. Prints Markdown tables.
"""

import argparse
import ctypes
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import zlib

here = pathlib.Path(__file__).resolve().parent


class Image(ctypes.Structure):  # the beginning of an XImage
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("offset", ctypes.c_int),
                ("format", ctypes.c_int), ("data", ctypes.c_void_p), ("order", ctypes.c_int * 4),
                ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int)]


class Screen:
    """The display that DISPLAY names: its pixels, its mouse, its keys."""

    def __init__(self):
        self.x11, self.xtest = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        pointer, number, long = ctypes.c_void_p, ctypes.c_int, ctypes.c_ulong
        for library, name, result, arguments in (
                (self.x11, "XOpenDisplay", pointer, [ctypes.c_char_p]),
                (self.x11, "XDefaultRootWindow", long, [pointer]),
                (self.x11, "XGetImage", ctypes.POINTER(Image),
                 [pointer, long, number, number, number, number, long, number]),
                (self.x11, "XDestroyImage", number, [pointer]),
                (self.x11, "XStringToKeysym", long, [ctypes.c_char_p]),
                (self.x11, "XKeysymToKeycode", number, [pointer, long]),
                (self.x11, "XFlush", number, [pointer]),
                (self.xtest, "XTestFakeKeyEvent", number, [pointer, number, number, long]),
                (self.xtest, "XTestFakeButtonEvent", number, [pointer, number, number, long]),
                (self.xtest, "XTestFakeMotionEvent", number,
                 [pointer, number, number, number, long])):
            function = getattr(library, name)
            function.restype, function.argtypes = result, arguments
        self.display = self.x11.XOpenDisplay(None)
        if not self.display:
            sys.exit("No display: run this under xvfb-run.")
        self.root = self.x11.XDefaultRootWindow(self.display)

    def pixels(self, x, y, width, height):
        """A fingerprint of a rectangle."""
        image = self.x11.XGetImage(self.display, self.root, x, y, width, height, 0xffffffff, 2)
        size = image.contents.bytes_per_line * height
        found = zlib.crc32(ctypes.string_at(image.contents.data, size))
        self.x11.XDestroyImage(ctypes.cast(image, ctypes.c_void_p))
        return found

    def move(self, x, y):
        self.xtest.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        self.x11.XFlush(self.display)

    def button(self, down):
        self.xtest.XTestFakeButtonEvent(self.display, 1, int(down), 0)
        self.x11.XFlush(self.display)

    def press(self, key):
        code = self.x11.XKeysymToKeycode(self.display, self.x11.XStringToKeysym(key.encode()))
        self.xtest.XTestFakeKeyEvent(self.display, code, 1, 0)
        self.xtest.XTestFakeKeyEvent(self.display, code, 0, 0)
        self.x11.XFlush(self.display)

    def still(self, rectangle, quiet=1.5, limit=60.0):
        """Waits until nothing has changed there for a while; the fingerprint."""
        last, since, start = self.pixels(*rectangle), time.time(), time.time()
        while time.time() - since < quiet and time.time() - start < limit:
            time.sleep(0.03)
            now = self.pixels(*rectangle)
            if now != last:
                last, since = now, time.time()
        return last


class Window:
    """The program, in a window of its own."""

    width, height = 1344, 1024  # of which the panel takes 320
    view = (400, 510, 860, 4)  # what is looked at of the view: x, y, width, height

    def __init__(self, screen, mote, folder, *arguments):
        self.screen = screen
        self.controls = folder / "controls"
        self.controls.write_text("")
        state = folder / "state" / "mote"
        state.mkdir(parents=True, exist_ok=True)
        (state / "state.json").write_text('{"hints": false}')
        size = [] if "--size" in arguments else ["--size", f"{self.width}x{self.height}"]
        self.process = subprocess.Popen(
            [mote, *map(str, arguments), *size],
            env={**os.environ, "MOTE_CONTROLS": str(self.controls),
                 "XDG_STATE_HOME": str(folder / "state")}, cwd=folder)
        before = screen.pixels(*self.view)
        for _ in range(600):
            if self.place("Undo") or screen.pixels(*self.view) != before:
                break
            time.sleep(0.1)
        else:
            self.close()
            sys.exit("The window does not come up.")
        screen.still(self.view, 3.0)

    def place(self, name, fx=0.5, fy=0.5):
        """A place on a control, as shares of its width and height; none where it is not there."""
        for line in self.controls.read_text().splitlines():
            parts = line.rsplit(None, 4)
            if len(parts) == 5 and parts[0] == name:
                x0, y0, x1, y1 = map(float, parts[1:])
                return int(x0 + fx * (x1 - x0)), int(y0 + fy * (y1 - y0))
        return None

    def shown(self, name):
        for _ in range(200):
            if place := self.place(name):
                return place
            time.sleep(0.05)
        self.close()
        sys.exit(f"The panel has no control {name}.")

    def inputs(self, least=0):
        """Presses and releases that the panel has seen, once it is done with at least so many."""
        for _ in range(400):
            for parts in map(str.split, self.controls.read_text().splitlines()):
                if parts[:1] == ["inputs"] and int(parts[1]) >= least and parts[2] == "0":
                    return int(parts[1])
            time.sleep(0.05)
        self.close()
        sys.exit("The panel does not settle.")

    def click(self, name):
        self.screen.move(*self.shown(name))
        time.sleep(0.3)
        before = self.inputs()
        self.screen.button(True)
        self.screen.button(False)
        self.inputs(before + 2)

    def close(self):
        self.process.terminate()
        self.process.wait()


def frames(screen, rectangle, path, seconds=6.0):
    """Times between changes of a rectangle, s, while the mouse goes to and fro along a path."""
    times, over = [], threading.Event()

    def watch():
        eyes = Screen()
        last = eyes.pixels(*rectangle)
        while not over.is_set():
            now = eyes.pixels(*rectangle)
            if now != last:
                times.append(time.time())
                last = now
            time.sleep(0.002)

    thread = threading.Thread(target=watch)
    thread.start()
    start = time.time()
    while (passed := time.time() - start) < seconds:
        share = passed % 4.0 / 2.0
        screen.move(*path(share if share < 1.0 else 2.0 - share))
        time.sleep(1 / 60)
    over.set()
    thread.join()
    # The first may have been asked for by what came before.
    return [b - a for a, b in zip(times[1:], times[2:])]


def line(first, second, y):
    return lambda share: (first + share * (second - first), y)


def row(name, gaps, more=""):
    if len(gaps) < 5:
        sys.exit(f"{name}: only {len(gaps)} frames")
    ninth = sorted(gaps)[int(0.9 * len(gaps))]
    print(f"| {name} | {len(gaps)} | {1000 * statistics.median(gaps):.0f} | {1000 * ninth:.0f} |"
          f"{more}", flush=True)


def many(folder, side):
    file = folder / f"many{side}.vtp"
    if not file.exists():
        subprocess.run([sys.executable, here / "../../tests/app/many_particles.py", file,
                        str(side)], check=True)
    return file


def measure_drag(screen, mote, folder):
    print("| dragged range, 8 M particles | frames | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    for name in ("x", "height"):
        window = Window(screen, mote, folder, many(folder, 200))
        window.click("show")
        window.click(name)
        window.shown("histogram")
        time.sleep(3.0)
        x0, y = window.place("histogram", 0.02)
        x1, _ = window.place("histogram", 0.98)
        screen.move(*window.place("histogram", 0.0))
        time.sleep(0.3)
        screen.button(True)
        gaps = frames(screen, Window.view, line(x0, x1, y))
        screen.button(False)
        window.close()
        row(name, gaps)


def measure_panel(screen, mote, folder):
    print("| the panel alone | frames | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    window = Window(screen, mote, folder, many(folder, 200))
    (x0, y), (x1, _) = window.shown("Undo"), window.shown("Command")
    gaps = frames(screen, (0, y - 8, 320, 16), line(x0, x1, y))
    window.close()
    row("mouse over its buttons", gaps)
    for _ in range(2):
        for name, left, options in (("with", 320, ()),
                                    ("without", 0, ("--no-panel", "--size", "1024x1024"))):
            window = Window(screen, mote, folder, many(folder, 126), *options)
            row(f"a view that turns {name} it", turn(screen, left))
            window.close()


def turn(screen, left):
    """Frames of a view of 1024x1024, from this column on, that the mouse turns."""
    screen.move(left + 300, 700)
    time.sleep(0.3)
    screen.button(True)
    gaps = frames(screen, (left + 80, *Window.view[1:]), line(left + 300, left + 800, 700))
    screen.button(False)
    return gaps


def measure_fps(screen, mote, folder):
    print("| turned with | frames | median, ms | nine of ten within, ms | as asked, 20 % |\n|---|---|---|---|---|")
    for side in (126, 200):
        for fps in (5, 10, 20):
            window = Window(screen, mote, folder, many(folder, side), "--fps", fps)
            gaps = turn(screen, 320)
            window.close()
            held = sum(0.8 / fps <= gap <= 1.2 / fps for gap in gaps) / len(gaps)
            late = sum(gap > 1.2 / fps for gap in gaps) / len(gaps)
            row(f"--fps {fps}, {side ** 3 / 1e6:.0f} M particles", gaps,
                f" {100 * held:.0f} % (longer: {100 * late:.0f} %) |")


def measure_steps(screen, mote, folder):
    print("| time step, 2 M particles | changes | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    files = []
    for step in range(8):
        file = folder / f"step{step}.vtp"
        if not file.exists():
            file.symlink_to(many(folder, 126 + step % 2))
        files.append(file)
    for name, cache in (("read ahead", "4G"), ("in the system's memory", "0")):
        window = Window(screen, mote, folder, *files, "--cache", cache)
        screen.move(800, 500)
        time.sleep(5.0)
        gaps = []
        for key in ["Home"] + 7 * ["Right"] + 7 * ["Left"]:
            before = screen.still(Window.view, 2.0)
            start = time.time()
            screen.press(key)
            while screen.pixels(*Window.view) == before and time.time() - start < 10.0:
                time.sleep(0.002)
            gaps.append(time.time() - start)
        window.close()
        row(name, gaps[1:])


def measure_turn(screen, mote, folder, arguments):
    print("| turned | frames | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    volume = arguments.volume
    window = Window(screen, mote, folder, volume, "--no-panel", "--size", "1024x1024", "--fps", 20,
                    *arguments.options.split())
    gaps = turn(screen, 0)
    window.close()
    row(pathlib.Path(volume).stem, gaps)


def measure_slice(screen, mote, folder, arguments):
    print("| dragged slice | frames | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    volume = arguments.slice_of
    window = Window(screen, mote, folder, volume, *arguments.options.split())
    for group in ("Data", "Colour", "Selection"):
        window.click("group " + group)
    window.click("group Slices")
    (x0, y), (x1, _) = window.place("slice z 0", 0.1), window.place("slice z 0", 0.9)
    screen.move(*window.place("slice z 0", 0.5))
    time.sleep(3.0)
    screen.button(True)
    gaps = frames(screen, Window.view, line(x0, x1, y))
    screen.button(False)
    window.close()
    row(pathlib.Path(volume).stem, gaps)


def measure_volume_steps(screen, mote, folder, arguments):
    print("| time step of a volume | changes | median, ms | nine of ten within, ms |\n|---|---|---|---|")
    for name, cache in (("read ahead", "4G"), ("in the system's memory", "0")):
        window = Window(screen, mote, folder, arguments.volume, "--cache", cache, "--step", 20, "--cloud",
                        "on", "--walls", 1, "--near-walls", 0, "--slice", "z=0.03")
        screen.move(800, 500)
        time.sleep(8.0)
        gaps = []
        for _ in range(9):
            before = screen.still(Window.view, 2.0)
            start = time.time()
            screen.press("Right")
            while screen.pixels(*Window.view) == before and time.time() - start < 10.0:
                time.sleep(0.002)
            gaps.append(time.time() - start)
        window.close()
        row(name, gaps[1:])


def main():
    parts = {"drag": measure_drag, "panel": measure_panel, "fps": measure_fps,
             "steps": measure_steps, "turn": measure_turn, "slice": measure_slice,
             "volumesteps": measure_volume_steps}
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mote", help="the program")
    parser.add_argument("parts", nargs="*", metavar="part",
                        help=f"{', '.join(parts)}; all where none is named")
    parser.add_argument("--volume", default="pump:0.02", help="what `turn` turns")
    parser.add_argument("--slice-of", default="pump:0.6:rotor", help="what `slice` slices")
    parser.add_argument("--options", default="", help="of the program, for `turn` and `slice`")
    arguments = parser.parse_args()
    wrong = [part for part in arguments.parts if part not in parts]
    if wrong:
        parser.error(f"no part {wrong[0]}: {', '.join(parts)}")
    mote = pathlib.Path(arguments.mote).resolve()
    screen = Screen()
    with tempfile.TemporaryDirectory() as folder:
        for part in arguments.parts or parts:
            more = [arguments] if part in ("turn", "slice", "volumesteps") else []
            parts[part](screen, mote, pathlib.Path(folder), *more)
            print(flush=True)


if __name__ == "__main__":
    main()
