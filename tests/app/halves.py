"""halves.py FILE [TOP [BOTTOM]]: how many pixels of the left half of a PNG differ by more than 8 of 255
from those of the right half, without TOP rows above and BOTTOM rows below, and how many pixels of the left
half are no background, which is the colour of its lower left corner.

halves.py FILE marks: how many pixels have the colour of marks, and of the ruler.

halves.py FILE OTHER SIDE TOP: how many pixels of the "left" or "right" half of FILE differ from OTHER,
which is half as wide, without TOP rows above; or of the lower right "quarter", of OTHER's size."""
import sys

from compare_png import rows


def differ(a, b):
    return max(abs(x - y) for x, y in zip(a, b)) > 8


def count(first, second, n):
    return sum(
        differ(r[x : x + 3], s[x : x + 3]) for r, s in zip(first, second) for x in range(0, len(r), n)
    )


picture, n = rows(sys.argv[1])
if sys.argv[2:] == ["marks"]:
    colors = [row[x : x + 3] for row in picture for x in range(0, len(row), n)]
    marked = sum(r > 120 and b > 100 and g < 0.6 * min(r, b) for r, g, b in colors)
    print(marked, sum(min(r, g) > 170 and b < 0.6 * g for r, g, b in colors))
    sys.exit()
half = len(picture[0]) // n // 2 * n
if len(sys.argv) > 3 and sys.argv[3] in ("left", "right", "quarter"):
    other, k = rows(sys.argv[2])
    if sys.argv[3] == "quarter":
        picture = picture[len(picture) // 2 :]
    assert k == n and len(other) == len(picture) and len(other[0]) == half
    top = int(sys.argv[4])
    side = [row[:half] if sys.argv[3] == "left" else row[-half:] for row in picture]
    # The line between the views is no part of them.
    print(count([row[2 * n : -2 * n] for row in side[top:]], [row[2 * n : -2 * n] for row in other[top:]], n))
    sys.exit()
top, bottom = (list(map(int, sys.argv[2:])) + [0, 0])[:2]
shown = picture[top : len(picture) - bottom]
left = [row[2 * n : half - 2 * n] for row in shown]
right = [row[half + 2 * n : 2 * half - 2 * n] for row in shown]
empty = picture[-1][0:3]
print(count(left, right, n), sum(differ(r[x : x + 3], empty) for r in left for x in range(0, len(r), n)))
