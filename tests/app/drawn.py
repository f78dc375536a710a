"""drawn.py FILE X0 X1 Y0 Y1: how many pixels of a rectangle of a PNG, its ends included and rows from
the top, have another colour than the picture's upper left corner; with "light" behind, how many are
rather white, as texts are."""
import sys

from compare_png import rows

picture, n = rows(sys.argv[1])
x0, x1, y0, y1 = map(int, sys.argv[2:6])
empty = picture[0][0:3]
if sys.argv[6:] == ["light"]:
    print(sum(min(row[n * x : n * x + 3]) > 150 for row in picture[y0 : y1 + 1] for x in range(x0, x1 + 1)))
else:
    print(sum(row[n * x : n * x + 3] != empty for row in picture[y0 : y1 + 1] for x in range(x0, x1 + 1)))
