#!/usr/bin/env bash
# window.sh MOTE DATA CASE: one test of the window, on the X server that DISPLAY names. What the
# window shows is judged by the pictures that it saves itself: the key s writes NAME-001.png, ...
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/window_common.sh"

# tetrahedron: writes one of triangles.
tetrahedron() {
  cat >tetrahedron.ply <<'PLY'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
PLY
}

case $3 in
  keys)
    open "$copper" --size 640x480
    picture start.png
    is_picture start.png 640x480
    picture again.png
    alike start.png again.png
    press h # texts over the view stay out of pictures
    press question
    picture help.png
    alike start.png help.png
    before=start
    for key in c m bracketright x o l b a e g; do
      press "$key"
      picture "$key.png"
      case $key in
        b | a) alike "$before.png" "$key.png" ;; # box and axes are the window's alone
        *) differ "$before.png" "$key.png" ;;
      esac
      before=$key
    done
    press p Escape h h plus minus Y Z
    quit
    ;;

  undo) # settings and views, back and forth
    open "$copper" --size 320x240
    picture start.png
    press c
    picture c.png
    press Y
    picture Y.png
    press bracketright
    picture larger.png
    differ Y.png larger.png
    for earlier in Y c start; do
      press ctrl+z
      picture undone.png
      alike "$earlier.png" undone.png
    done
    press ctrl+z # there is nothing more
    for later in c Y larger; do
      press ctrl+y
      picture redone.png
      alike "$later.png" redone.png
    done
    quit
    # A view that chose itself is gone back to as it was, at another time step too.
    open "$data/hopper.dump.gz" --size 320x240 --samples 2
    press Home
    picture first.png
    press x
    picture side.png
    differ first.png side.png
    press ctrl+z
    picture undone.png
    alike first.png undone.png
    press ctrl+y ctrl+z
    picture undone.png
    alike first.png undone.png
    quit
    # Arrays come round under --log, and a range is that of its array.
    open "$copper" --size 320x240 --samples 2 --color-by c_centro --range 1 20 --log
    picture asked.png
    for _ in 1 2 3 4; do
      press c
      picture other.png
      cmp -s asked.png other.png && break
      differ asked.png other.png
    done
    alike asked.png other.png
    quit
    ;;

  sessions) # a view is a session, a command and a script, which all make the same picture
    views=0
    # viewed KEYS -- ARGUMENTS...: opens, presses the keys, and compares.
    viewed() {
      local keys=()
      while [ "$1" != -- ]; do
        keys+=("$1")
        shift
      done
      shift
      open "$@" --size 320x240 --samples 4
      [ ${#keys[@]} = 0 ] || press "${keys[@]}"
      picture window.png
      press k
      press K
      press ctrl+s
      for _ in $(seq 100); do
        session=$(ls -- *-001.json 2>/dev/null | head -1)
        [ -n "$session" ] && break
        sleep 0.1
      done
      quit
      local line
      line=$(grep '^mote render' out) || { cat out; fail "no command"; }
      eval "\"$mote\" ${line#mote }" >said 2>&1 || { cat said; fail "$line"; }
      mv -- *-001.png command.png
      alike window.png command.png
      "$mote" render "$session" -o session.png >said 2>&1 || { cat said; fail "$session"; }
      alike window.png session.png
      if [ -n "$MOTE_PYTHON" ]; then
        sed -n '/^# Draws the view/,$p' out >script.py
        "$MOTE_PYTHON" script.py >said 2>&1 || { cat said script.py; fail "the script"; }
        mv -- *-001.png script.png
        alike window.png script.png
      fi
      rm -- *-001.json
      views=$((views + 1))
    }
    viewed -- "$copper"
    viewed c d plus Y -- "$copper" --show c_centro=3:20
    viewed o bracketright m e -- "$data/hopper.dump.gz" --color-by type --cut x=:2 --cut angle=30:350
    viewed d d t -- "$data/hopper.dump.gz" --light -30,40 --title 'it'"'"'s speed'
    viewed c -- "$data/hopper.dump.gz" --calculate 'speed=v.magnitude' --calculate 'fast=speed > 1' \
      --where 'type == 2 || fast' --color-by speed
    viewed t t -- "$data/lj-fracture.dump.gz" --background white,navy
    viewed t t t -- "$data/hopper.dump.gz" --show type=2 --show radius=0.8:
    viewed z -- "$data/swirl.1.vtu" --color-by U --cut 1,1,0=0:
    viewed -- "$data/swirl.1.vtu" --cloud off --slice z=0.02,0.05 --slice r=0.004 --walls 0.4 --edges 1 --repeat-around 3 --cut-axis 0.02,0,0,0,0,1 \
      --show U=0.01: --color-by U
    viewed -- "$data/swirl.1.vtu" --streamlines 20 --arrows 60 --color-by U --cut z=0:
    viewed m -- "$data/swirl.1.vtu" --iso 0.02 --cloud off --color-by U
    viewed Left -- "$data/lj-fracture.dump.gz" --legend-side left --font-scale 1.5
    viewed g -- pump:0.001 --opacity 0%=0,100%=0.4 --lit
    # Pictures of another size have lines of the same share, 1.5 of 240 rows.
    viewed -- "$data/hopper.dump.gz" --silhouettes=4 --picture-size 480x360
    [ "$(png_size window.png)" = 480x360 ] || fail "the picture is $(png_size window.png)"
    grep -q 'silhouette-thickness=2.25 ' out || fail "lines do not grow with the picture"
    tetrahedron
    viewed l -- tetrahedron.ply --color-by z --cut 1,1,1=:0.5
    viewed m -- "$data/swirl.1.vtu" --cells surface --color-by U
    # Cells that limits hide, and data sets side by side.
    viewed m -- "$data/swirl.1.vtu" --color-by p --show x=:0.005 --show U=0.01: --hide-ids 5:400
    viewed -- "$data/swirl.1.vtu" --cells surface --color-by U --show x=:0.005 --where 'U.magnitude > 0.01'
    viewed -- tetrahedron.ply --color-by z --hide-ids 2
    two_lines lines.vtk
    viewed -- lines.vtk --color-by speed --radius width --hide-ids 1
    viewed -- lines.vtk --color-by line --lines particles
    viewed -- "$data/swirl.1.vtu" "$copper" tetrahedron.ply --side-by-side --color-by z
    viewed -- "$copper" --percentiles 2 98
    printf '2\n\nAr 0 0 0\nNe 3 2 1\n' >near.xyz
    printf '2\n\nAr 100 0 0\nNe 103 2 1\n' >far.xyz
    viewed -- near.xyz far.xyz --side-by-side --color-by z
    [ $views = 24 ] || fail "$views views"
    ;;

  mouse)
    open "$copper" --size 640x480
    picture start.png
    xdotool mousemove 300 240 mousedown 1
    for x in $(seq 300 10 400); do
      xdotool mousemove "$x" 240
    done
    xdotool mouseup 1
    picture turned.png
    differ start.png turned.png
    xdotool click 4 click 4
    picture nearer.png
    differ turned.png nearer.png
    press r
    picture reset.png
    alike start.png reset.png
    xdotool mousemove 320 240
    # The mark on the particle is in pictures too, its values are on the screen alone.
    eval "$(xdotool getwindowgeometry --shell "$window" | sed -n 's/^\([XY]\)=/window_&/p')"
    shown() { python3 "$tests/screen.py" "$window_X" "$window_Y" 640 400; }
    changed() {
      for _ in $(seq 100); do
        [ "$(shown)" != "$1" ] && return
        sleep 0.1
      done
      fail "nothing changes on the screen $2"
    }
    press Escape
    at_rest 0 0 640 440 >/dev/null
    plain=$(shown)
    press p
    changed "$plain" "where a particle is picked"
    picked=$(shown)
    picture marked.png
    differ start.png marked.png
    press Escape
    changed "$picked" "after Escape"
    picture unmarked.png
    alike start.png unmarked.png
    quit
    ;;

  resize)
    open "$copper" --size 640x480
    xdotool getwindowname "$window" | grep -q 'Mote - copper-scratch' || fail "title"
    picture start.png
    xdotool windowsize --sync "$window" 500 600
    sized tall.png 500x600
    is_picture tall.png 500x600
    xdotool windowsize --sync "$window" 120 90 # too small for the texts
    sized tiny.png 120x90
    xdotool windowsize --sync "$window" 640 480
    sized back.png 640x480
    alike start.png back.png
    quit
    ;;

  steps)
    # Without --range the colours' range would grow with the steps seen.
    open "$copper" --size 640x480 --range 0 20
    picture last.png
    press Left
    picture before.png
    differ last.png before.png
    press Home
    press Left # there is none before
    picture first.png
    press End
    picture end.png
    alike last.png end.png
    press space # plays
    sleep 2
    press space # pauses
    press End   # with the camera and the colours of before
    picture after.png
    alike last.png after.png
    press space
    sleep 1
    picture during.png # which pauses, too
    press End
    picture again.png
    alike last.png again.png
    quit
    ;;

  light) # d goes from no shadows to hard to soft and back
    open "$copper" --size 640x480 --show z=0: --range 0 20
    picture none.png
    press d
    picture hard.png
    differ none.png hard.png
    press d
    picture soft.png
    differ hard.png soft.png
    press d
    picture none-again.png
    alike none.png none-again.png
    press d d
    xdotool mousemove 300 240 mousedown 1
    for x in $(seq 300 20 400); do
      xdotool mousemove "$x" 240
    done
    xdotool mouseup 1
    picture turned.png
    differ soft.png turned.png
    press r
    picture back.png # soft again, with all its samples
    alike soft.png back.png
    press space # time goes on under soft shadows
    sleep 2
    press space
    press End
    picture end.png
    alike soft.png end.png
    quit
    ;;

  shading) # t goes from plain light to ambient occlusion, live and baked, to paths and back; all end at the noise
    open "$copper" --size 320x240 --range 0 20 --noise 0.02
    picture plain.png
    press t
    picture occlusion.png
    differ plain.png occlusion.png
    press t
    picture baked.png
    differ plain.png baked.png
    press t
    picture paths.png
    differ baked.png paths.png
    xdotool mousemove 160 120 mousedown 1
    for x in $(seq 160 20 240); do
      xdotool mousemove "$x" 120
    done
    xdotool mouseup 1
    picture turned.png
    differ paths.png turned.png
    press r
    picture back.png
    alike paths.png back.png
    press t
    picture plain-again.png
    alike plain.png plain-again.png
    quit
    ;;

  preview) # many particles begin with a preview; what is saved is the exact picture
    many_particles many.vtp
    open many.vtp --size 320x240 --no-preview
    xdotool getwindowname "$window" | grep -qF '(preview)' && fail "a preview against --no-preview"
    picture exact.png
    quit
    open many.vtp --size 320x240
    titled '(preview)'
    picture saved.png
    alike exact.png saved.png
    untitled '(preview)'
    for key in bracketright bracketleft; do # other radii are built anew, in the same view
      press $key
      titled '(preview)'
      press p plus minus # usable meanwhile
      untitled '(preview)'
    done
    press Escape
    xdotool mousemove 300 200
    picture again.png
    press r
    picture reset.png
    alike exact.png reset.png
    press bracketright bracketright bracketright
    titled '(preview)'
    quit # amid the build
    open many.vtp --size 320x240
    titled '(preview)'
    kill -INT $process
    wait $process
    [ $? = 130 ] || fail "not interrupted"
    ;;

  volume) # volumes alone are traced as particles are: samples, silhouettes, light
    shown=("$data/swirl.1.vtu" --size 320x240 --iso 0.02 --cloud off --color-by U)
    open "${shown[@]}" --samples 1
    picture one.png
    quit
    saved=0
    open "${shown[@]}" --samples 6
    picture six.png
    differ one.png six.png
    press e
    picture lines.png
    differ six.png lines.png
    press e
    picture no-lines.png
    alike six.png no-lines.png
    press t
    picture occlusion.png
    differ six.png occlusion.png
    press m
    picture map.png
    differ occlusion.png map.png
    press x y z r # each interrupts what sharpens
    picture reset.png
    alike map.png reset.png
    quit
    open "$data/swirl.1.vtu" --size 320x240 --samples 4 --cloud-tolerance 0
    picture cloud.png
    press c
    picture next.png
    differ cloud.png next.png
    quit
    ;;

  slow) # what takes minutes to trace is seen at once, coarsely, with its legend; and so is every change
    legend() { python3 "$tests/screen.py" 850 120 140 460; }
    view() { python3 "$tests/screen.py" 300 120 400 460; }
    open "$data/swirl.1.vtu" --size 1000x700 --color-by U --cloud on --sample-distance 3e-6 --samples 1
    for _ in $(seq 50); do
      [ "$(legend | cut -d ' ' -f 2)" -gt 300 ] && break
      sleep 0.2
    done
    [ "$(legend | cut -d ' ' -f 2)" -gt 300 ] || fail "no legend"
    [ "$(view | cut -d ' ' -f 2)" -gt 1000 ] || fail "the legend came before the picture"
    for _ in 1 2 3; do
      before=$(legend)
      press m
      for _ in $(seq 50); do
        [ "$(legend)" != "$before" ] && break
        sleep 0.2
      done
      [ "$(legend)" != "$before" ] || fail "a key shows nothing"
    done
    quit
    ;;

  mesh) # cells are shown by their surface
    tetrahedron
    open tetrahedron.ply --size 640x480
    picture mesh.png
    [ "$(png_size mesh.png)" = 640x480 ] || fail "no picture of a mesh"
    press y
    picture turned.png
    differ mesh.png turned.png
    quit
    ;;

  errors) # files are looked at before a window opens; what fails later ends it
    run 1 "$mote" missing.dump
    one_sentence
    head -c 20000 "$copper" >cut.dump.gz
    run 1 "$mote" cut.dump.gz
    one_sentence
    run 1 "$mote" "$copper" --color-by nothing
    one_sentence
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
