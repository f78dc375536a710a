#!/usr/bin/env bash
# turns.sh MOTE DATA CASE: one test of what users do in the view and in the panel by turns, on the X
# server that DISPLAY names. The random actions of tests/soak found these.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# has_row TEXT: the recording has it, within a while.
has_row() {
  for _ in $(seq 100); do
    grep -qF -- "$1" done.rec && return
    sleep 0.1
  done
  cut -c 1-200 done.rec
  fail "the recording has no $1"
}

# moves: how often the camera has moved.
moves() { grep -c '"what":"camera"' done.rec; }

case $3 in
  mouse) # in the view, then in the panel: which has the mouse again
    open "$copper" --size 1000x760 --record done.rec
    press m
    has '--color-map=plasma'
    xdotool mousemove 640 400 sleep 0.2 click 1
    has_row '"action":"pick"'
    click Undo
    has_no '--color-map'
    for button in 1 2 3; do
      click Redo
      has '--color-map=plasma'
      before=$(moves)
      xdotool mousemove 640 400 sleep 0.2 mousedown $button sleep 0.1 mousemove 700 430 sleep 0.1 \
        mouseup $button
      for _ in $(seq 100); do
        [ "$(moves)" -gt "$before" ] && break
        sleep 0.1
      done
      [ "$(moves)" -gt "$before" ] || fail "button $button does not move the view"
      click Undo # the camera
      click Undo
      has_no '--color-map'
    done
    [ "$(grep -c '"action":"pick"' done.rec)" = 1 ] || fail "clicks on the panel pick in the view"
    quit
    ;;

  timers) # go on while a button is held down in the view: what plays plays on, the panel answers
    open "$copper" --size 1000x760 --record done.rec --speed 20
    click Play
    has_row '"what":"pass"'
    xdotool mousemove 640 400 mousedown 1 sleep 0.1 mousemove 700 430
    before=$(grep -c '"what":"pass"' done.rec)
    for _ in $(seq 100); do
      [ "$(grep -c '"what":"pass"' done.rec)" -gt $((before + 8)) ] && break
      sleep 0.1
    done
    [ "$(grep -c '"what":"pass"' done.rec)" -gt $((before + 8)) ] || fail "playing stops"
    xdotool mouseup 1
    click Pause
    shown Play
    # Each ends what the other one waits for.
    for i in $(seq 20); do
      xdotool mousemove 100 $((300 + i)) mousemove 640 400 mousedown 1 sleep 0.02 mousemove 660 420 \
        sleep 0.02 mouseup 1
    done
    click 'group Colour' 0.8
    gone color-map
    quit
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
