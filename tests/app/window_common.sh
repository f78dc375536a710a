# What the tests of the window share, beside common.sh.

source "$tests/common.sh"
[ -n "$DISPLAY" ] || fail "no display"
copper=$data/copper-scratch.dump.gz

# What the program remembers of its user is the test's own: of one who knows the hints.
export XDG_STATE_HOME=$folder/state
mkdir -p "$XDG_STATE_HOME/mote"
echo '{"hints": false}' >"$XDG_STATE_HOME/mote/state.json"

# Tests of the view go without the panel.
folded=--no-panel
# open ARGUMENTS...: starts the program and waits for its window.
open() {
  [ -z "$MOTE_CONTROLS" ] || echo >"$MOTE_CONTROLS" # what an earlier program wrote
  # Shells start background commands with SIGINT ignored, and mote leaves that as it is.
  env --default-signal=INT "$mote" $folded "$@" >out 2>err &
  process=$!
  window=
  for _ in $(seq 150); do
    window=$(xdotool search --onlyvisible --name '^Mote - ' 2>/dev/null | head -1)
    [ -n "$window" ] && break
    kill -0 $process 2>/dev/null || { cat err; fail "the program ended"; }
    sleep 0.2
  done
  [ -n "$window" ] || fail "no window"
  xdotool windowfocus "$window" mousemove 640 400
}

press() {
  kill -0 $process 2>/dev/null || { cat err; fail "the program had ended before $*"; }
  xdotool key --window 0 "$@"
}

# titled TEXT: the window's title contains it, within a while.
titled() {
  for _ in $(seq 600); do
    xdotool getwindowname "$window" | grep -qF -- "$1" && return
    kill -0 $process 2>/dev/null || { cat err; fail "the program had ended before its title had $1"; }
    sleep 0.02
  done
  fail "no $1 in the title: $(xdotool getwindowname "$window")"
}

# untitled TEXT: the title does not contain it any more, within a while.
untitled() {
  for _ in $(seq 600); do
    xdotool getwindowname "$window" | grep -qF -- "$1" || return
    sleep 0.1
  done
  fail "$1 stays in the title"
}

# many_particles FILE: eight million in a cube, in the order of a simulation.
many_particles() {
  python3 "$tests/many_particles.py" "$1"
}

saved=0
# picture NAME: has the window save what it shows and calls the file NAME.
picture() {
  saved=$((saved + 1))
  local file
  press s
  for _ in $(seq 300); do
    file=$(ls -- *-001.png 2>/dev/null | head -1)
    [ -n "$file" ] && break
    sleep 0.1
  done
  [ -n "$file" ] || fail "the window saved no picture $1"
  mv "$file" "$1"
}

# at_rest X Y WIDTH HEIGHT: a fingerprint of a rectangle of the screen, once it has been the same for a
# while.
at_rest() {
  local before= now same=0
  for _ in $(seq 300); do
    now=$(python3 "$tests/screen.py" "$@")
    [ "$now" = "$before" ] && same=$((same + 1)) || same=0
    [ $same -ge 5 ] && break
    before=$now
    sleep 0.1
  done
  [ $same -ge 5 ] || fail "the screen does not come to rest"
  echo "$now"
}

# sized NAME SIZE: a picture of the view, once it has this size.
sized() {
  for _ in $(seq 50); do
    picture "$1"
    [ "$(png_size "$1")" = "$2" ] && return
    sleep 0.1
  done
  fail "the view is $(png_size "$1"), not $2"
}

differ() { cmp -s "$1" "$2" && fail "$1 and $2 look alike"; }

quit() {
  press q
  for _ in $(seq 600); do
    kill -0 $process 2>/dev/null || break
    sleep 0.1
  done
  kill -0 $process 2>/dev/null && { kill $process; fail "q does not close the window"; }
  wait $process
  local code=$?
  [ $code = 0 ] || { cat err; fail "exit code $code after q"; }
  [ ! -s err ] || { cat err; fail "something on standard error"; }
}

# quit_changed: the window asks first, as a session that was opened or saved has changed since.
quit_changed() {
  press q
  sleep 0.5
  kill -0 $process 2>/dev/null || fail "q closes a session that has changed"
  quit
}

# rectangle BUTTON X0 Y0 X1 Y1: is drawn with Ctrl.
rectangle() {
  xdotool mousemove "$2" "$3" sleep 0.2
  xdotool keydown Control_L mousedown "$1" sleep 0.1
  xdotool mousemove $((($2 + $4) / 2)) "$5" sleep 0.2 mousemove "$4" "$5" sleep 0.2
  xdotool mouseup "$1" keyup Control_L sleep 0.1
}
