"""compare_png.py A B: prints how many in 10,000 pixels of two PNGs differ by more than 8 of 255, and
the mean of B - A in thousandths of 255.

compare_png.py A B EMPTY: prints the root mean square of B - A in per cent of 255, over the pixels
where either shows another colour than EMPTY."""
import math
import struct
import sys
import zlib


def rows(name):
    """Rows of bytes of an 8-bit PNG without interlace, and the bytes of a pixel."""
    data = open(name, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(
                ">IIBBBBB", data[at + 8 : at + 8 + size]
            )
            assert (depth, interlace) == (8, 0) and color in (2, 6)
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += size + 12
    channels = 3 if color == 2 else 4
    raw, stride = zlib.decompress(packed), width * channels
    before, out = bytearray(stride), []
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for x in range(stride):
            left = row[x - channels] if x >= channels else 0
            up = before[x]
            corner = before[x - channels] if x >= channels else 0
            if kind == 1:
                add = left
            elif kind == 2:
                add = up
            elif kind == 3:
                add = (left + up) // 2
            elif kind == 4:
                p = left + up - corner
                add = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
            else:
                add = 0
            row[x] = (row[x] + add) & 255
        out.append(row)
        before = row
    return out, channels


def root_mean_square(a, b, empty, channels):
    total = count = 0
    for r, s, e in zip(a, b, empty):
        for x in range(0, len(r), channels):
            if r[x : x + 3] != e[x : x + 3] or s[x : x + 3] != e[x : x + 3]:
                total += sum((s[x + k] - r[x + k]) ** 2 for k in range(3))
                count += 3
    return 100.0 / 255.0 * math.sqrt(total / max(1, count))


def main():
    (a, n), (b, m) = rows(sys.argv[1]), rows(sys.argv[2])
    assert n == m and len(a) == len(b) and len(a[0]) == len(b[0])
    if len(sys.argv) > 3:
        empty, k = rows(sys.argv[3])
        assert k == n and len(empty) == len(a) and len(empty[0]) == len(a[0])
        print(f"{root_mean_square(a, b, empty, n):.4f}")
        return
    pixels, wrong, total = 0, 0, 0
    for r, s in zip(a, b):
        for x in range(0, len(r), n):
            differences = [s[x + k] - r[x + k] for k in range(3)]
            pixels += 1
            wrong += max(map(abs, differences)) > 8
            total += sum(differences)
    print(10000 * wrong // pixels, int(1000 * total / (3 * pixels)))


if __name__ == "__main__":
    main()
