#!/usr/bin/env bash
# flow.sh MOTE DATA CASE: one test of streamlines and arrows; the case window needs the X server that
# DISPLAY names.
tests=$(cd "$(dirname "$0")" && pwd)
swirl=$2/swirl.1.vtu

case $3 in
  pictures)
    source "$tests/common.sh"
    unset DISPLAY
    look=(render "$swirl" --size 200x160 --samples 1 --caption '' --color-by U)
    run 0 "$mote" "${look[@]}" -o lines.png --streamlines 40 --save-session s.json
    said out '40 streamlines'
    run 0 "$mote" render s.json --size 200x160 --samples 1 --caption '' -o again.png
    alike lines.png again.png
    run 0 "$mote" "${look[@]}" -o one.png --threads 1 --streamlines 40
    alike lines.png one.png
    for more in "--streamlines 20" "--streamlines 40 --arrows 30" "--streamlines 40 --streamline-width 0.002" \
      "--streamlines 40 --streamline-length 0.01" "--streamlines 40 --flow-from 0,0,0,0.02,0,0" \
      "--streamlines 40 --cut x=0:" "--streamlines 40 --color-by p" "--streamlines 40 --repeat-around 3 --cut-axis 0.03,0,0,0,0,1"; do
      # shellcheck disable=SC2086
      run 0 "$mote" "${look[@]}" -o other.png $more
      ! cmp -s lines.png other.png || fail "$more changes nothing"
    done
    run 0 "$mote" "${look[@]}" -o arrows.png --arrows 100
    run 0 "$mote" "${look[@]}" -o longer.png --arrows 100 --arrow-scale 2
    ! cmp -s arrows.png longer.png || fail 'arrows are no longer'
    # Films find the lines of each step.
    run 0 "$mote" animate "$2/swirl.0.vtu" "$swirl" -o film.%02d.png --steps all --frames-per-step 1 --size 80x60 \
      --samples 1 --streamlines 10 --caption ''
    ;;

  errors)
    source "$tests/common.sh"
    unset DISPLAY
    run 1 "$mote" render "$swirl" -o a.png --streamlines 10 --flow-array speed
    one_sentence
    said err "there is no array 'speed'"
    run 1 "$mote" render "$swirl" -o a.png --arrows 10 --flow-array p
    said err 'three components'
    run 2 "$mote" render "$swirl" -o a.png --streamlines 10 --flow-from 1,2,3
    said err 'six numbers'
    run 2 "$mote" render "$swirl" -o a.png --streamlines -1
    [ ! -e a.png ] || fail 'a picture in spite of errors'
    run 0 "$mote" render sphere:100 -o a.png --size 80x60 --streamlines 5
    said err 'do nothing here'
    ;;

  window) # lines come and go with the panel, and follow undo
    source "$tests/panel_common.sh"
    open "$swirl" --size 1000x900 --color-by U
    for group in Data Colour Selection; do click "group $group"; done
    picture before.png
    click 'group Flow'
    write streamlines 30
    has '--streamlines=30'
    picture lines.png
    differ before.png lines.png
    write arrows 50
    has '--arrows=50'
    picture both.png
    differ lines.png both.png
    write flow-array nothing
    has_no '--flow-array'
    press Escape
    click flow-array-offers # what there is to choose: vectors alone
    shown U
    gone p
    click U
    has '--flow-array=U '
    press ctrl+z ctrl+z ctrl+z
    has_no '--streamlines'
    picture again.png
    alike before.png again.png
    quit
    ;;

  *) exit 2 ;;
esac
echo "$3: passed"
