#!/usr/bin/env bash
# tasks_particles.sh MOTE DATA CASE: the first twenty tasks of docs/tasks.md, in the window, on the X
# server that DISPLAY names. A case is one start of the program or two.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/tasks_common.sh"
hopper=$data/hopper.dump.gz

case $3 in
  colours)
    begin 'Colour Selection' "$copper"
    section Colour
    changed
    task 1 'colour by an array'
    click color-by
    click c_pe
    has '--color-by=c_pe'
    changed
    task 7 'the range of the colours'
    write 'range low' -3.6
    write 'range high' -3.4
    has '--range=-3.6,-3.4'
    changed
    task 8 'another map, the other way round'
    click color-map
    click plasma
    changed
    click reverse 0.05
    has '--color-map=plasma .*--reverse'
    changed
    quit
    begin 'Colour Selection' "$hopper"
    section Colour
    pictures=0
    changed
    task 9 'a new quantity'
    write calculate 'energy=0.5*v^2'
    has '--calculate=energy=0.5.v.2'
    click color-by
    click energy
    has '--color-by=energy'
    changed
    quit
    ;;

  selection)
    begin 'Colour Selection' "$copper"
    section Selection
    changed
    task 2 'an expression'
    write where 'c_pe > -3.4'
    has "'--where=c_pe > -3.4'"
    changed
    task 4 'count what is left'
    left=$("$mote" render "$copper" -o count.png --size 64x64 --where 'c_pe > -3.4' |
      sed 's/.*, \([0-9,]*\) of 24,480.*/\1/')
    shown "$left of 24,480 particles shown"
    task 3 'a range is dragged'
    wipe where
    has_no '--where'
    click show
    click c_centro
    over histogram 0.0 0.5
    before=$(on_screen)
    xdotool mousedown 1
    shown 'active histogram'
    xdotool mousemove $(place histogram 0.2 0.5)
    until_other "$before" # while the button is held
    xdotool mouseup 1
    gone 'active histogram'
    has '--show=c_centro=[1-9][0-9.]*:'
    click 'show all'
    same_as_first
    task 16 'cut open'
    click show
    click y
    drag histogram 0.0 0.3 0.5
    has '--show=y=[0-9.]+:'
    changed
    click 'show all'
    task 17 'the tail of a distribution'
    section Plot
    click 'plot x'
    click c_centro
    drag plot 0.4 0.6 0.9
    has '--show=c_centro=[0-9.]+:[0-9.]+ '
    changed
    quit
    ;;

  kinds)
    begin 'Colour Selection' "$hopper" --color-by type
    section Selection
    changed
    task 5 'one type alone'
    over 'type 2' 0.05
    xdotool keydown Control_L
    click 'type 2' 0.05
    xdotool keyup Control_L
    has '--show=type=2 '
    changed
    click All
    same_as_first
    task 10 'larger particles'
    section Radius
    write radius-scale 1.5
    has '--radius-scale=1.5'
    changed
    press bracketleft
    has '--radius-scale=1.3'
    task 20 'save the view and come back'
    section Camera
    pictures=0
    changed
    click saved-view
    xdotool type --window 0 --delay 20 'top left'
    click 'Save view'
    shown 'go to top left'
    has_no '--saved-view' # which makes no other picture
    press Y
    changed
    click 'go to top left'
    same_as_first
    press ctrl+s
    written hopper-001.json
    grep -q '"top left=' hopper-001.json || fail "the session has no view"
    click 'forget top left'
    gone 'go to top left'
    quit_changed
    # The session of above has the view.
    begin 'Colour Selection' hopper-001.json
    section Camera
    press Y
    click 'go to top left'
    shown 'go to top left'
    quit
    ;;

  sets)
    begin 'Data Colour Selection' "$copper" "$data/lj-fracture.dump.gz" --color-by none
    section Data
    changed
    task 6 'one of two data sets'
    click 'data 2' 0.5
    has '--hide-data=2'
    changed
    "$mote" render "$copper" "$data/lj-fracture.dump.gz" -o alone.png --size 64x64 --hide-data 2 >said
    said said '24,480 of 44,355 particles shown'
    click 'data 1' 0.5 # nothing is left, and nothing is wrong
    has '--hide-data=1,2'
    changed
    press ctrl+z ctrl+z
    has_no '--hide-data'
    same_as_first
    click 'data 1 arrays' 0.6
    click 'data 1 c_centro' 0.2
    has '--color-by=c_centro'
    quit
    run 1 "$mote" render "$copper" -o alone.png --hide-data 2
    one_sentence
    said err 'no data set 2'
    task 11 'neighbours across the periodic box'
    begin 'Colour Selection' "$data/lj-fracture.dump.gz"
    pictures=0
    changed
    section Structure
    write replicate 2,1,2
    has '--replicate=2,1,2'
    changed
    quit
    ;;

  asking)
    begin 'Colour Selection' "$copper" --color-by none
    changed
    task 12 'values under the mouse'
    xdotool mousemove 340 300
    press Escape # the greeting goes
    at_rest 330 60 660 880 >/dev/null
    before=$(on_screen)
    xdotool mousemove 640 500
    until_other "$before"
    task 13 'values of one particle'
    xdotool click 1
    shown 'picked list'
    press ctrl+e
    written copper-scratch-001-picked.csv
    [ "$(wc -l <copper-scratch-001-picked.csv)" = 2 ] || fail "not one is listed"
    task 14 'a distance'
    xdotool mousemove 560 480 keydown Shift_L click 1 keyup Shift_L
    for _ in $(seq 100); do
      grep -q '^distance [1-9]' "$MOTE_CONTROLS" && break
      sleep 0.1
    done
    grep -q '^distance [1-9]' "$MOTE_CONTROLS" || fail "no distance is told"
    task 15 'take away what is in front'
    xdotool mousemove 600 450 keydown Control_L mousedown 1 sleep 0.1 mousemove 650 500 sleep 0.1 \
      mousemove 700 550 mouseup 1 keyup Control_L
    sleep 0.3
    click 'Hide picked'
    has '--hide-ids='
    changed
    press u
    same_as_first
    quit
    ;;

  light)
    begin 'Colour Selection' "$copper" --color-by none
    press Home
    has '--step=1 '
    changed
    task 18 'light from the right, with shadows'
    section Light
    over 'light ball' 0.3 0.3
    xdotool mousedown 1
    shown 'active light ball'
    xdotool mousemove $(place 'light ball' 0.6 0.4) sleep 0.2 mousemove $(place 'light ball' 0.8 0.4)
    sleep 0.2
    xdotool mouseup 1
    gone 'active light ball'
    has '--light=[34][0-9],1[0-9]'
    changed
    drag 'light azimuth' 0.6 0.4 0.3
    has '--light=-[0-9]+,1[0-9]'
    changed
    drag 'light ball' 0.8 0.9 1.3 # over the rim and behind
    has '--light=1[4-7][0-9],'
    changed
    click shadows-offers
    click soft
    has '--shadows=soft'
    changed
    press ctrl+z ctrl+z ctrl+z ctrl+z
    same_as_first
    task 19 'the third step, and on'
    drag step 0.02 0.2 0.4
    has '--step=3 '
    changed
    click Play
    shown Pause
    has '--step=[4567] '
    click Pause
    quit
    ;;

  *) fail "no case $3" ;;
esac
