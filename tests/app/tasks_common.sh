# What the tests of docs/tasks.md share, beside panel_common.sh.

source "$tests/panel_common.sh"
number=0

# task N WORDS: what follows tests this task of docs/tasks.md.
task() {
  number=$1
  echo "task $1: $2"
}

fail() {
  echo "FAILED: task $number: $*" >&2
  exit 1
}

# begin GROUPS ARGUMENTS...: a window in which these sections are unfolded by themselves.
begin() {
  unfolded=$1
  shift
  open "$@" --size 1000x1000 --samples 1
  shown 'group Colour'
}

# section GROUP: unfolds it, and folds the others, so that all of it is on the screen.
section() {
  local other
  [ "$unfolded" = "$1" ] && return
  for other in $unfolded; do
    [ "$other" = "$1" ] || click "group $other" 0.8
  done
  case " $unfolded " in *" $1 "*) ;; *) click "group $1" 0.8 ;; esac
  unfolded=$1
}

# wipe NAME: empties a field.
wipe() {
  click "$1"
  shown "active $1"
  xdotool key --window 0 ctrl+a BackSpace Return
  gone "active $1"
}

# changed: the picture is another one than when this was asked the last time.
pictures=0
changed() {
  picture "next-$pictures.png"
  [ "$pictures" = 0 ] || differ "next-$((pictures - 1)).png" "next-$pictures.png"
  pictures=$((pictures + 1))
}
# same_as_first: the picture is the first one of changed().
same_as_first() {
  picture again.png
  alike next-0.png again.png
}

# written FILE...: the files are there, within a while.
written() {
  for _ in $(seq 600); do
    ls -- "$@" >/dev/null 2>&1 && return
    kill -0 $process 2>/dev/null || { cat err; fail "the program had ended"; }
    sleep 0.05
  done
  fail "no $*"
}

# on_screen: a fingerprint of the view, but for its lower line.
on_screen() { python3 "$tests/screen.py" 330 60 660 880; }
# until_other FINGERPRINT: the view is another one, within a while.
until_other() {
  for _ in $(seq 100); do
    [ "$(on_screen)" != "$1" ] && return
    sleep 0.1
  done
  fail "the view stays as it was"
}
