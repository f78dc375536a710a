#!/usr/bin/env bash
# time_picked.sh MOTE DATA CASE: one test of what is picked through time, in the window, on the X
# server that DISPLAY names.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  paths) # of particles through time; none over the side of a periodic box
    walk() { # BOUNDARY: one particle goes to the right, through the side of the box
      for step in 0 1 2 3 4 5; do
        printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS %s\n0 10\n0 10\n0 10\n' $step "$1"
        printf 'ITEM: ATOMS id type x y z\n7 1 %s %s 5\n8 1 5 1 1\n9 1 5 1 9\n' $(((5 + 2 * step) % 10)) $((5 + step * 4 / 5))
      done
    }
    orange() { # FILE: pixels of the first path's colour
      python3 - "$1" "$tests" <<'SCRIPT'
import sys
name, folder = sys.argv[1:]
sys.path.insert(0, folder)
sys.argv = ["", name, name]
from compare_png import rows
lines, step = rows(name)
print(sum(l[i] > 200 and 90 < l[i + 1] < 160 and l[i + 2] < 60 for l in lines for i in range(0, len(l), step)))
SCRIPT
    }
    walk 'pp pp pp' >periodic.dump
    walk 'ff ff ff' >open.dump
    count() { # FILE: how much there is of the path of 7
      open "$1" --size 900x700 --view +z --radius 0.1 --color-by none --background white --no-panel --trajectories 7
      picture "$2"
      quit
      run 0 "$mote" render "$1" --size 900x700 --view +z --radius 0.1 --color-by none --background white --trajectories 7 \
        -o "head-$2"
      orange "$2"
      orange "head-$2" >"$2.head"
    }
    whole=$(count open.dump open.png | tail -1)
    parted=$(count periodic.dump periodic.png | tail -1)
    [ "$parted" -gt 100 ] || fail "no path: $parted"
    [ "$(cat periodic.png.head)" -gt 100 ] && [ "$(cat open.png.head)" -gt "$(cat periodic.png.head)" ] ||
      fail "other paths without a window: $(cat ./*.head)"
    [ "$whole" -gt "$parted" ] || fail "a line across the box: $whole, $parted"
    open periodic.dump --size 900x700 --view +z --radius 1 --color-by none --background white --step 1
    press j # nothing is picked yet
    xdotool mousemove 610 200
    press p
    shown 'Paths of the picked'
    picture picked.png
    click 'Paths of the picked'
    has '--trajectories='
    picture paths.png
    differ picked.png paths.png
    click Undo
    has_no '--trajectories='
    quit
    ;;

  picks) # by id through steps that lack what is picked; the view of each step
    step() { # TIME IDS...
      printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n%s\nITEM: BOX BOUNDS ff ff ff\n' "$1" $(($# - 1))
      printf '0 20\n0 20\n0 20\nITEM: ATOMS id type x y z heat\n'
      for id in "${@:2}"; do
        echo "$id 1 10 $((9 + id)) 10 $1.5"
      done
    }
    { step 0; step 1 1 2; step 2 2; step 3 1 2; } >come.dump
    # What frames itself does so for the step that is shown.
    open come.dump --size 900x700 --radius 1 --color-by heat --range 0 4 --step 2
    picture two.png
    quit
    open come.dump --size 900x700 --radius 1 --color-by heat --range 0 4 --step 1
    press Right
    picture kept.png
    differ two.png kept.png
    press r
    picture framed.png
    alike two.png framed.png
    click Undo
    picture undone.png
    alike kept.png undone.png
    quit
    open come.dump --size 900x740 --radius 2 --view +x --color-by none --step 4
    xdotool mousemove 560 370
    press p
    shown 'picked list'
    press Left
    shown '1 picked, not in this time step'
    press Left
    gone '1 picked, not in this time step'
    shown 'picked list'
    has_no '--trajectories'
    click 'Paths of the picked'
    has '--trajectories[= ]1( |$)'
    click 'No paths'
    has_no '--trajectories'
    press ctrl+s
    for _ in $(seq 100); do
      [ -e come-001.json ] && break
      sleep 0.1
    done
    quit
    # The window has room for the panel beside the view that was saved.
    eval "$(python3 -c 'import json; print("width=" + json.load(open("come-001.json"))["picture"]["size"].split("x")[0])')"
    [ "$width" -lt 700 ] || fail "the view was $width wide, panel and all"
    open come-001.json
    eval "$(xdotool getwindowgeometry --shell "$window" | grep WIDTH)"
    [ "$WIDTH" = 900 ] || fail "a window of $WIDTH and not of 900 pixels"
    quit
    ;;

  values) # of what is picked, over time, with a gap where a step lacks it
    step() { # TIME ROWS...
      printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n%s\nITEM: BOX BOUNDS ff ff ff\n' "$1" $(($# - 1))
      printf '0 20\n0 20\n0 20\nITEM: ATOMS id type x y z%s\n' "$heat"
      printf '%s\n' "${@:2}"
    }
    { heat=' heat'; step 0 '7 1 10 10 10 0.25' '8 2 1 10 10 5'; step 5 '8 2 1 10 10 6' '7 1 10 11 10 -3';
      step 10 '8 2 1 10 10 5'; heat=; step 15 '7 1 10 10.5 10'; } >warm.dump
    open warm.dump --size 900x1000 --radius 3 --view +x --color-by heat --step 1 --calculate 'twice=2*y'
    xdotool mousemove 600 500
    press p
    shown 'picked list'
    click 'group Colour' 0.8
    click 'group Selection' 0.8
    click 'Plot over time'
    click 'Save over time'
    for _ in $(seq 100); do
      [ -e warm-001-over-time.csv ] && break
      sleep 0.1
    done
    printf 'step,time,id,x,y,z,heat,twice,type\n1,0,7,10,10,10,0.25,20,1\n2,5,7,10,11,10,-3,22,1\n4,15,7,10,10.5,10,,21,1\n' >wanted.csv
    cmp warm-001-over-time.csv wanted.csv || { cat warm-001-over-time.csv; fail 'other values over time'; }
    click 'over time' 0.34
    at 2
    write time 11 # the latest step at or before it
    at 3
    write time -1
    at 3 # there is none before 0
    write time 5
    at 2
    click 'over time of'
    click twice
    picture twice.png
    press c # another array that colours leaves the plot as it is
    at 2
    click 'over time of'
    click twice
    # Where nothing is picked any more nothing is plotted.
    press Escape
    gone 'over time'
    xdotool mousemove 600 500
    press p
    shown 'picked list'
    # While all of it is read again the window goes.
    click 'Plot over time'
    press q
    wait $process
    [ $? = 0 ] || { cat err; fail 'it did not end well'; }
    ;;

  *) fail "unknown case $3" ;;
esac
echo "$3: passed"
