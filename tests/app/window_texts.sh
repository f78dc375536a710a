#!/usr/bin/env bash
# window_texts.sh MOTE DATA CASE: one test of the texts over the window's view, on the X server that
# DISPLAY names; see window.sh.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/window_common.sh"

case $3 in
  status) # the line fits into the view, however narrow
    for width in 400 408 415 421 428; do # one of them would cut a letter
      open "$data/hopper.dump.gz" --size ${width}x300 --samples 1
      picture drawn.png
      read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
      # colours X WIDTH: how many there are in the line; without a text one for each of 24 rows.
      colours() { python3 "$tests/screen.py" $((x + $1)) $((y + 274)) "$2" 24 | cut -d ' ' -f 2; }
      [ "$(colours 4 200)" -gt 40 ] || fail "there is no line: $(colours 4 200) colours"
      [ "$(colours $((width - 4)) 4)" -le 24 ] || fail "the line goes on: $(colours $((width - 4)) 4) colours at $width"
      quit
      rm drawn.png
    done
    ;;

  veils) # lie under the legend and the status line, where data are behind them
    open "$copper" --size 800x600 --samples 1 --zoom 20 --range=-2000,-1000 --ambient-occlusion none
    read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
    # yellow X Y WIDTH HEIGHT: how many pixels there have the colour that all data have.
    yellow() { at_rest $((x + $1)) $((y + $2)) $3 $4 >/dev/null; python3 "$tests/screen.py" $((x + $1)) $((y + $2)) $3 $4 ruled; }
    [ "$(yellow 250 150 200 100)" -gt 5000 ] || fail "the data are not yellow: $(yellow 250 150 200 100)"
    [ "$(yellow 12 578 200 10)" = 0 ] || fail "the status line stands on bare data: $(yellow 12 578 200 10)"
    [ "$(yellow 740 180 45 250)" = 0 ] || fail "the legend stands on bare data: $(yellow 740 180 45 250)"
    quit
    ;;

  letters) # of the window are as large as the display, or the user, wants; lists of keys scroll
    # rows WIDTH HEIGHT SCALE: how many rows of pixels the status line has.
    rows() {
      open "$data/hopper.dump.gz" --size $1x$2 --samples 1 --view +y --ui-scale $3
      picture drawn.png
      rm drawn.png
      read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
      high=$(python3 "$tests/screen.py" $((x + 4)) $((y + $2 - 60)) 60 60 lines)
    }
    rows 640 400 1
    small=$high
    keys() { python3 "$tests/screen.py" "$x" "$y" 640 360; }
    none=$(keys)
    # other NAME BEFORE: what is over the view becomes other than BEFORE, within a while.
    other() {
      for _ in $(seq 100); do
        now=$(keys)
        [ "$now" != "$2" ] && return
        sleep 0.05
      done
      fail "$1 changes nothing"
    }
    press h
    other h "$none"
    sleep 0.5
    first=$(keys)
    letters=$(python3 "$tests/screen.py" $((x + 12)) "$y" 90 44 lines)
    [ "$letters" -ge 14 ] || fail "the letters of the keys are $letters rows high, in two lines"
    press Next
    other 'Page Down' "$first"
    press Prior
    sleep 0.5
    [ "$(keys)" = "$first" ] || fail "Page Up does not come back"
    xdotool mousemove $((x + 300)) $((y + 200)) click 5
    other 'the wheel' "$first"
    press h
    sleep 0.5
    camera=$(press k; sleep 0.5; grep -o -- '--camera=[^ ]*' out | tail -1)
    xdotool click 4
    sleep 1
    press k
    sleep 0.5
    [ "$(grep -o -- '--camera=[^ ]*' out | tail -1)" != "$camera" ] || fail "the wheel zooms no more"
    quit
    rows 900 600 2
    [ $((10 * high)) -gt $((16 * small)) ] || fail "twice as large a line is $high rows high, not $small"
    quit
    ;;

  hover) # the cursor at rest is told what is under it, and nothing beside the data
    open "$data/hopper.dump.gz" --size 640x400 --samples 1
    picture sharp.png
    read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
    tip() { python3 "$tests/screen.py" "$x" "$y" 640 380; } # but the status line
    xdotool mousemove $((x + 20)) $((y + 60))
    press Escape # the greeting goes
    none=$(at_rest "$x" "$y" 640 380)
    xdotool mousemove $((x + 320)) $((y + 210))
    until_is() {
      for _ in $(seq 100); do
        now=$(tip)
        [ "$1" = other ] && [ "$now" != "$none" ] && return
        [ "$1" = same ] && [ "$now" = "$none" ] && return
        sleep 0.05
      done
      fail "$2"
    }
    until_is other "nothing is told of a particle"
    first=$now
    picture saved.png
    alike sharp.png saved.png
    xdotool mousemove $((x + 300)) $((y + 250))
    for _ in $(seq 100); do
      until_is other "nothing is told of another particle"
      [ "$now" != "$first" ] && break
      sleep 0.05
    done
    [ "$now" != "$first" ] || fail "the same is told of another place"
    xdotool mousemove $((x + 20)) $((y + 60))
    until_is same "what was told stays"
    sleep 1 # longer than it takes to be told
    until_is same "something is told of nothing"
    xdotool mousemove $((x + 320)) $((y + 210))
    until_is other "nothing is told any more"
    xdotool mousemove $((x + 800)) $((y + 500)) # out of the window
    until_is same "what was told stays when the cursor has left"
    # What is told is of the step that is shown.
    xdotool mousemove $((x + 320)) $((y + 210))
    until_is other "nothing is told before the step changes"
    before=$(python3 "$tests/screen.py" $((x + 334)) $((y + 223)) 200 100)
    press Left
    for _ in $(seq 100); do
      [ "$(python3 "$tests/screen.py" $((x + 334)) $((y + 223)) 200 100)" != "$before" ] && break
      sleep 0.05
    done
    [ "$(python3 "$tests/screen.py" $((x + 334)) $((y + 223)) 200 100)" != "$before" ] || fail "what is told of the step before stays"
    quit
    # What is told is whole in a narrow view, and lies over the legend.
    open "$data/hopper.dump.gz" --size 400x400 --samples 1 --color-by v
    picture sharp.png
    read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
    xdotool mousemove $((x + 20)) $((y + 60))
    press Escape
    none=$(at_rest $((x + 397)) "$y" 3 380)
    tip() { python3 "$tests/screen.py" $((x + 320)) "$y" 60 380; }
    legend=$(tip)
    xdotool mousemove $((x + 195)) $((y + 210))
    for _ in $(seq 100); do
      [ "$(tip)" = "$legend" ] || break
      sleep 0.05
    done
    [ "$(tip)" != "$legend" ] || fail "nothing is told over the legend"
    tip() { python3 "$tests/screen.py" $((x + 397)) "$y" 3 380; }
    [ "$(tip)" = "$none" ] || fail "what is told goes on beyond the view"
    quit
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
