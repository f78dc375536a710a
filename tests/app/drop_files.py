#!/usr/bin/env python3
"""drop_files.py WINDOW FILE...: drops files on an X window, as a file manager does (XDND)."""
import ctypes
import os
import sys
import time

x11 = ctypes.CDLL("libX11.so.6")
Event = ctypes.c_long * 24  # an XEvent, of which a long is an element
x11.XOpenDisplay.restype = ctypes.c_void_p
x11.XDefaultRootWindow.restype = x11.XCreateSimpleWindow.restype = ctypes.c_ulong
x11.XInternAtom.restype = ctypes.c_ulong
display = ctypes.c_void_p(x11.XOpenDisplay(None))
target = int(sys.argv[1])
uris = "".join(f"file://{os.path.abspath(name)}\r\n" for name in sys.argv[2:]).encode()
root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
source = x11.XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, ctypes.c_ulong(0), ctypes.c_ulong(0))
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31


def atom(name):
    return x11.XInternAtom(display, name.encode(), 0)


def send(message, *data):
    event = Event()
    event[0], event[3], event[4], event[5], event[6] = (
        CLIENT_MESSAGE, display.value, target, atom(message), 32)
    for i, value in enumerate((source,) + data):
        event[7 + i] = value
    x11.XSendEvent(display, ctypes.c_ulong(target), 0, ctypes.c_long(0), ctypes.byref(event))
    x11.XFlush(display)


def wait(kind, name=None):
    """The next event of a kind, while the target is answered."""
    end = time.time() + 60
    while time.time() < end:
        if not x11.XPending(display):
            time.sleep(0.02)
            continue
        event = Event()
        x11.XNextEvent(display, ctypes.byref(event))
        if event[0] & 0xffffffff == SELECTION_REQUEST:
            answer(event)
        if event[0] & 0xffffffff == kind and (name is None or event[5] == atom(name)):
            return event
    sys.exit(f"no {name or kind} came")


def answer(request):
    requestor, selection, kind, place = request[5:9]
    x11.XChangeProperty(display, ctypes.c_ulong(requestor), ctypes.c_ulong(place),
                        ctypes.c_ulong(kind), 8, 0, uris, len(uris))
    event = Event()
    event[0], event[3], event[4], event[5], event[6], event[7] = (
        SELECTION_NOTIFY, display.value, requestor, selection, kind, place)
    x11.XSendEvent(display, ctypes.c_ulong(requestor), 0, ctypes.c_long(0), ctypes.byref(event))
    x11.XFlush(display)


x11.XSetSelectionOwner(display, ctypes.c_ulong(atom("XdndSelection")), ctypes.c_ulong(source),
                       ctypes.c_ulong(0))
send("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
send("XdndPosition", 0, (500 << 16) | 300, 0, atom("XdndActionCopy"))
wait(CLIENT_MESSAGE, "XdndStatus")
send("XdndDrop", 0, 0, 0, 0)
wait(CLIENT_MESSAGE, "XdndFinished")
