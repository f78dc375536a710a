#!/usr/bin/env bash
# charts.sh MOTE DATA CASE: curves of mote integrate, probe and average, as pixels and as SVG, against
# their tables. None may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
export PYTHONPATH=$tests PYTHONDONTWRITEBYTECODE=1
swirl=$data/swirl.1.vtu

# check NAME: the Python program of standard input holds.
check() {
  python3 - || fail "$1"
}

case $3 in
  integrate) # over time, over places; panels; the same in pixels
    run 0 python3 "$data/make-rotor.py" rotor
    steps="rotor/rotor.foam --slice z=-0.02,0.06 --array p --all-steps"
    run 0 "$mote" integrate $steps -o table.csv
    run 0 "$mote" integrate $steps -o time.svg
    check "curves over time" <<'PYTHON'
import csv
from svg_curves import panels_of, same
panels, texts = panels_of("time.svg")
rows = list(csv.DictReader(open("table.csv")))
assert len(panels) == 3, len(panels)  # the mean, the flow, the head
for panel, column in zip(panels, ("p", "flow", "head")):
    assert sorted(panel.curves) == ["z=-0.02", "z=0.06"], panel.curves.keys()
    every = [float(row[column]) for row in rows]
    for section, curve in panel.curves.items():
        expected = [(float(row["time"]), float(row[column])) for row in rows if row["section"] == section]
        if column == "head" and section == "z=-0.02":
            assert curve == []  # 0 by itself
            continue
        reach = max(every) - min(every)
        same(curve, expected, [0.06, reach if reach > 1e-3 * max(every) else 0.2 * max(every)])
for text in ("time (s)", "z=-0.02", "z=0.06", "p (m²/s²)", "flow (m³/s)", "head (m)"):
    assert text in texts, (text, texts)
PYTHON
    places="$swirl --slice z=0.01,0.02,0.04,0.06,0.08"
    run 0 "$mote" integrate $places -o table.csv
    run 0 "$mote" integrate $places --curves flow,total_pressure -o place.svg
    run 0 "$mote" integrate $places --curves flow,total_pressure -o place.png
    is_picture place.png 1280x980
    check "curves over places" <<'PYTHON'
import csv, subprocess
from svg_curves import panels_of, same
panels, texts = panels_of("place.svg")
rows = list(csv.DictReader(open("table.csv")))
for panel, column in zip(panels, ("flow", "total_pressure")):
    (curve,) = panel.curves.values()
    same(curve, [(float(row["section"][2:]), float(row[column])) for row in rows])
assert "z" in texts and "total_pressure" in texts and not any("(" in text for text in texts), texts  # no units
PYTHON
    # What SVG has, pixels have: along the lines, and beside them not.
    python3 "$tests/svg_pixels.py" place.svg place.png || fail "place.png is not place.svg"
    # Time steps over places; a font twice as large.
    run 0 "$mote" integrate $steps --over place --font-scale 1.5 -o steps.svg
    check "a curve for each step" <<'PYTHON'
from svg_curves import panels_of
panels, texts = panels_of("steps.svg")
assert len(panels[0].groups) == len(set(color for _, _, color in panels[0].groups)) == 10
assert "z (m)" in texts and "time (s)" in texts, texts
PYTHON
    ;;

  probe) # along lines, at points
    run 0 "$mote" probe "$swirl" --from 0,0,-0.02 --to 0,0,0.08 --points 41 -o line.csv
    run 0 "$mote" probe "$swirl" --from 0,0,-0.02 --to 0,0,0.08 --points 41 --curves p,U:2,U -o line.svg
    check "values along a line" <<'PYTHON'
import csv, math
from svg_curves import panels_of, same
panels, texts = panels_of("line.svg")
rows = list(csv.DictReader(open("line.csv")))
size = lambda row: math.hypot(*(float(row[f"U:{k}"]) for k in range(3)))
for panel, value in zip(panels, (lambda row: float(row["p"]), lambda row: float(row["U:2"]), size)):
    (curve,) = panel.curves.values()
    same(curve, [(float(row["distance"]), value(row)) for row in rows])
PYTHON
    at="$data/swirl.0.vtu $data/swirl.1.vtu --at 0,0,0.01,0,0.001,0.05 --all-steps"
    run 0 "$mote" probe $at -o at.csv
    run 0 "$mote" probe $at --curves U:2 -o at.svg
    check "values over time" <<'PYTHON'
import csv
from svg_curves import panels_of, same
panels, texts = panels_of("at.svg")
rows = list(csv.DictReader(open("at.csv")))
assert len(rows) == 4 and rows[0]["point"] == "1" and rows[1]["point"] == "2"
for name, number in (("0, 0, 0.01", "1"), ("0, 0.001, 0.05", "2")):
    expected = [(float(row["time"]), float(row["U:2"])) for row in rows if row["point"] == number]
    assert name in texts
    same(panels[0].curves[name], expected, [0.5, 0.1])
PYTHON
    run 0 "$mote" probe $data/swirl.0.vtu $data/swirl.1.vtu --from 0,0,0 --to 0,0,0.1 --points 90 --all-steps --over time -o time.svg
    said time.svg '>distance<' # which colours more curves than have names
    run 1 "$mote" probe "$swirl" --at 0,0,0.01 -o a.svg
    one_sentence
    said err '--all-steps'
    run 1 "$mote" probe "$swirl" --at 0,0,0.01 --over distance -o a.svg
    said err '--from and --to'
    run 1 "$mote" probe "$swirl"
    one_sentence
    said err '--at'
    run 2 "$mote" probe "$swirl" --at 0,0
    said err 'three numbers'
    run 2 "$mote" probe "$swirl" --at 0,0,0.01 --points 3
    ;;

  average) # maps and profiles
    run 0 "$mote" average "$swirl" -a U -o bins.csv
    run 0 "$mote" average "$swirl" -a U --over axial -o profile.csv
    run 0 "$mote" average "$swirl" -a U --over axial -o profile.svg
    check "a profile" <<'PYTHON'
import csv, math
from svg_curves import panels_of, same
panels, texts = panels_of("profile.svg")
rows = list(csv.DictReader(open("profile.csv")))
assert len(panels) == 3 and 45 <= len(rows) <= 51, (len(panels), len(rows))
for panel, part in zip(panels, ("axial", "radial", "circumferential")):
    (curve,) = panel.curves.values()
    same(curve, [(float(row["axial"]), float(row["U_" + part])) for row in rows])
bins = list(csv.DictReader(open("bins.csv")))
total = lambda rows: sum(float(row["volume"]) * float(row["U_axial"]) for row in rows)
assert abs(total(rows) - total(bins)) < 1e-6 * total(bins), (total(rows), total(bins))
assert abs(sum(float(row["volume"]) for row in rows) - math.pi * (0.03 * 0.01**2 + 0.1 * 0.02**2)) < 3e-6
PYTHON
    run 0 "$mote" average "$swirl" -a p -o map.svg
    run 0 "$mote" average "$swirl" -a p -o map.png
    check "a map" <<'PYTHON'
import base64, xml.etree.ElementTree as tree
root = tree.parse("map.svg").getroot()
(image,) = root.iter("{http://www.w3.org/2000/svg}image")
data = base64.b64decode(image.get("href").split(",")[1])
assert data[:4] == b"\x89PNG" and data[16:24] == bytes.fromhex(
    f"{int(image.get('width')):08x}{int(image.get('height')):08x}")
texts = [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")]
assert "axial" in texts and "radial" in texts and "p" in texts, texts
rects = [r for r in root.iter("{http://www.w3.org/2000/svg}rect")]
assert len({r.get("fill") for r in rects}) > 100  # the colours of the legend
PYTHON
    run 0 "$mote" average "$data"/swirl.*.vtu -a p --over radial --all-steps -o steps.svg
    said steps.svg '>t = 7.5<'
    # A map of all steps shows their mean, which is that of neither.
    run 0 "$mote" average "$data"/swirl.*.vtu -a p --all-steps -o mean.png
    for step in 1 2; do
      run 0 "$mote" average "$data"/swirl.*.vtu -a p --step $step -o one.png
      ! cmp -s one.png mean.png || fail "the mean is step $step"
    done
    run 1 "$mote" average "$swirl" -a p --over axial --curves nothing -o a.png
    said err 'no column nothing'
    ;;

  rotor) # the case of the tutorial: what is known of it, units by the case's own dimensions
    run 0 python3 "$data/make-rotor.py" rotor
    run 0 "$mote" info rotor/rotor.foam
    grep -qE 'point +p .*\] m²/s²,' out || { cat out; fail "info does not name units"; }
    run 0 "$mote" info rotor/rotor.foam --json
    said out '"unit": "m/s"'
    sections="rotor/rotor.foam --slice z=-0.03,0.06 --density 1000"
    run 0 "$mote" integrate $sections -o head.csv
    run 0 "$mote" integrate $sections --kinematic -o kinematic.csv
    alike head.csv kinematic.csv # its unit tells
    run 0 "$mote" integrate rotor/rotor.foam --show-part blades --hide-part internalMesh --density 1000 --rpm 960 -o blades.csv
    check "the rotor's head, torque and power" <<'PYTHON'
import csv, math
head = list(csv.DictReader(open("head.csv")))
(blades,) = csv.DictReader(open("blades.csv"))
omega, flow, swirl = 2 * math.pi * 16, 6 * math.pi * (0.1**2 - 0.06**2), 0.16
near = lambda a, b: abs(a - b) < 0.002 * abs(b)
assert all(near(float(row["flow"]), flow) for row in head), head
assert float(head[0]["head"]) == 0 and near(float(head[1]["head"]), omega * swirl / 9.80665), head
assert near(float(blades["torque"]), -1000 * flow * swirl), blades
assert near(float(blades["power"]), -1000 * flow * swirl * omega), blades
PYTHON
    run 0 "$mote" integrate $sections --array p,U -o head.svg
    for text in 'p (m²/s²)' 'U:2 (m/s)' 'flow (m³/s)' 'head (m)' 'z (m)'; do
      said head.svg ">$text<"
    done
    run 0 "$mote" integrate rotor/rotor.foam --show-part blades --hide-part internalMesh --density 1000 --rpm 960 --all-steps -o torque.svg
    said torque.svg '>torque (N m)<'
    said torque.svg '>power (W)<'
    run 0 "$mote" probe rotor/rotor.foam --from 0.08,0,-0.04 --to 0.08,0,0 --curves p -o line.svg
    said line.svg '>distance (m) from 0.08, 0, -0.04<'
    ;;

  *) exit 2 ;;
esac
