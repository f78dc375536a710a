#!/usr/bin/env bash
# cuts.sh MOTE DATA CASE: one test of what is cut open; the case `window` on the X server that
# DISPLAY names, the others without one.
tests=$(realpath "$(dirname "$0")")
hopper=$2/hopper.dump.gz

# shot OPTIONS...: a small picture of the hopper from the front, in picture.png.
shot() {
  run 0 "$mote" render "$hopper" -o picture.png --size 200x160 --view -y --no-legend "$@"
  [ ! -s err ] || { cat err; fail "something on standard error"; }
}

case $3 in
  pictures) # sides, ends, directions and pieces about an axis
    source "$tests/common.sh"
    unset DISPLAY
    shot
    mv picture.png whole.png
    shot --cut x=-100:100
    alike whole.png picture.png
    shot --cut y=0:
    cmp -s whole.png picture.png && fail "a cut changes nothing"
    mv picture.png half.png
    said out '5,518 particles;' # all of them are there
    shot --cut 0,3,0=0:
    alike half.png picture.png
    shot --cut y=0: --cut 0,-1,0=:0
    alike half.png picture.png
    shot --cut angle=0:180
    alike half.png picture.png
    shot --cut angle=:180
    alike half.png picture.png
    shot --cut angle=-90:90 --cut-axis 5,0,-1,0,0,7 --cut r=0:1000
    cmp -s half.png picture.png && fail "the axis is not where it was put"
    shot --cut h=-1: --cut-axis 0,1,0,0,1,0
    alike half.png picture.png
    # Cells and triangles, each with what it has.
    for input in pump:0.02:rotor "$2/swirl.1.vtu" sphere:5000; do
      run 0 "$mote" render "$input" -o all.png --size 160x120
      run 0 "$mote" render "$input" -o some.png --size 160x120 --cut z=:0 --cut angle=20:300
      cmp -s all.png some.png && fail "$input is not cut"
    done
    run 0 "$mote" render pump:0.02:rotor -o all.png --size 160x120 --iso 50000 --cloud off
    run 0 "$mote" render pump:0.02:rotor -o some.png --size 160x120 --iso 50000 --cloud off --cut r=0.1:
    ! cmp -s all.png some.png || fail "isosurfaces are not cut"
    ;;

  errors)
    source "$tests/common.sh"
    unset DISPLAY
    for wrong in q=0:1 x=1,2 x=2:1 x 0,0,0=1:2 1,2=0:1 r=a:b; do
      run 2 "$mote" render "$hopper" -o a.png --cut "$wrong"
      one_sentence
      said err '--cut'
    done
    run 2 "$mote" render "$hopper" -o a.png --cut x=0: --cut x=:1
    said err 'given twice'
    for wrong in 1,2 0,0,0 1,2,3,0,0,0; do
      run 2 "$mote" render "$hopper" -o a.png --cut r=0:1 --cut-axis "$wrong"
      one_sentence
      said err '--cut-axis'
    done
    ;;

  window) # cuts are added, dragged, turned and taken away, at once, and undone
    source "$tests/panel_common.sh"
    open "$hopper" --size 1000x760 --view -y
    click 'group Selection' # folded: room for what follows
    click 'group Cuts'
    picture whole.png
    click cut
    click y
    has '--cut=y=[-0-9.e]+: ' # from -y: the face is towards the eye
    click 'other side y'
    has '--cut=y=:[-0-9.e]+ '
    picture half.png
    differ whole.png half.png
    drag 'cut y' 0.5 0.45 0.4 0.3
    has '--cut=y=:-[0-9.]+ '
    picture less.png
    differ half.png less.png
    click 'other side y'
    has '--cut=y=-[0-9.]+: '
    picture other.png
    differ less.png other.png
    write 'fields low' 0
    has '--cut=y=0: '
    click cut
    click 'the direction of the view'
    has '--cut=[-0-9.]+,[-0-9.]+,[-0-9.]+=:'
    [ -z "$(place cut-axis)" ] || fail "an axis of no use is offered"
    click cut
    click 'angle about the axis'
    has '--cut=angle=90:360'
    shown cut-axis
    picture quarter.png
    click 'other side angle'
    has '--cut=angle=:90'
    picture three.png
    differ quarter.png three.png
    click 'no cut angle'
    picture none.png
    differ three.png none.png
    has_no angle=
    press ctrl+z
    has angle=
    for _ in $(seq 10); do press ctrl+z; done
    has_no '--cut'
    picture again.png
    alike whole.png again.png
    quit
    ;;

  *) exit 2 ;;
esac
