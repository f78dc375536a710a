#!/usr/bin/env bash
# panel.sh MOTE DATA CASE: one test of the window's panel, on the X server that DISPLAY names. What
# controls did is told by the command that the window prints, by its sessions and by the pictures
# that it saves.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  costs) # what a frame takes, stage by stage, and the process; how far occlusion is baked
    open "$copper" --size 1000x900 --silhouettes=2
    for group in Colour Selection; do
      click "group $group" 0.8
    done
    click 'group Costs' 0.8
    # told PATTERN: a line of the costs, within a while.
    told() {
      for _ in $(seq 400); do
        grep -Eq "^$1" "$MOTE_CONTROLS" && return
        sleep 0.05
      done
      cat "$MOTE_CONTROLS"
      fail "the costs do not tell: $1"
    }
    for stage in rays silhouettes panel 'to the screen' 'the rest'; do
      told "- $stage [0-9.]+ m?s, [0-9.e-]+ % "
    done
    told 'frame [0-9.]+ m?s '
    told 'process [0-9.]+ [MG]B of memory '
    xdotool mousemove 700 400
    xdotool key --window 0 t
    xdotool key --window 0 t # baked
    told 'quality .*, ambient occlusion [0-9]+ % baked'
    told 'quality [0-9]+ samples per pixel [0-9]'
    quit
    ;;

  busy) # what lay behind a bar is drawn again, all of it
    many_particles many.vtp
    open many.vtp --size 1000x700 --no-preview --samples 1
    for group in Colour Selection; do
      click "group $group" 0.8
    done
    xdotool mousemove 700 600
    before=$(at_rest 0 60 300 500)
    xdotool key --window 0 bracketright # is built anew
    has '--radius-scale='
    xdotool mousemove 700 610
    [ "$(at_rest 0 60 300 500)" = "$before" ] || fail "the panel stays as it was behind the bar"
    quit
    ;;

  arrays) # of a data set, each with its range beside it or below
    open pump:0.001 --size 1000x900
    click 'data 1 arrays'
    shown 'data 1 range of velocity:magnitude'
    read -r right _ < <(place 'data 1 range of velocity:magnitude' 1)
    [ "$right" -le 302 ] || fail "the range ends at $right"
    read -r left y < <(place 'data 1 range of velocity:magnitude' 0)
    read -r _ name < <(place 'data 1 velocity:magnitude' 0)
    # The name ends at 145.
    [ "$left" -gt 150 ] || [ "$y" -gt $((name + 8)) ] || fail "the range lies over the name"
    quit
    ;;

  rows) # every row of the table has a control, or is among the few that need none
    open "$copper" --size 1000x980
    shown 'group Picture'
    "$mote" help --format markdown >settings.md
    for group in Radius Light Silhouettes Camera Picture Structure; do
      click "group $group" 0.8
      cat "$MOTE_CONTROLS" >>all
      click "group $group" 0.8
    done
    cat "$MOTE_CONTROLS" >>all
    for row in color-by color-map range log show radius type-radius radius-scale structure form \
      zoom orthographic shadows light light-size light-intensity ambient-occlusion \
      occlusion-reach path-trace silhouettes silhouette-thickness silhouette-opacity \
      silhouette-color silhouette-on-pixels silhouette-step-pixels silhouette-groups \
      silhouette-no-hulls samples noise background legend title legend-side legend-format \
      font-scale caption box axes picture-size lod-error; do
      grep -q "^$row " all || fail "no control of --$row"
    done
    quit
    open sphere:1000 --size 1000x860
    click 'group Picture' 0.8
    drag lod-error 0.02 0.3 0.5
    has '--lod-error=(0\.[0-9]+|[1-9](\.[0-9]*)?) ' # half way is little of 64
    quit
    ;;

  controls) # of each kind change what they should, and excluded ones give way
    open "$copper" --size 1000x980
    click 'group Selection' 0.8 # which leaves room for the rest
    click 'group Light' 0.8
    click shadows-offers
    click soft
    has '--shadows=soft'
    write ambient-occlusion 8
    has '--ambient-occlusion=8'
    click path-trace 0.05
    has '--path-trace'
    has_no '--ambient-occlusion'
    drag light-size 0.1667 0.3 0.5
    has '--light-size=(4|5)[0-9.]*'
    refused occlusion-reach -4 # cannot be, and is told
    press Escape
    gone 'active occlusion-reach'
    has_no '--occlusion-reach'
    click 'group Light' 0.8
    click 'group Picture' 0.8
    write fps 30
    click 'forget fps'
    gone 'forget fps'
    click 'group Picture' 0.8
    write 'range low' 90 # beyond the upper end, which goes along
    has '--range=90,173[0-9.]*'
    write 'range high' 120
    has '--range=90,120'
    click 'Range of the data'
    has_no '--range'
    click color-map
    click plasma
    has '--color-map=plasma'
    click color-by
    click c_pe
    has '--color-by=c_pe'
    click log 0.05 # of values below 0: refused, and all stays
    has_no '--log'
    click step 0.3
    titled copper
    has '--step=3'
    quit
    ;;

  steady) # is what stands below the count, however long that is
    open lattice:1500000 --size 1000x760
    shown Undo
    before=$(place Undo)
    click show
    click z
    drag histogram 0.99 0.9
    has '--show=z=[-0-9.]*:[0-9.]+ '
    [ "$(place Undo)" = "$before" ] || fail "the panel moves from $before to $(place Undo)"
    quit
    ;;

  keys) # go to texts while they are written, else to the view; Tab folds the panel
    open "$copper" --size 1000x860
    picture start.png
    [ "$(png_size start.png)" = 680x860 ] || fail "the view is $(png_size start.png)"
    press Left # is the view's, and so it is when the panel was worked by the mouse
    has '--step=6'
    click Undo
    has '--step=7'
    press Left
    has '--step=6'
    press Right
    has '--step=7'
    picture start.png # ranges of colours have widened
    click 'group Selection' 0.8 # which leaves room for the rest
    click 'group Colour' 0.8
    click 'group Picture' 0.8
    write title momcp
    has '--title=momcp'
    has_no '--color-map'
    press m
    has '--color-map='
    press Control+z Control+z
    has_no '--title'
    # What is dragged in the panel does not turn the view, nor the other way round.
    over Undo 0.5 -2
    xdotool mousedown 1 mousemove 150 600 mousemove 700 600 mouseup 1
    sleep 0.3
    picture still.png
    alike start.png still.png
    xdotool mousemove 700 400 mousedown 1 mousemove 600 400 mousemove 100 420 mouseup 1
    sleep 0.3
    picture turned.png
    differ start.png turned.png
    press Control+z Tab Tab # the first gives it the keys
    picture folded.png
    [ "$(png_size folded.png)" = 1000x860 ] || fail "the folded view is $(png_size folded.png)"
    press Tab
    picture open.png
    [ "$(png_size open.png)" = 680x860 ] || fail "the view is $(png_size open.png) again"
    quit
    # All keys are told within the view.
    open "$copper" --size 1280x860
    settled
    read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
    edge() { python3 "$tests/screen.py" $((x + 1272)) "$y" 8 700; }
    picture sharp.png
    none=$(edge)
    words=$(python3 "$tests/screen.py" $((x + 340)) "$y" 800 600)
    press h
    for _ in $(seq 100); do
      [ "$(python3 "$tests/screen.py" $((x + 340)) "$y" 800 600)" != "$words" ] && break
      sleep 0.05
    done
    sleep 0.5
    [ "$(python3 "$tests/screen.py" $((x + 340)) "$y" 800 600)" != "$words" ] || fail "no keys are told"
    [ "$(edge)" = "$none" ] || fail "the keys go on beyond the view"
    quit
    # What is too small for a panel has none.
    open "$copper" --size 250x160
    picture tiny.png
    [ "$(png_size tiny.png)" = 250x160 ] || fail "the view is $(png_size tiny.png)"
    quit
    ;;

  tips) # are told by all controls: what they do, and their name on the command line
    # told NAME WORDS [X]: over the control a text stands beside the mouse that begins so.
    told() {
      over "$1" "${3:-0.5}"
      for _ in $(seq 100); do
        grep -q "^tip $2" "$MOTE_CONTROLS" && return
        sleep 0.05
      done
      grep '^tip' "$MOTE_CONTROLS"
      fail "$1 tells not: $2"
    }
    open "$data/swirl.1.vtu" --size 1000x900
    told Usual 'The opacities that Mote chooses'
    told Rising 'The greater the value'
    told Falling 'The less the value'
    told Even 'All values'
    told opacity 'Drag points' 0.5
    told 'opacity points' 'The points of the curve'
    told 'range low' 'The values at the two ends'
    quit
    open "$copper" --size 1000x980 --show z=0:20 --range 0 50 --trajectories 1,2
    told 'No paths' 'Take the paths away'
    told All 'Show all types'
    told Invert 'Show the types that are hidden'
    told 'type 1' 'Show this type' 0.1
    told 'type 1 name' 'The type.s name'
    told 'type 1 radius' 'The type.s radius'
    told 'invert z' 'Show what is hidden'
    told 'show all' 'Take this range away'
    told 'Range of the data' 'Colours go from'
    told 'Range of what is shown' 'Colours go from'
    told 'Range of all steps' 'Reads all time steps'
    for group in Colour Selection; do click "group $group" 0.8; done
    click 'group Plot' 0.8
    click 'plot x'
    click z
    gone z
    told 'plot visible' 'Whose values' 0.1
    told 'plot x' 'What is plotted to the right'
    told 'plot y' 'What is plotted upwards'
    told 'Show all of these' 'Take the ranges'
    quit
    ;;

  window) # its letters, and the memory for steps, are changed while it is open
    open "$copper" --size 1100x980
    for group in Time Colour Selection; do
      [ $group = Time ] || click "group $group" 0.8
    done
    shown 'cache 7/7'
    write cache 0
    gone 'cache 7/7'
    press Left
    has '--step=6 '
    write cache 4G
    shown 'cache 7/7'
    click 'group Window' 0.8
    height_of() { awk -v name="$1" 'index($0, name " ") == 1 { print $NF - $(NF - 2); exit }' "$MOTE_CONTROLS"; }
    before=$(height_of Undo)
    write ui-scale 1.5
    settled
    for _ in $(seq 100); do [ "$(height_of Undo)" -gt "$before" ] && break; sleep 0.05; done
    [ $((10 * $(height_of Undo))) -gt $((13 * before)) ] || fail "buttons are $(height_of Undo) high, not $before"
    picture large.png
    [ "$(png_size large.png)" = 620x980 ] || fail "the view is $(png_size large.png)"
    press Control+z
    for _ in $(seq 100); do [ "$(height_of Undo)" = "$before" ] && break; sleep 0.05; done
    [ "$(height_of Undo)" = "$before" ] || fail "buttons are $(height_of Undo) high, not $before again"
    quit
    ;;

  over) # a small view has no axes that would lie over its texts
    open "$copper" --size 1000x650 --color-by none
    at_rest 330 520 110 80 >/dev/null
    [ "$(python3 "$tests/screen.py" 330 520 110 80 red)" -gt 20 ] || fail "no axes"
    xdotool windowsize --sync "$window" 640 400
    xdotool mousemove 500 200
    at_rest 320 250 320 110 >/dev/null
    [ "$(python3 "$tests/screen.py" 320 250 120 110 red)" = 0 ] || fail "axes in a small view"
    quit
    ;;

  enlarged) # a window that was too small for the panel has one when there is room
    open "$copper" --size 250x160
    sized tiny.png 250x160
    xdotool windowsize --sync "$window" 1000 760
    shown Undo
    sized large.png 680x760
    over color-map
    xdotool windowsize --sync "$window" 250 160
    sized tiny.png 250x160
    xdotool windowsize --sync "$window" 900 700
    sized large.png 580x700
    click color-map
    click plasma
    has '--color-map=plasma'
    quit
    ;;

  keyboard) # and no mouse: sections are folded, lists chosen from, fields written, boxes ticked
    open "$copper" --size 1000x760
    shown color-map
    press Tab
    go_to 'group Colour'
    press space
    gone color-map
    press space
    shown color-map
    go_to color-map
    press space
    shown plasma
    go_to inferno
    press space
    gone inferno
    has '--color-map=inferno '
    go_to reverse
    press space
    has '--reverse'
    go_to 'group Selection'
    go_to where
    press Return
    shown 'active where'
    xdotool type --window 0 --delay 30 'c_pe > -3.4'
    press Return
    gone 'active where'
    has "'--where=c_pe > -3.4'"
    go_to 'Invert expression'
    press space
    has "'--where=!\(c_pe > -3.4\)'"
    go_to 'group Light'
    press space
    shown headlight
    go_to headlight
    press space
    shown 'active headlight'
    xdotool key --window 0 --delay 100 Right Right Right
    press space
    gone 'active headlight'
    has '--headlight=[1-9][.0-9]* '
    go_to 'group Camera'
    press space
    go_to +x
    press space
    has '--camera=[1-9][0-9.]*,[-0-9.e]*,'
    press Control+z Control+z
    has_no '--headlight'
    press Tab # the panel goes
    picture folded.png
    [ "$(png_size folded.png)" = 1000x760 ] || fail "the folded view is $(png_size folded.png)"
    quit
    ;;

  fields) # are taken however they are left; colours have names; open lists keep letters from the view
    open "$copper" --size 1000x860 --picture-size 300x200
    has '--size=300x200' # of the picture that is saved
    click 'range low'
    xdotool key --window 0 --delay 50 ctrl+a 3 Tab Escape
    has '--range=3,'
    refused cache 4z # a unit that there is none of
    xdotool key --window 0 Escape
    gone 'active cache'
    # What is longer than its field stands whole below it.
    write where 'c_centro > 0 && c_pe < 0 && x < 1000'
    shown 'whole text'
    write where 'x < 1000'
    gone 'whole text'
    click color-map
    shown plasma
    xdotool key --window 0 --delay 50 l q
    click plasma
    has '--color-map=plasma'
    has_no '--no-legend'
    click color-by
    click 'one colour'
    write plain-color steelblue
    has '--plain-color=steelblue'
    # Ctrl+Z while a field is written in undoes nothing of the view, nor does the program fall over
    # where it has changed the field's text itself.
    click plain-color
    shown 'active plain-color'
    xdotool key --window 0 --delay 50 ctrl+a r e d ctrl+z ctrl+z ctrl+y ctrl+z Escape
    gone 'active plain-color'
    has '--color-by=none'
    write plain-color steelblue
    has '--plain-color=steelblue'
    refused plain-color nocolour
    press Escape
    gone 'active plain-color'
    has '--plain-color=steelblue'
    quit
    # Cells that are shown by their surface may become a volume again.
    open "$data/swirl.1.vtu" --size 1000x860 --cells surface
    click cells
    click volume
    has_no '--cells=surface'
    shown opacity
    quit
    ;;

  scale) # of the panel's texts and controls
    size() { awk -v name="$1" '$1 == name { print $4 - $2, $5 - $3 }' "$MOTE_CONTROLS"; }
    declare -A wide high
    for scale in 1 2; do
      open "$copper" --size 1280x1000 --ui-scale $scale
      shown Undo
      settled
      read -r wide[$scale] high[$scale] < <(size Undo)
      # The texts are larger, and not only the room that they have: rows of the button that have ink.
      read -r x y < <(place Undo 0 0)
      python3 "$tests/screen.py" "$x" "$y" "${wide[$scale]}" "${high[$scale]}" save undo-$scale.png
      quit
    done
    twice() { [ $((10 * $2)) -ge $((19 * $1)) ] && [ $((10 * $2)) -le $((21 * $1)) ]; }
    twice "${wide[1]}" "${wide[2]}" && twice "${high[1]}" "${high[2]}" ||
      fail "the button is ${wide[*]} wide, ${high[*]} high"
    ink() { python3 "$tests/drawn.py" "undo-$1.png" 2 $((${wide[$1]} - 3)) 2 $((${high[$1]} - 3)) light; }
    read -r low < <(ink 1)
    read -r much < <(ink 2)
    [ "$much" -ge $((3 * low)) ] && [ "$much" -le $((5 * low)) ] || fail "$low pixels of text, then $much"
    ;;

  *)
    fail "no case $3"
    ;;
esac
