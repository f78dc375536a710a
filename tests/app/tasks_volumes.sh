#!/usr/bin/env bash
# tasks_volumes.sh MOTE DATA CASE: the second twenty tasks of docs/tasks.md, in the window, on the X
# server that DISPLAY names. A case is one start of the program or two.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/tasks_common.sh"
swirl=$data/swirl.1.vtu

case $3 in
  colours)
    begin 'Colour Selection Volume' "$swirl" --color-by U
    section Colour
    changed
    task 23 'logarithmic colours of the speed'
    click log 0.05
    has '--color-by=U(:magnitude)? .*--log'
    changed
    click log 0.05
    has_no '--log'
    task 21 'colour by the pressure'
    click color-by
    click p
    has '--color-by=p '
    changed
    task 22 'one component of the velocity'
    click color-by
    click 'U magnitude'
    for component in x y z; do
      click component
      click "U: $component"
      has "--color-by=U:$(echo $component | tr xyz 012) "
    done
    changed
    task 27 'only where the water flows back'
    section Selection
    click show
    click 'U: z'
    write 'fields high' 0
    has '--show=U:2=-[0-9.]+:0 '
    changed
    quit
    ;;

  volume)
    begin 'Colour Selection Volume' "$swirl" --color-by U
    section Volume
    changed
    task 24 'fast water opaque, slow water clear'
    click Rising
    has '--opacity=0%=0,100%=0.8'
    changed
    task 29 'see deeper'
    write opacity-unit 0.05
    has '--opacity-unit=0.05'
    changed
    task 31 'light the volume'
    click lit 0.05
    has '--lit'
    changed
    task 28 'the walls'
    click cells
    click surface
    has '--cells=surface'
    click cells
    click auto
    has_no '--cells'
    quit
    ;;

  isosurfaces)
    begin 'Colour Selection Volume' "$swirl" --color-by p
    section Volume
    changed
    task 25 'the isosurface p = 0, and another place of it'
    click 'Add isosurface'
    has '--iso=-0.000[0-9]*'
    changed
    write iso 0
    has '--iso=0 '
    changed
    # It stands where 0 is between the least and the greatest value.
    over 'iso lines' 0.581 0.5
    before=$(on_screen)
    xdotool mousedown 1
    shown 'active iso lines'
    xdotool mousemove $(place 'iso lines' 0.75 0.5)
    until_other "$before" # while the button is held
    xdotool mouseup 1
    gone 'active iso lines'
    has '--iso=0.000[0-9]* '
    over 'iso lines' 0.3 0.5
    xdotool click --repeat 2 --delay 60 1
    has '--iso=0.000[0-9]*,-0.00[0-9]* '
    changed
    click 'iso lines' 0.3 0.5
    xdotool click 3
    has '--iso=0.000[0-9]* '
    task 26 'the cloud beside them, or without it'
    click cloud
    click on
    has '--cloud=on'
    changed
    click cloud
    click off
    has '--cloud=off'
    changed
    quit
    ;;

  looks)
    # A cell whose value is no number.
    begin 'Colour Selection Volume' "$swirl" --color-by p --calculate 'root=sqrt(p)'
    section Colour
    click color-by
    click root
    has '--color-by=root'
    changed
    task 30 'cells whose value is no number'
    click 'nan-color on' 0.5
    has '--nan-color=#8c8c8c'
    changed
    write nan-color red
    has '--nan-color=red'
    changed
    click color-by
    click p
    task 32 'along the axis, without perspective'
    section Camera
    click +z
    changed
    click orthographic 0.05
    has '--orthographic'
    changed
    task 35 'quantity and unit at the legend, on the left'
    section Picture
    write title 'p, m2/s2'
    click legend-side
    click left
    has "'--title=p, m2/s2' .*--legend-side=left"
    changed
    task 36 'a white background'
    write background white
    has '--background=#ffffff'
    changed
    press g
    has_no '--background'
    task 33 'values of a cell'
    xdotool mousemove 660 500 sleep 0.2 click 1
    shown 'picked list'
    press ctrl+e
    written swirl-001-picked.csv
    head -1 swirl-001-picked.csv | grep -q '^cell,.*U' || fail "$(head -1 swirl-001-picked.csv)"
    quit
    ;;

  keeping)
    cp "$data/swirl.0.vtu" "$data/swirl.1.vtu" .
    begin 'Colour Selection Volume' swirl.0.vtu swirl.1.vtu --color-by p
    section Colour
    task 34 'two times in the same colours'
    write 'range low' -0.001
    write 'range high' 0.004
    changed
    drag step 0.9 0.2 0.05
    has '--step=1 .*--range=-0.001,0.004'
    changed
    task 40 'the same picture on the cluster'
    click Command
    click Picture
    written swirl-001.png
    $(grep '^mote render' out | tail -1 | sed "s,^mote ,$mote ,; s,swirl-001.png,cluster.png,") >said ||
      { cat said; fail "the printed command fails"; }
    alike swirl-001.png cluster.png
    rm swirl-001.png
    task 39 'go on tomorrow'
    click Session
    written swirl-001.json
    task 38 'a film of one turn'
    section Film
    write picture-size 160x120
    write orbit 360
    write frames 4
    write output turn-%d.png
    click 'Save film'
    written turn-4.png
    [ "$(png_size turn-4.png)" = 160x120 ] || fail "the film is of $(png_size turn-4.png)"
    differ turn-1.png turn-2.png
    task 37 'a picture larger than the window'
    write picture-size 1200x1100
    click Picture
    written swirl-001.png
    [ "$(png_size swirl-001.png)" = 1200x1100 ] || fail "the picture is of $(png_size swirl-001.png)"
    rm swirl-001.png
    quit
    number=39
    open swirl-001.json --size 1000x1000 --samples 1
    picture tomorrow.png
    alike cluster.png tomorrow.png
    quit
    ;;

  *) fail "no case $3" ;;
esac
