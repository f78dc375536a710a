#!/usr/bin/env bash
# panel.sh MOTE DATA CASE: one test of the window's panel, on the X server that DISPLAY names. What
# controls did is told by the command that the window prints, by its sessions and by the pictures
# that it saves.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  range) # is dragged, seen at once, undone as one; fields, and all again
    open "$copper" --size 1000x760
    picture all.png
    click show
    click c_centro
    drag histogram 0.0 0.05 0.1 0.2 0.3
    has '--show=c_centro=2[0-9.]*:8'
    picture some.png
    differ all.png some.png
    click Undo
    has '--show=c_centro=0:8'
    picture undone.png
    alike all.png undone.png
    click Redo
    has '--show=c_centro=2[0-9.]*:8'
    picture redone.png
    alike some.png redone.png
    click 'show all'
    has_no '--show'
    picture again.png
    alike all.png again.png
    # An expression does what a range does; a wrong one is refused below its field.
    write where 'c_centro >= 2 && type == 1'
    has "'--where=c_centro >= 2 && type == 1'"
    write calculate 'depth=z - 20'
    has "'--calculate=depth=z - 20'"
    refused where 'c_centro >'
    xdotool key --window 0 Escape
    gone 'active where'
    has "'--where=c_centro >= 2 && type == 1'"
    click color-by
    click depth
    has '--color-by=depth'
    # What the data show to be wrong stays in the field, too, to be mended there.
    refused where 'c_pee > -3.4'
    shown messages
    xdotool key --window 0 --delay 50 Tab
    gone 'active where'
    has "'--where=c_centro >= 2 && type == 1'"
    click where 0.9
    shown 'active where'
    xdotool key --window 0 --delay 50 Home Right Right Right Right Delete Return
    gone 'active where'
    has "'--where=c_pe > -3.4'"
    # Undo takes it from its field.
    refused calculate 'odd=nothing + 1'
    press Escape
    gone 'active calculate'
    click Undo
    has "'--where=c_centro >= 2 && type == 1'"
    click calculate
    shown 'active calculate'
    xdotool type --window 0 --delay 30 'far=z'
    xdotool key --window 0 Return
    has '--calculate=far=z '
    quit
    ;;

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

  rows) # every row of the table has a control, or is among the few that need none
    open "$copper" --size 1000x860
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

  types) # are hidden and shown one by one, and counted
    open "$data/hopper.dump.gz" --color-by type --size 1000x860
    picture all.png
    click 'type 2' 0.05
    has '--show=type=1,3:?'
    picture some.png
    differ all.png some.png
    click Invert
    has '--show=type=2 '
    click All
    has_no '--show'
    # Radii, ids and places may colour, and be chosen by, as other numbers are.
    click show
    click radius
    drag histogram 0.0 0.3
    has '--show=radius=[0-9.]+:[0-9.]+ '
    click 'show all'
    click show
    click 'v: vx' # components of vectors, too
    drag histogram 0.99 0.8 0.6
    has '--show=v:0=[-0-9.e]*:[-0-9.e]+ '
    click 'show all'
    click color-by
    click radius
    has '--color-by=radius '
    click color-by
    click z
    has '--color-by=z '
    click color-by
    click type
    picture again.png
    alike all.png again.png
    over 'type 3' 0.05
    xdotool keydown Control_L
    click 'type 3' 0.05
    xdotool keyup Control_L
    has '--show=type=3 '
    click 'type 3' 0.05 # none is left
    picture none.png
    differ all.png none.png
    click All
    click color-by
    click 'v magnitude'
    click reverse 0.05
    has '--reverse'
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

  colours) # components and maps are chosen from lists; the range is that of what is shown
    {
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n64\nITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n'
      echo 'ITEM: ATOMS id type x y z vx vy vz'
      for i in $(seq 0 63); do
        echo "$i $((1 + i % 2)) $((i % 4)) $((i / 4 % 4)) $((i / 16)) $((i * i)) $((-2 * i)) 0"
      done
    } >flow.dump
    open flow.dump --color-by v --size 1000x860
    click component
    click 'v: vy'
    has '--color-by=v:1 '
    picture forth.png
    click color-map
    click 'plasma reversed'
    has '--color-map=plasma .*--reverse'
    picture back.png
    differ forth.png back.png
    click color-map
    click 'plasma'
    has_no '--reverse'
    # Of what a type, an expression and ids hide, nothing counts.
    click 'type 1' 0.05
    has '--show=type=2'
    click 'Range of what is shown'
    has '--range=-126,-2 '
    write where 'x >= 0 && vx < 3000'
    click 'Range of what is shown'
    has '--range=-106,-2 '
    quit
    open flow.dump --color-by v:1 --hide-ids 0:2,61:63 --size 1000x860
    click 'Range of what is shown'
    has '--range=-120,-6 '
    quit
    ;;

  typelist) # has a line for each type: its colour, name and radius are chosen there
    {
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n56\nITEM: BOX BOUNDS ff ff ff\n0 8\n0 8\n0 2\n'
      echo 'ITEM: ATOMS id type x y z'
      for i in $(seq 0 55); do echo "$i $((1 + i % 14)) $((i % 8)) $((i / 8)) 0"; done
    } >many.dump
    open many.dump --color-by type --size 1000x860 --view +z
    picture start.png
    write 'type 2 name' wall
    has '--type-names=2=wall '
    picture named.png
    differ start.png named.png
    write 'type 14 radius' 0.9
    has '--type-radius=1=0\.[0-9]*,.*14=0.9 '
    picture large.png
    differ named.png large.png
    write 'type 14 radius' 0
    has_no '--type-radius'
    picture small.png
    alike named.png small.png
    click 'type 3 colour'
    sleep 0.5
    read -r x y < <(place 'type 3 colour')
    xdotool mousemove $((x + 40)) $((y + 60)) mousedown 1 mousemove $((x + 60)) $((y + 70)) sleep 0.3 mouseup 1
    press Escape
    settled
    has "'--type-colors=3=#[0-9a-f]{6}' "
    picture painted.png
    differ named.png painted.png
    press Control+s
    for _ in $(seq 100); do ls ./*.json >/dev/null 2>&1 && break; sleep 0.05; done
    grep -A 3 '"type-colors"' ./*.json | grep -q '3=#' || fail "the session has no colour of the type"
    click 'Usual colours'
    has_no '--type-colors'
    picture usual.png
    alike named.png usual.png
    press Control+z
    quit
    ;;

  inverts) # turn ranges, expressions and ids round
    open "$copper" --size 1000x900 --where 'c_pe > -3.4'
    total=24480
    shown_now() { awk '/ of 24,480 particles shown/ && NF > 6 { gsub(",", "", $1); print $1; exit }' "$MOTE_CONTROLS"; }
    shown 'Invert expression'
    settled
    some=$(shown_now)
    click 'Invert expression'
    has "'--where=!\(c_pe > -3.4\)'"
    [ $((some + $(shown_now))) = $total ] || fail "$some and $(shown_now) are not all"
    click 'Invert expression'
    has "'--where=c_pe > -3.4'"
    click where 0.9
    shown 'active where'
    xdotool key --window 0 --delay 50 ctrl+a BackSpace Return
    gone 'active where'
    has_no '--where'
    click show
    click c_centro
    drag histogram 0.0 0.3
    drag histogram 0.99 0.8
    settled
    some=$(shown_now)
    picture inside.png
    click 'invert c_centro'
    has '--show=c_centro=:[0-9.]*,[0-9.]*: '
    [ $((some + $(shown_now))) = $total ] || fail "$some and $(shown_now) are not all"
    picture outside.png
    differ inside.png outside.png
    drag histogram 0.3 0.4 # the edge of what is hidden
    [ $((some + $(shown_now))) -gt $total ] || fail "$some and $(shown_now) are no more"
    press Control+z
    click 'invert c_centro'
    settled
    [ "$(shown_now)" = "$some" ] || fail "$(shown_now) are shown, not $some again"
    picture again.png
    alike inside.png again.png
    click 'show all'
    click show
    click z
    drag histogram 0.0 0.4
    settled
    some=$(shown_now)
    click 'invert z'
    has "'--where=!\(z >= .* && z <= .*\)'"
    has_no '--show'
    [ $((some + $(shown_now))) = $total ] || fail "$some and $(shown_now) are not all"
    quit
    ;;

  curve) # of opacities is changed by the keys alone, and as numbers
    open "$data/swirl.1.vtu" --size 1000x860 --opacity 0%=0,100%=0.8
    shown opacity
    picture start.png
    press Tab
    go_to opacity
    press space
    shown 'active opacity'
    xdotool key --window 0 --delay 100 Up Up Right Next Down
    press space
    gone 'active opacity'
    has '--opacity=[^, ]*=0.04,[^, ]*=0.78 '
    press Tab Tab # folded, and back without the keys
    press Tab Tab
    click Rising
    has '--opacity=0%=0,100%=0.8'
    click 'opacity points'
    write 'opacity 1 opacity' 0.3
    has '--opacity=[^, ]*=0.3,[^, ]*=0.8 '
    click 'Add point'
    has '--opacity=[^, ]*=0.3,[^, ]*=0.55,[^, ]*=0.8 '
    click 'forget opacity 2'
    has '--opacity=[^, ]*=0.3,[^, ]*=0.8 '
    picture changed.png
    differ start.png changed.png
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

  volume) # opacities are drawn, dragged, and chosen
    open "$data/swirl.1.vtu" --size 1000x860
    picture usual.png
    click Rising
    has '--opacity=0%=0,100%=0.8'
    picture rising.png
    differ usual.png rising.png
    height=0.98 drag opacity 0.0 0.1 0.2
    has_no '--opacity=0%'
    over opacity 0.6 0.2
    # However busy the program is: two slow clicks are no double click, and two quick ones are one.
    before=$(inputs)
    kill -STOP $process
    xdotool click --repeat 2 --delay 700 1
    kill -CONT $process
    settled $((before + 4))
    has_no '--opacity=[^, ]*,[^, ]*,'
    xdotool click --repeat 2 --delay 60 1
    has '--opacity=[^, ]*,[^, ]*,[^, ]* '
    click Usual
    has_no '--opacity'
    picture again.png
    alike usual.png again.png
    quit
    ;;

  parts) # of a pump: one alone, its colours, its cells, its files
    open pump:0.002 --color-by pressure --opacity 0%=0.9,100%=0.9 --size 1000x1000
    section=$("$mote" info pump:0.002:rotor | awk '$2 == "pressure"')
    click 'data 1' 0.3
    click 'data 3' 0.3
    has '--hide-data=1,3'
    click 'Range of what is shown'
    read -r low high < <(sed 's/.*\[\(.*\), \(.*\)\].*/\1 \2/' <<<"$section")
    has "--range=${low:0:4}[.0-9]*,${high:0:4}[.0-9]* " # but for rounding
    click 'Range of the data'
    press r
    xdotool mousemove 700 470 sleep 0.2 click 1
    shown 'picked list'
    shown 'Hide picked'
    press ctrl+e
    for _ in $(seq 100); do
      [ -s pump-0.002-001-picked.csv ] && break
      sleep 0.1
    done
    grep -q '^cell,of,.*pressure' pump-0.002-001-picked.csv || fail "no pressure of the cell"
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
