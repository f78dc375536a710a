#!/usr/bin/env bash
# sides.sh MOTE DATA CASE: data sets beside one another, in the window on the X server that DISPLAY names,
# and without one.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"
cp "$copper" a.dump.gz
cp "$copper" b.dump.gz
folded=--no-panel

# alike_halves FILE TOP BOTTOM: both views show the same, and something.
alike_halves() {
  read -r other drawn < <(python3 "$tests/halves.py" "$@")
  [ "$drawn" -gt 2000 ] || fail "$1: $drawn pixels are drawn"
  [ "$other" -lt 30 ] || fail "$1: $other of $drawn pixels differ between the views"
}

case $3 in
  render) # each view is the picture of its data alone, by one camera
    view='--camera 60,-150,90,56,16,5,0,0,1,30 --samples 1 --no-legend --color-by none'
    # shellcheck disable=SC2086
    {
      run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side $view -o both.png --size 400x300
      is_picture both.png 400x300
      run 0 "$mote" render a.dump.gz $view -o one.png --size 200x300 --caption ''
      for side in left right; do
        other=$(python3 "$tests/halves.py" both.png one.png $side 60)
        [ "$other" = 0 ] || fail "$other pixels of the $side view are not those of its data"
      done
      # Each has what it shows; what is hidden has no view.
      run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side $view -o other.png --size 400x300 --hide-ids 2/0:12000
      read -r other drawn < <(python3 "$tests/halves.py" other.png 60)
      [ "$other" -gt 500 ] || fail "half of the second data set hidden: $other pixels differ"
      run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side $view -o hidden.png --size 200x300 --hide-data 2 --caption ''
      said err 'does nothing here'
      cmp hidden.png one.png || fail "one data set that is shown alone has other pixels"
      run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side $view -o both.exr --size 400x300
    }
    # The legend has room of its own; sessions know.
    run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side -o legend.png --size 640x300 --samples 1 --save-session both.json
    grep -q '"side-by-side": true' both.json || fail "the session does not know"
    run 0 "$mote" render both.json -o again.png --samples 1
    alike legend.png again.png
    # Films, and blocks of one file.
    run 0 "$mote" animate a.dump.gz b.dump.gz --side-by-side --orbit 20 --frames 2 -o 'film-%02d.png' --size 320x200 --samples 1
    is_picture film-02.png 320x200
    cmp -s film-01.png film-02.png && fail "the film stands still"
    run 0 "$mote" render pump:0.001 --side-by-side -o pump.png --size 640x200 --samples 1
    is_picture pump.png 640x200
    # Four are two by two where that is nearest to squares, and in one row where the picture is wide.
    for i in c d; do cp "$copper" $i.dump.gz; done
    # shellcheck disable=SC2086
    {
      run 0 "$mote" render ?.dump.gz --side-by-side $view -o four.png --size 400x400
      run 0 "$mote" render a.dump.gz $view -o one.png --size 200x200 --caption ''
      other=$(python3 "$tests/halves.py" four.png one.png quarter 40)
      [ "$other" = 0 ] || fail "$other pixels of the last of four are not those of its data"
      run 0 "$mote" render ?.dump.gz --side-by-side $view -o four.png --size 1200x300
      run 0 "$mote" render a.dump.gz b.dump.gz --side-by-side $view -o two.png --size 600x300
      other=$(python3 "$tests/halves.py" four.png two.png right 60)
      [ "$other" = 0 ] || fail "$other pixels of the last two of four in a row are not those of their data"
    }
    ;;

  views) # share a camera that either turns, and come and go
    open a.dump.gz b.dump.gz --size 1000x600 --color-by none --side-by-side --samples 1
    picture both.png
    alike_halves both.png 60 40
    has '--side-by-side'
    xdotool mousemove 750 300 mousedown 1 mousemove 790 310 sleep 0.1 mousemove 820 330 mouseup 1
    has '--camera='
    picture turned.png
    differ both.png turned.png
    alike_halves turned.png 60 40
    xdotool mousemove 250 300 mousedown 1 mousemove 290 310 sleep 0.1 mousemove 320 330 mouseup 1
    picture again.png
    differ turned.png again.png
    alike_halves again.png 60 40
    eval "$(command_now | sed -e "s|^mote|$mote|" -e 's|-o [^ ]*|-o head.png|')" >said
    alike again.png head.png
    press v
    has_no '--side-by-side'
    picture one.png
    differ again.png one.png
    press v
    picture back.png
    alike again.png back.png
    press ctrl+z # takes that back
    has_no '--side-by-side'
    xdotool windowsize --sync "$window" 700 500
    press v
    picture small.png
    alike_halves small.png 60 40
    quit
    ;;

  picking) # works in each view, and so does what is told of the cursor
    open a.dump.gz b.dump.gz --size 1000x600 --color-by none --side-by-side --samples 1
    picked() { # X FILE: what is picked there
      xdotool mousemove "$1" 300 click 1
      marked=0
      for _ in $(seq 100); do
        marked=$(python3 "$tests/screen.py" $(($1 < 500 ? 0 : 500)) 0 500 560 marked)
        [ "$marked" -gt 10 ] && break
        sleep 0.1
      done
      [ "$marked" -gt 10 ] || fail "no mark in the view at $1"
      other=$(python3 "$tests/screen.py" $(($1 < 500 ? 500 : 0)) 0 500 560 marked)
      [ "$other" = 0 ] || fail "$other pixels are marked in the view beside $1"
      press ctrl+e
      for _ in $(seq 100); do
        ls -- *-picked.csv >/dev/null 2>&1 && break
        sleep 0.1
      done
      mv -- *-picked.csv "$2"
    }
    picked 250 left.csv
    picked 750 right.csv
    grep -q 'a.dump' left.csv || { cat left.csv; fail "the left view picks of another file"; }
    grep -q 'b.dump' right.csv || { cat right.csv; fail "the right view picks of another file"; }
    diff <(sed 's/a\.dump/b.dump/g' left.csv) right.csv || fail "the same place has another particle"
    # A rectangle in one view takes nothing of the other.
    press Escape
    xdotool mousemove 700 250 keydown Control_L mousedown 1 mousemove 750 280 sleep 0.1 mousemove 800 330 \
      mouseup 1 keyup Control_L
    press ctrl+e
    for _ in $(seq 100); do
      ls -- *-picked.csv >/dev/null 2>&1 && break
      sleep 0.1
    done
    mv -- *-picked.csv rectangle.csv
    [ "$(wc -l <rectangle.csv)" -gt 5 ] || fail "hardly anything is picked"
    grep -q 'a.dump' rectangle.csv && fail "a rectangle takes what is in the other view"
    quit
    ;;

  apart) # what lies elsewhere is in the middle of its view, too
    awk 'BEGIN { srand(3); print 300; print ""
      for (i = 0; i < 300; i++) print "Ar", 10 * rand(), 10 * rand(), 10 * rand() }' >a.xyz
    awk -v OFMT=%.9g 'NR < 3 { print } NR >= 3 { print $1, $2 + 1024, $3 - 256, $4 + 64 }' a.xyz >b.xyz
    plain='--side-by-side --no-legend --color-by none --samples 1'
    # shellcheck disable=SC2086
    {
      run 0 "$mote" render a.xyz b.xyz $plain -o both.png --size 400x300
      alike_halves both.png 60 0
      open a.xyz b.xyz $plain --size 1000x600
    }
    picture both.png
    alike_halves both.png 60 40
    xdotool mousemove 750 300 mousedown 1 mousemove 790 310 sleep 0.1 mousemove 820 330 mouseup 1
    has '--camera='
    picture turned.png
    differ both.png turned.png
    alike_halves turned.png 60 40
    eval "$(command_now | sed -e "s|^mote|$mote|" -e 's|-o [^ ]*|-o head.png|')" >said
    alike turned.png head.png
    xdotool mousemove 740 290
    press f # what is there comes to the middle of both
    picture middle.png
    differ turned.png middle.png
    alike_halves middle.png 60 40
    press v # together they are far apart
    picture one.png
    press v
    picture back.png
    alike middle.png back.png
    quit
    ;;

  panel) # has a box for it where there are two data sets
    folded=
    open a.dump.gz b.dump.gz --size 1300x700 --color-by none --samples 1
    shown side-by-side
    before=$(python3 "$tests/screen.py" 330 0 900 640)
    click side-by-side 0.05
    has '--side-by-side'
    [ "$(python3 "$tests/screen.py" 330 0 900 640)" != "$before" ] || fail "the view stays as it was"
    picture two.png
    alike_halves two.png 60 40
    click 'data 2' 0.5
    has '--hide-data=2'
    picture one.png
    differ one.png two.png
    click 'data 2' 0.5
    has_no '--hide-data'
    picture again.png
    alike again.png two.png
    quit
    open a.dump.gz --size 1000x700
    shown 'group Data'
    [ -z "$(place side-by-side)" ] || fail "one data set is offered to be set side by side"
    quit
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
