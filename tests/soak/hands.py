"""A mote that runs in a folder of its own, and hands that work its window through xdotool."""

import os
import re
import signal
import subprocess
import time


class Trouble(Exception):
    """The program crashed, hung or failed: a sentence."""


class Window:
    """The program with its window; MOTE_CONTROLS tells where the panel's controls are."""

    def __init__(self, mote, files, folder, options):
        self.folder = folder
        self.controls_file = os.path.join(folder, "controls")
        state = os.path.join(folder, "state")
        os.makedirs(state, exist_ok=True)
        open(self.controls_file, "w").close()
        environment = dict(os.environ, MOTE_CONTROLS=self.controls_file, XDG_STATE_HOME=state)
        self.out = open(os.path.join(folder, "out"), "ab")
        self.err = open(os.path.join(folder, "err"), "ab")
        self.process = subprocess.Popen([mote, *files, *options], cwd=folder, env=environment,
                                        stdin=subprocess.DEVNULL, stdout=self.out, stderr=self.err)
        self.window = None
        self.await_window()

    def await_window(self, limit=120):
        end = time.time() + limit
        while time.time() < end:
            found = self.xdo("search", "--onlyvisible", "--pid", str(self.process.pid),
                             "--name", "^Mote - ").split()
            if found:
                self.window = found[0]
                self.xdo("windowfocus", self.window)
                return
            self.require_running()
            time.sleep(0.1)
        raise Trouble("no window after %d s" % limit)

    @staticmethod
    def xdo(*words):
        return subprocess.run(["xdotool", *words], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, check=False).stdout.decode()

    def has_ended(self):
        return self.process.poll() is not None

    def require_running(self):
        code = self.process.poll()
        if code is not None:
            raise Trouble("the program ended with " + ("signal %d" % -code if code < 0 else
                                                       "exit code %d" % code))

    def memory(self):
        """Resident bytes; 0 after the end."""
        try:
            with open("/proc/%d/statm" % self.process.pid) as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        except (OSError, IndexError):
            return 0

    def controls(self):
        """Name, left, top, right and bottom of each control that is in sight."""
        found = []
        try:
            with open(self.controls_file, errors="replace") as file:
                lines = file.read().splitlines()
        except OSError:
            return found
        for line in lines:
            match = re.match(r"(.*) (-?\d+) (-?\d+) (-?\d+) (-?\d+)$", line)
            if match and not line.startswith("active "):
                found.append((match[1], *(int(n) for n in match.groups()[1:])))
        return found

    def size(self):
        text = self.xdo("getwindowgeometry", "--shell", self.window)
        found = dict(re.findall(r"(WIDTH|HEIGHT)=(\d+)", text))
        return int(found.get("WIDTH", 0)), int(found.get("HEIGHT", 0))

    def lines_of_commands(self):
        with open(os.path.join(self.folder, "out"), "rb") as file:
            return file.read().count(b"\nmote ")

    def ask(self, limit):
        """Waits until all that was done is answered: has the view's command printed."""
        start = time.time()
        before = self.lines_of_commands()
        pressed = 0.0
        while self.lines_of_commands() == before:
            self.require_running()
            # Lists, fields and dialogs take keys first; one Escape leaves one of them.
            if time.time() > pressed + (2.0 if time.time() < start + 10 else 10.0):
                self.xdo("key", "--window", "0", "Escape", "Escape", "Escape")
                self.xdo("key", "--window", "0", "k")
                pressed = time.time()
            if time.time() > start + limit:
                raise Trouble("the program did not answer for %d s" % limit)
            time.sleep(0.02)
        return time.time() - start

    def sessions(self):
        return {name for name in os.listdir(self.folder) if name.endswith(".json")}

    def save_session(self, limit):
        """Has the window save its session, and returns the file."""
        self.ask(limit)  # which leaves lists and fields
        before = self.sessions()
        self.xdo("key", "--window", "0", "ctrl+s")
        end = time.time() + limit
        while self.sessions() == before:
            self.require_running()
            if time.time() > end:
                raise Trouble("no session was saved")
            time.sleep(0.1)
        self.ask(limit)
        # One that was asked for before may have come since: the last is this one.
        found = [os.path.join(self.folder, name) for name in self.sessions() - before]
        return max(found, key=lambda file: os.stat(file).st_mtime_ns)

    def diagnose(self):
        """What the program is at, for whoever looks for the reason of a hang."""
        path = os.path.join(self.folder, "stacks")
        with open(path, "w") as file:
            try:
                subprocess.run(["gdb", "-batch", "-p", str(self.process.pid), "-ex",
                                "thread apply all backtrace 30"], stdout=file,
                               stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL, timeout=120,
                               check=False)
            except (OSError, subprocess.TimeoutExpired):
                file.write("no gdb\n")
        return path

    def open(self, path, is_added):
        """By the list of folders and files."""
        self.xdo("key", "--window", "0", "Escape", "Escape", "ctrl+o")
        end = time.time() + 20
        while not any(control[0] == "Cancel" for control in self.controls()):
            self.require_running()
            if time.time() > end:
                return
            time.sleep(0.05)
        self.xdo("type", "--window", "0", "--delay", "5", "--", path)
        self.xdo("key", "--window", "0", "ctrl+Return" if is_added else "Return")

    def quit(self, limit=60):
        """Leaves by the key, and returns the exit code."""
        end = time.time() + limit
        while not self.has_ended():
            self.xdo("key", "--window", "0", "Escape", "Escape", "Escape")
            self.xdo("key", "--window", "0", "q")
            try:
                self.process.wait(2.0)
            except subprocess.TimeoutExpired:
                if time.time() > end:
                    raise Trouble("the program did not end after q") from None
        return self.process.returncode

    def kill(self):
        if not self.has_ended():
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.out.close()
        self.err.close()
