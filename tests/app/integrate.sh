#!/usr/bin/env bash
# integrate.sh MOTE DATA CASE: one test of mote integrate. None may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
swirl=$data/swirl.1.vtu

# value ROW COLUMN: a number of the table in the file table.csv.
value() {
  python3 -c 'import csv, sys
print(list(csv.DictReader(open("table.csv")))[int(sys.argv[1])][sys.argv[2]])' "$1" "$2"
}
# near A B SHARE: two numbers differ by no more than a share.
near() {
  python3 -c 'import sys
a, b, share = map(float, sys.argv[1:])
sys.exit(abs(a - b) > share * max(abs(a), abs(b)))' "$1" "$2" "$3" || fail "$1 is not $2"
}

case $3 in
  tables) # what goes through a cylinder is the same at all radii without walls between
    run 0 "$mote" integrate pump:0.02:rotor --slice r=0.06,0.08 --slice z=0.01 -a pressure -o table.csv
    [ "$(value 0 section)" = r=0.06 ] && [ "$(value 2 section)" = z=0.01 ] || { cat table.csv; fail "names"; }
    near "$(value 0 pressure)" "$(python3 -c "print($(value 0 pressure_integral) / $(value 0 area))")" 1e-8
    for row in 0 1 2; do
      python3 -c "import sys; sys.exit(not $(value $row area_error) < 1e-3 * $(value $row area))" ||
        fail "the error of row $row is large"
    done
    # Standard output, JSON, steps.
    run 0 "$mote" integrate "$swirl" --slice z=0.02 --array U
    [ "$(head -1 out | cut -d, -f1-4)" = part,section,cells,area ] || { cat out; fail "no table"; }
    run 0 "$mote" integrate "$swirl" --slice z=0.02 --array U --json
    python3 -c 'import json; t = json.load(open("out")); assert t[0]["section"] == "z=0.02" and t[0]["U:2_flow_mean"] > 0' ||
      { cat out; fail "no JSON"; }
    run 0 "$mote" integrate pump:0.001 --boundary --all-steps -o table.csv
    python3 - <<'PYTHON' || fail "steps and parts"
import csv
rows = list(csv.DictReader(open("table.csv")))
times = sorted({float(row["time"]) for row in rows})
assert len(times) > 10 and len(rows) % len(times) == 0, (len(times), len(rows))
every = [row for row in rows if float(row["time"]) == times[0]]
assert every[-1]["part"] == "all"
area = sum(float(row["area"]) for row in every[:-1])
assert abs(area - float(every[-1]["area"])) < 1e-6 * area
assert all(row["torque"] != "nan" for row in every)
PYTHON
    ;;

  errors)
    run 1 "$mote" integrate "$swirl" --array nothing
    one_sentence
    said err "there is no array 'nothing'; it has"
    run 1 "$mote" integrate "$swirl" -o table.gif
    one_sentence
    said err '.csv or .json'
    run 1 "$mote" integrate "$swirl" -o table.png
    one_sentence
    said err 'slices of one kind'
    run 1 "$mote" integrate "$swirl" --slice z=0.01 --slice x=0 -o table.svg
    said err 'slices of one kind'
    run 1 "$mote" integrate "$swirl" --slice z=0.01,0.02 --over time -o table.svg
    said err '--all-steps'
    run 1 "$mote" integrate "$swirl" --slice z=0.01,0.02 --curves nothing -o table.svg
    said err 'no column nothing for curves; it has cells, area, flow'
    run 1 "$mote" integrate "$swirl" --rpm 100 --pressure none
    said err '--pressure'
    run 2 "$mote" integrate "$swirl" --slice x=0:1
    said err '--slice'
    run 2 "$mote" integrate "$swirl" --density 0
    said err '--density'
    run 1 "$mote" integrate "$swirl" --velocity p
    one_sentence
    said err 'components'
    run 1 "$mote" integrate "$data/hopper.dump.gz"
    one_sentence
    ;;

  *) exit 2 ;;
esac
