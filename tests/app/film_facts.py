#!/usr/bin/env python3
"""film_facts.py FILE: the size, the frames, the frames a second of an Ogg Theora film, and whether it is complete."""
import struct
import sys

data = open(sys.argv[1], "rb").read()
packets, rest, at, last = [], b"", 0, 0
while at < len(data):
    if data[at:at + 4] != b"OggS":
        sys.exit(f"no page at {at}")
    last, segments = data[at + 5], data[at + 26]
    sizes = data[at + 27:at + 27 + segments]
    at += 27 + segments
    for size in sizes:
        rest += data[at:at + size]
        at += size
        if size < 255:
            packets.append(rest)
            rest = b""
head = packets[0]
if head[:7] != b"\x80theora" or at != len(data):
    sys.exit("no whole Theora stream")
width, height = (int.from_bytes(head[i:i + 3], "big") for i in (14, 17))
rate, per = struct.unpack(">II", head[22:30])
frames = len([p for p in packets[3:]])
keys = len([p for p in packets[3:] if p and not p[0] & 0x40])
print(f"{width}x{height} {frames} frames {rate / per:g} fps {keys > 0 and 'playable'} {'complete' if last & 4 else 'cut'}")
