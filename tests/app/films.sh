#!/usr/bin/env bash
# films.sh MOTE DATA CASE: one test of the films and pictures that the window saves.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# written FILE: the file is there, within a while.
written() {
  for _ in $(seq 600); do
    [ -e "$1" ] && return
    kill -0 $process 2>/dev/null || { cat err; fail "the program had ended"; }
    sleep 0.05
  done
  fail "no $1"
}

# film_section: folds what stands above it away.
film_section() {
  click 'group Colour' 0.8
  click 'group Selection' 0.8
  click 'group Film' 0.8
}

case $3 in
  film) # of time steps, of an orbit, through views: the view alone, and all is as it was
    open "$data/hopper.dump.gz" --size 1000x900 --samples 1 --picture-size 160x120 --color-by type
    press Left
    picture before.png
    [ "$(png_size before.png)" = 160x120 ] || fail "the picture is $(png_size before.png)"
    film_section
    shown '56 frames, 2.24 s'
    click 'Save film'
    written hopper-001.ogv
    [ "$(python3 "$tests/film_facts.py" hopper-001.ogv)" = '160x120 56 frames 25 fps playable complete' ] ||
      fail "the film is: $(python3 "$tests/film_facts.py" hopper-001.ogv)"
    picture after.png
    alike before.png after.png
    has '--step=6'
    # Frames are those of mote animate.
    write output film-%02d.png
    write orbit 90
    write frames 3
    shown '3 frames, 0.12 s'
    click 'Save film'
    written film-03.png
    picture after.png
    alike before.png after.png
    alike before.png film-01.png
    differ film-01.png film-02.png
    # Views.
    write orbit 0
    click 'Add this view'
    press x
    picture side.png
    click 'Add this view'
    shown 'view 2'
    rm film-*.png
    click 'Save film'
    written film-03.png
    picture after.png
    alike side.png after.png
    alike before.png film-01.png
    alike side.png film-03.png
    click 'view 1'
    picture again.png
    alike before.png again.png
    # Sessions keep the views, and undo brings them back.
    click 'Forget all'
    shown 'key frames: 0'
    press ctrl+z
    shown 'key frames: 2'
    press ctrl+s
    written hopper-001.json
    run 0 "$mote" animate hopper-001.json -o kept-%d.png --frames 3
    alike before.png kept-1.png
    alike side.png kept-3.png
    differ kept-2.png kept-1.png
    quit
    open hopper-001.json --size 1000x900
    film_section
    shown 'key frames: 2'
    click 'view 2'
    picture again.png
    alike side.png again.png
    quit
    ;;

  stop) # by Escape: the film has the frames that there are; by q the window goes, too
    open "$copper" --size 1000x900 --samples 1 --picture-size 160x120
    film_section
    write orbit 360
    write frames 100000
    over 'Save film'
    xdotool click 1
    written copper-scratch-001.part.ogv
    # What was there stays behind the bar, darkened: the panel, too.
    for _ in $(seq 100); do
      read -r _ colors < <(python3 "$tests/screen.py" 5 100 280 16) # of a gradient, 16
      [ "$colors" -gt 24 ] && break
      sleep 0.1
    done
    [ "$colors" -gt 24 ] || fail "the window is empty while it makes a film: $colors colours"
    press Escape
    written copper-scratch-001.ogv
    python3 "$tests/film_facts.py" copper-scratch-001.ogv | grep -q 'playable complete' ||
      fail "the film is: $(python3 "$tests/film_facts.py" copper-scratch-001.ogv)"
    picture after.png
    [ "$(png_size after.png)" = 160x120 ] || fail "the picture is $(png_size after.png)"
    quit
    ;;

  *)
    fail "no case $3"
    ;;
esac
