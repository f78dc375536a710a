#!/usr/bin/env bash
# slices.sh MOTE DATA CASE: one test of volumes that are sliced, of their walls and edges; the case
# `window` on the X server that DISPLAY names, the others without one.
tests=$(realpath "$(dirname "$0")")
pump=pump:0.02:rotor

# shot OPTIONS...: a small picture of the rotor, in picture.png.
shot() {
  run 0 "$mote" render $pump -o picture.png --size 200x160 --no-legend --caption "" "$@"
  [ ! -s err ] || { cat err; fail "something on standard error"; }
}
other() { cmp -s "$1" "$2" && fail "$1 and $2 look alike"; return 0; }

case $3 in
  pictures) # places, directions, cylinders; walls and edges; sessions
    source "$tests/common.sh"
    unset DISPLAY
    view=(--cloud off --camera 0.3,0.3,0.4,0,0,0.02,0,0,1,30)
    shot "${view[@]}" --slice z=0.03
    mv picture.png plane.png
    shot "${view[@]}" --slice 0,0,5=0.03
    alike plane.png picture.png
    shot "${view[@]}" --slice h=0.01 --cut-axis 0,0,0.02,0,0,3
    alike plane.png picture.png
    shot "${view[@]}" --slice z=0.03,0.03
    alike plane.png picture.png
    shot "${view[@]}" --slice z=0.02
    other plane.png picture.png
    shot "${view[@]}" --slice r=0.07
    mv picture.png round.png
    shot "${view[@]}" --slice r=0.07 --unroll
    other round.png picture.png
    shot "${view[@]}" --slice angle=30
    mv picture.png angle.png
    shot "${view[@]}" --slice angle=390
    alike angle.png picture.png
    for more in "--edges 1" "--walls 0.3" "--cut x=0:" "--show pressure=0:" "--walls 1 --wall-color data"; do
      shot "${view[@]}" --slice z=0.03 $more
      other plane.png picture.png
    done
    shot "${view[@]}" --slice none --walls 1 --wall-color data --color-by velocity
    mv picture.png walls.png
    shot --cells surface --color-by velocity "${view[@]:2}"
    alike walls.png picture.png
    # Of a sector the wheel: what each copy shows is what the whole shows there.
    for what in "--slice z=0.03" "--slice r=0.07 --unroll" "--walls 1" "--iso 20000"; do
      shot "${view[@]}" $what --repeat-around 4
      mv picture.png four.png
      shot "${view[@]}" $what
      other four.png picture.png
    done
    # Cells that are left are seen from outside, unless something else is asked for.
    for what in "--where z>0.03" "--color-by velocity --show pressure=0:"; do
      shot "${view[@]:2}" $what
      mv picture.png cells.png
      shot "${view[@]:2}" $what --slice none --walls 1 --wall-color data
      alike cells.png picture.png
      shot "${view[@]:2}" $what --walls 1
      other cells.png picture.png
    done
    # A session keeps it all.
    shot "${view[@]}" --slice z=0.03 --slice r=0.05,0.1 --walls 0.4 --edges 1.5 --save-session s.json
    mv picture.png all.png
    run 0 "$mote" render s.json -o picture.png
    alike all.png picture.png
    # What is rolled out is framed, whichever half turn it is.
    shot --cloud off --slice r=0.07 --unroll --view +x
    mv picture.png flat.png
    shot --cloud off --slice r=9 --view +x
    other flat.png picture.png
    ;;

  errors)
    source "$tests/common.sh"
    unset DISPLAY
    for wrong in q=1 x=0:1 x 0,0,0=1 r=0 r=-1 x=a; do
      run 2 "$mote" render $pump -o a.png --slice "$wrong"
      one_sentence
      said err '--slice'
    done
    run 2 "$mote" render $pump -o a.png --slice x=0 --slice x=1
    said err 'given twice'
    run 2 "$mote" render $pump -o a.png --walls 2
    said err '--walls'
    run 2 "$mote" render $pump -o a.png --wall-color blurple
    said err '--wall-color'
    run 0 "$mote" render $pump -o a.png --size 80x60 --cloud off --slice none --walls 0
    said err '--slice'
    run 0 "$mote" render sphere:100 -o a.png --size 80x60 --slice x=0
    said err 'do nothing here'
    ;;

  window) # slices are added, dragged and taken away; walls and edges; undone; picked
    source "$tests/panel_common.sh"
    open $pump --size 1000x760 --color-by pressure --cloud on
    click 'group Data'
    click 'group Colour'
    click 'group Selection'
    picture cloud.png
    click 'group Slices'
    click slice
    click z
    has '--cloud=off'
    has '--slice=z=0.02[0-9]* '
    picture plane.png
    differ cloud.png plane.png
    drag 'slice z 0' 0.5 0.6 0.7
    has '--slice=z=0.03[0-9]* '
    picture moved.png
    differ plane.png moved.png
    click slice
    click 'r, distance from the axis'
    has '--slice=r=0\.[0-9]*'
    click slice
    click z
    has '--slice=z=0\.[0-9]*,0\.[0-9]*'
    click 'no slice r 0'
    has_no 'slice=r'
    picture two.png
    differ moved.png two.png
    for _ in $(seq 5); do press ctrl+z; done
    has_no '--slice'
    has_no '--cloud=off'
    picture again.png
    alike cloud.png again.png
    quit
    ;;

  grips) # slices and faces of cuts are dragged in the view
    source "$tests/panel_common.sh"
    grip() { # grip X Y DX DY: takes hold of what is at a place of the window, and drags it
      xdotool mousemove "$1" "$2" sleep 0.1 keydown alt mousedown 1
      for part in 1 2 3 4; do
        xdotool mousemove $(($1 + $3 * part / 4)) $(($2 + $4 * part / 4)) sleep 0.1
      done
      xdotool mouseup 1 keyup alt
    }
    open $pump --size 1000x760 --color-by pressure
    has '--slice=z=0.03[0-9]* '
    picture before.png
    grip 610 370 0 -20
    has '--slice=z=0.04[0-9]* '
    picture higher.png
    differ before.png higher.png
    press ctrl+z # all of it
    has '--slice=z=0.03[0-9]* '
    picture again.png
    alike before.png again.png
    grip 720 700 0 -30 # beside it all
    has '--slice=z=0.03[0-9]* '
    quit
    open $pump --size 1000x760 --color-by pressure --cut z=:0.02
    grip 640 375 0 15
    has '--cut=z=:0.0(0[6-9]|1)[0-9]* '
    quit
    ;;

  handles) # marks of slices and cuts come with their lists or by a key, and are dragged
    source "$tests/panel_common.sh"
    mark() { python3 "$tests/screen.py" 340 60 640 640 handles; }
    no_mark() { [ -z "$(mark)" ] || fail "a handle: $1"; }
    pull() { # pull DX DY: drags the first mark
      local at
      at=($(mark))
      [ "${#at[@]}" = 2 ] || fail 'there is no handle'
      xdotool mousemove "${at[@]}" sleep 0.1 mousedown 1
      for part in 1 2 3 4; do
        xdotool mousemove $((at[0] + $1 * part / 4)) $((at[1] + $2 * part / 4)) sleep 0.1
      done
      xdotool mouseup 1
    }
    open $pump --size 1000x760 --color-by pressure
    has '--slice=z=0.03[0-9]* '
    no_mark 'before the list is open'
    for group in Data Colour Selection; do click "group $group"; done
    click 'group Slices'
    sleep 0.5
    pull 0 -40
    has '--slice=z=0.0[4-6][0-9]* '
    press ctrl+z
    has '--slice=z=0.03[0-9]* '
    click 'group Slices'
    sleep 0.5
    no_mark 'after the list was closed'
    press n
    sleep 0.5
    has '--handles=on'
    pull 0 -40
    has '--slice=z=0.0[4-6][0-9]* '
    quit
    ;;

  turning) # a part that has turned is what is seen from elsewhere; slices stay
    source "$tests/common.sh"
    unset DISPLAY
    swirl=("$2/swirl.0.vtu" "$2/swirl.1.vtu")
    seen() { # seen FILE OPTIONS...
      run 0 "$mote" render "${swirl[@]}" -o "$1" --size 200x160 --no-legend --caption '' --light 0,30 "${@:2}"
    }
    near() { # near FILE FILE: all but a few pixels in a hundred are the same
      local wrong
      wrong=$(python3 "$tests/compare_png.py" "$1" "$2" | cut -d' ' -f1)
      [ "${wrong%.*}" -lt 150 ] || fail "$1 and $2 differ in $wrong of 10,000 pixels"
    }
    turned=(--camera 0.1,0.05,0.2,0,0,0.03,0,0,1,30) unturned=(--camera 0.05,-0.1,0.2,0,0,0.03,0,0,1,30)
    # A quarter of a turn, as the second step is at 8 s.
    for look in "--slice z=0.03" "--walls 1 --slice none" "--cloud on" "--cells surface" "--streamlines 40" "--arrows 60"; do
      # shellcheck disable=SC2086
      seen turned.png "${turned[@]}" $look --turn '*=1.875' --step 2
      # shellcheck disable=SC2086
      seen same.png "${unturned[@]}" $look --step 2
      near turned.png same.png
    done
    # A slice stays in the world, and so does a cut; a component is along the world's axis.
    seen turned.png "${turned[@]}" --slice x=0.003 --color-by U:0 --range -1 1 --turn '*=1.875' --step 2
    seen same.png "${unturned[@]}" --slice y=-0.003 --color-by U:1 --range -1 1 --reverse --step 2 # -U:1
    near turned.png same.png
    seen other.png "${unturned[@]}" --slice y=-0.003 --color-by U:0 --range -1 1 --step 2
    ! cmp -s turned.png other.png || fail 'vectors do not turn'
    seen turned.png "${turned[@]}" --slice x=0.003 --cut x=0.003: --color-by p --turn '*=1.875' --step 2
    seen same.png "${unturned[@]}" --slice y=-0.003 --cut y=:-0.003 --color-by p --step 2
    near turned.png same.png
    # Without any turns it is as it was.
    seen first.png "${turned[@]}" --step 1 --slice z=0.03
    seen same.png "${turned[@]}" --step 1 --slice z=0.03 --turn '*=0'
    alike first.png same.png
    run 0 "$mote" render "$2/swirl.1.vtu" -o a.png --size 80x60 --turn 'rotor=1.875'
    said err "no part 'rotor'"
    run 1 "$mote" render pump:0.001 -o a.png --size 80x60 --turn rotor=1000
    one_sentence
    said err 'turns by itself'
    run 2 "$mote" render "$2/swirl.1.vtu" -o a.png --turn rotor=1:2
    said err '--turn'
    ;;

  first) # the first view: walls that are looked into, and a slice, which the window shows, too
    source "$tests/panel_common.sh"
    run 0 "$mote" render $pump -o first.png --size 200x160 --samples 1 --caption '' --save-session s.json
    slice=$(python3 -c 'import json; print(json.load(open("s.json"))["slices"]["slice"][0])')
    [[ $slice =~ ^z=0\.03[0-9]{1,3}$ ]] || fail "the slice lies at $slice, not in the rotor"
    look=(render $pump --size 200x160 --samples 1 --caption '')
    run 0 "$mote" "${look[@]}" -o same.png --cloud off --slice "$slice" --walls 1 --near-walls 0
    cmp first.png same.png || fail 'the first view is not what its options say'
    for other in "--cloud on" "--slice none" "--walls 0" "--near-walls 1" "--iso 20000" "--cut x=0:"; do
      # shellcheck disable=SC2086
      run 0 "$mote" "${look[@]}" -o other.png $other
      differ first.png other.png
    done
    # What is cut open shows its cells there.
    run 0 "$mote" "${look[@]}" -o faces.png --cut x=0: --slice x=0
    cmp other.png faces.png || fail 'a cut is not closed by the cells that it goes through'
    open $pump --size 1000x760 --color-by pressure
    has "--slice=$slice "
    picture walls.png
    press w
    has '--cloud=on'
    has_no '--slice'
    picture cloud.png
    differ walls.png cloud.png
    press w
    picture again.png
    alike walls.png again.png
    quit
    ;;

  *) exit 2 ;;
esac
