"""edge_error.py A B EMPTY: prints the largest distance in pixels between the outlines of what two
PNGs show, along rows; EMPTY shows nothing but the background. Rows near the ends, which outlines
run along, are left out."""
import sys

from compare_png import rows


def outline(picture, empty):
    """The first and the last pixel of each row that shows something, or None."""
    (pixels, n), (background, m) = rows(picture), rows(empty)
    all = []
    for row, behind in zip(pixels, background):
        shown = [
            x for x in range(len(row) // n) if row[n * x : n * x + 3] != behind[m * x : m * x + 3]
        ]
        all.append((shown[0], shown[-1]) if shown else None)
    return all


def main():
    a, b = outline(sys.argv[1], sys.argv[3]), outline(sys.argv[2], sys.argv[3])
    shown = [y for y, ends in enumerate(b) if ends]
    margin = 0.15 * (shown[-1] - shown[0])
    inner = [y for y in shown if shown[0] + margin < y < shown[-1] - margin]
    assert all(a[y] for y in inner), "rows without anything"
    print(max(abs(p - q) for y in inner for p, q in zip(a[y], b[y])))


if __name__ == "__main__":
    main()
