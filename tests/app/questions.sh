#!/usr/bin/env bash
# questions.sh MOTE DATA CASE: questions of docs/guide/pump-questions.md, answered in the window, on the
# X server that DISPLAY names. Each has the answer that its command has.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/tasks_common.sh"
swirl=$data/swirl.1.vtu

case $3 in
  vortices) # of one array, in the colours of another
    begin 'Colour Selection Volume' "$swirl" --color-by U
    section Colour
    write calculate 'Q=q_criterion(U)'
    has "'--calculate=Q=q_criterion\(U\)'"
    section Volume
    write iso-array Q
    has '--iso-array=Q'
    click 'Add isosurface'
    has '--iso=[-0-9.]+'
    changed
    before=$(on_screen)
    write iso 5
    has '--iso=5 '
    until_other "$before"
    has '--color-by=U'
    quit
    ;;

  sector) # as the whole wheel, in the colours of the pressure
    begin 'Colour Selection Volume' pump:0.02:rotor
    section Slices
    write repeat-around 3
    has '--repeat-around=3'
    changed
    write wall-color data
    has '--wall-color=data'
    changed
    click edges 0.1
    has '--edges=[0-9.]+'
    changed
    quit
    ;;

  views) # come to what is rolled out, and go back from it, unless somebody has turned them
    begin 'Colour Selection Volume' pump:0.02:rotor --slice r=0.07
    section Slices
    camera() { # its numbers, rounded
      command_now | sed 's/.*--camera=\([^ ]*\).*/\1/' | tr , ' ' |
        awk '{ for (i = 1; i <= NF; i++) printf "%.4f ", $i + 0; print "" }'
    }
    sees() { # DIRECTION: the camera stands in this direction, of its focal point
      camera | awk -v wanted="$1" '{ x = $1 - $4; y = $2 - $5; z = $3 - $6
        is = y * y + z * z < 1e-6 * x * x && x > 0 ? "+x" : "aside"; exit is != wanted }' ||
        fail "the camera is not $1: $(camera)"
    }
    sees aside
    first=$(camera)
    click unroll
    has '--unroll'
    changed
    sees +x
    click Undo
    has_no '--unroll'
    [ "$(camera)" = "$first" ] || fail "$(camera) is not $first"
    xdotool mousemove 700 500 mousedown 1 mousemove 750 500 mouseup 1
    sleep 0.3
    first=$(camera)
    click unroll
    has '--unroll'
    [ "$(camera)" = "$first" ] || fail "a view that was turned has moved: $(camera), not $first"
    # The data's box would stand where nothing is shown.
    bare=$(at_rest 330 80 600 500)
    press b
    titled pump
    [ "$(at_rest 330 80 600 500)" = "$bare" ] || fail "there is a box about what is rolled out"
    click unroll
    has_no '--unroll'
    bare=$(at_rest 330 80 600 500)
    press b
    [ "$(at_rest 330 80 600 500)" = "$bare" ] && fail "b shows no box"
    quit
    ;;

  *)
    fail "no case $3"
    ;;
esac
