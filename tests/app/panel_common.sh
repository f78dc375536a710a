# What the tests that work the panel share, beside window_common.sh. Where controls lie the panel
# itself writes (see app/panels/ControlPlaces.h).

source "$tests/window_common.sh"
folded=
export MOTE_CONTROLS=$folder/controls
touch "$MOTE_CONTROLS"

# place NAME [X [Y]]: a place on a control, from 0 to 1 across and down, in pixels.
place() {
  awk -v name="$1" -v fx="${2:-0.5}" -v fy="${3:-0.5}" '{
    k = NF; own = $1; for (i = 2; i <= NF - 4; i++) own = own " " $i
    if (own == name && !found) {
      print int($(k - 3) + fx * ($(k - 1) - $(k - 3))), int($(k - 2) + fy * ($k - $(k - 2)))
      found = 1
    } }' "$MOTE_CONTROLS"
}

# inputs: how many presses and releases of the mouse the panel has seen.
inputs() { awk '$1 == "inputs" { print $2 }' "$MOTE_CONTROLS"; }

# settled [N]: the panel is done with what came, at least N presses and releases, within a while.
settled() {
  for _ in $(seq 200); do
    awk -v least="${1:-0}" '$1 == "inputs" && $2 >= least && $3 == 0 { found = 1 }
      END { exit !found }' "$MOTE_CONTROLS" && return
    kill -0 $process 2>/dev/null || { cat err; fail "the program had ended"; }
    sleep 0.05
  done
  fail "the panel does not settle"
}

# shown NAME: the control is there, within a while.
shown() {
  for _ in $(seq 400); do
    [ -n "$(place "$1")" ] && return
    sleep 0.05
  done
  cat "$MOTE_CONTROLS"
  fail "no control $1"
}

# over NAME [X [Y]]: the mouse goes to a control.
over() {
  shown "$1"
  settled
  xdotool mousemove $(place "$@")
  sleep 0.1
}

click() {
  over "$@"
  local before
  before=$(inputs)
  xdotool click 1
  settled $((before + 2))
}

# gone NAME: the control is not there, within a while.
gone() {
  for _ in $(seq 400); do
    [ -z "$(place "$1")" ] && return
    sleep 0.05
  done
  fail "the control $1 stays"
}

# drag NAME X... : from the first share of the control's width to the others.
drag() {
  local name=$1 y=${height:-0.5}
  over "$name" "$2" "$y"
  xdotool mousedown 1
  shown "active $name"
  shift 2
  for x in "$@"; do
    xdotool mousemove $(place "$name" "$x" "$y")
    sleep 0.1
  done
  xdotool mouseup 1
  gone "active $name"
}

# write NAME TEXT: TEXT and Return into a field, in place of what it says.
write() {
  click "$1"
  shown "active $1"
  xdotool key --window 0 ctrl+a
  xdotool type --window 0 --delay 30 -- "$2"
  xdotool key --window 0 Return
  gone "active $1"
  settled # before keys are the view's again
}

# refused NAME TEXT: TEXT and Return into a field that cannot take it, and keeps the keys.
refused() {
  click "$1"
  shown "active $1"
  xdotool key --window 0 ctrl+a
  xdotool type --window 0 --delay 30 -- "$2"
  xdotool key --window 0 --delay 50 Return q BackSpace # which would be the view's
  settled
  shown "active $1"
  kill -0 $process 2>/dev/null || fail "the program ended by a letter of a field"
}

# go_to NAME: with the keys alone, from wherever in the panel they are down to the control.
go_to() {
  local at
  for _ in $(seq 80); do
    settled
    [ -n "$(place "focused $1")" ] && return
    at=$(grep '^keys at' "$MOTE_CONTROLS")
    xdotool key --window 0 Down
    for _ in $(seq 100); do
      [ "$(grep '^keys at' "$MOTE_CONTROLS")" != "$at" ] && break
      sleep 0.05
    done
  done
  fail "the keys do not come to $1"
}

# command: the command that makes this picture, as the window prints it.
command_now() {
  local before
  before=$(grep -c '^mote render' out)
  press k
  for _ in $(seq 100); do
    [ "$(grep -c '^mote render' out)" -gt "$before" ] && break
    sleep 0.05
  done
  grep '^mote render' out | tail -1
}

# has PATTERN, has_no PATTERN: what the command says, within a while.
has() {
  for _ in $(seq 20); do
    command_now | grep -qE -- "$1" && return
    sleep 0.1
  done
  fail "the command has no $1: $(command_now)"
}
has_no() {
  for _ in $(seq 20); do
    command_now | grep -qE -- "$1" || return 0
    sleep 0.1
  done
  fail "the command has $1: $(command_now)"
}

# at STEP: the window shows this step, counted from 1.
at() { has "--step[= ]$1( |\$)"; }
