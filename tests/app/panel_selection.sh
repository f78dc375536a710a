#!/usr/bin/env bash
# panel_selection.sh MOTE DATA CASE: one test of the panel's ranges, types and expressions, on the X server that DISPLAY
# names; see panel.sh.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  beside) # a range beside all values, as of other data, never gets its ends the wrong way round
    open "$copper" --size 1000x980 --show z=1000:2000
    write 'fields high' 5
    has '--show=z=5 '
    write 'fields low' 2
    has '--show=z=2:5 '
    ;;

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

  save) # what is shown, and what is picked, as data
    # points FILE: how many it has.
    points() {
      for _ in $(seq 200); do
        [ -s "$1" ] && break
        sleep 0.05
      done
      "$mote" info --json "$1" | grep -o '"points": [0-9]*' | head -1
    }
    open "$copper" --size 1000x1000 --show type=1
    click 'Save what is shown'
    "$mote" convert "$copper" --show type=1 expected.vtp >/dev/null || fail "no file to compare with"
    [ "$(points copper-scratch-001-shown.vtp)" = "$(points expected.vtp)" ] || fail "others were saved"
    # A rectangle over the middle picks what is seen there.
    rectangle 1 600 450 700 520
    click 'Save data'
    picked=$(points copper-scratch-001-picked.vtp | grep -o '[0-9]*$')
    [ "$picked" -gt 10 ] && [ "$picked" -lt 10000 ] || fail "'$picked' were saved"
    quit
    open "$data/swirl.0.vtu" --size 1000x860 --cut x=0:
    click 'Save what is shown'
    "$mote" convert "$data/swirl.0.vtu" --cut x=0: expected.vtu >/dev/null || fail "no file to compare with"
    [ "$(points swirl-001-shown.vtu)" = "$(points expected.vtu)" ] || fail "other cells were saved"
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

  cells) # of a volume and of a mesh: ranges are dragged, seen while they are, and undone as one
    screen() { python3 "$tests/screen.py" $((x + 330)) "$y" 500 800; }
    # dragged PATTERN: the range is dragged from its upper end, and what is seen changes meanwhile.
    dragged() {
      local before
      over histogram 0.99
      before=$(at_rest $((x + 330)) "$y" 500 800)
      xdotool mousedown 1
      shown 'active histogram'
      for share in 0.9 0.7 0.5; do
        xdotool mousemove $(place histogram $share)
        sleep 0.1
      done
      for _ in $(seq 100); do
        [ "$(screen)" != "$before" ] && break
        sleep 0.05
      done
      [ "$(screen)" != "$before" ] || fail "nothing is seen of the range before it is let go"
      xdotool mouseup 1
      gone 'active histogram'
      has "$1"
    }
    shown_now() { awk '/ of [0-9,]* [a-z]* shown/ && NF > 6 { gsub(",", "", $1); print $1; exit }' "$MOTE_CONTROLS"; }
    for kind in volume surface; do
      even=()
      [ $kind = surface ] || even=(--opacity 0%=0.5,100%=0.5)
      open "$data/swirl.1.vtu" --size 1000x980 --cells $kind --color-by p --samples 2 "${even[@]}"
      read -r x y < <(xdotool getwindowgeometry "$window" | sed -n 's/.*Position: \([0-9]*\),\([0-9]*\).*/\1 \2/p')
      click 'group Colour' 0.8
      settled
      [ "$(shown_now)" = 8547 ] || fail "$(shown_now) cells are shown first"
      picture all.png
      # A place, an array that does not colour, and the one that does.
      for name in z 'U magnitude' p; do
        click show
        click "$name"
        case $name in
          z) dragged '--show=z=[-0-9.e]*:[-0-9.e]+ ' ;;
          p) dragged '--show=p=[-0-9.e]*:[-0-9.e]+ ' ;;
          *) dragged '--show=U(:magnitude)?=[-0-9.e]*:[-0-9.e]+ ' ;;
        esac
        settled
        some=$(shown_now)
        [ "$some" -gt 0 ] && [ "$some" -lt 8547 ] || fail "$kind: $some cells are shown by $name"
        picture some.png
        differ all.png some.png
        click Undo
        settled
        [ "$(shown_now)" = 8547 ] || fail "$kind: $(shown_now) cells are shown when $name is undone"
        picture undone.png
        # A curve that is cut at its own ends differs from the whole one by rounding.
        [ "$name" = p ] || alike all.png undone.png
        click Redo
        settled
        [ "$(shown_now)" = "$some" ] || fail "$kind: $(shown_now) cells are shown by $name again"
        picture redone.png
        alike some.png redone.png
        click 'show all'
        has_no '--show'
        picture again.png
        alike all.png again.png
      done
      quit
    done
    ;;

  plot) # of an array that does not colour: what is selected in it is shown
    open "$copper" --size 1000x980 --color-by type
    for group in Colour Selection; do click "group $group" 0.8; done
    click 'group Plot' 0.8
    picture all.png
    click 'plot x'
    click c_pe
    gone c_pe
    drag plot 0.3 0.4 0.6 0.8
    has '--show=c_pe=-[0-9.]+:-[0-9.]+ '
    has '--color-by=type '
    picture some.png
    differ all.png some.png
    click 'plot y'
    click c_centro
    gone c_centro
    click 'Show all of these'
    has_no '--show'
    picture again.png
    alike all.png again.png
    quit
    # Cells are hidden by it, too.
    for kind in volume surface; do
      open "$data/swirl.1.vtu" --size 1000x980 --color-by p --cells $kind --samples 2
      for group in Colour Selection; do click "group $group" 0.8; done
      [ $kind = surface ] || click 'group Volume' 0.8
      click 'group Plot' 0.8
      picture all.png
      click 'plot x'
      click U:magnitude
      gone U:magnitude
      drag plot 0.1 0.2 0.3 0.4
      has '--show=U(:magnitude)?=[-0-9.e]+:[-0-9.e]+ '
      has '--color-by=p '
      picture some.png
      differ all.png some.png
      quit
    done
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

  *)
    fail "no case $3"
    ;;
esac
