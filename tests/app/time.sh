#!/usr/bin/env bash
# time.sh MOTE DATA CASE: one test of time in the window, on the X server that DISPLAY names: steps
# that are read ahead, the panel's section of time.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  ahead) # steps that are in memory need their file no more, and look as they do when they are read
    cp "$copper" run.dump.gz
    open run.dump.gz --size 900x700 --range 0 20 --cache 0
    for step in 1 2 3 4; do
      [ $step = 1 ] && press Home || press Right
      picture read-$step.png
    done
    [ -z "$(place 'cache 1/7')" ] || fail 'a bar of what is read ahead, of which there is none'
    quit
    rm -f ./*-0*.png
    open run.dump.gz --size 900x700 --range 0 20
    shown 'cache 7/7'
    mv run.dump.gz away
    for step in 1 2 3 4; do
      [ $step = 1 ] && press Home || press Right
      picture ahead-$step.png
      alike read-$step.png ahead-$step.png
    done
    press Left
    picture back.png
    alike read-3.png back.png
    # Other radii are built of what is in memory; of ranges nothing is left where they are gone.
    press bracketright
    press Home
    picture larger.png
    differ read-1.png larger.png
    press bracketleft
    xdotool key --window 0 ctrl+z
    mv away run.dump.gz
    quit
    # A step that is not in memory, and whose file is gone, is a sentence, and the picture stays.
    open run.dump.gz --size 900x700 --range 0 20 --cache 0
    picture last.png
    rm run.dump.gz
    press Home
    picture still.png
    alike last.png still.png
    quit
    ;;

  scrub) # the slider goes to every step, those that are not read yet too
    for size in 1k 1G; do
      open "$copper" --size 900x700 --range 0 20 --cache $size
      press Home
      drag step 0.05 0.3 0.6 0.9 0.5
      at 4
      picture scrubbed-$size.png
      click Undo
      at 1
      click '>'
      at 2
      click '>|'
      at 7
      click '|<'
      at 1
      press Right Right Right
      picture keys-$size.png
      alike scrubbed-$size.png keys-$size.png
      quit
    done
    alike keys-1k.png keys-1G.png
    ;;

  play) # to the end, or round and round, as fast as was asked for
    open "$copper" --size 900x700 --range 0 20 --no-loop --speed 50
    press Home
    at 1
    click Play
    shown Play
    at 7
    click Play # begins again
    shown Play
    at 7
    click loop 0.1
    drag speed 0.5 0.9
    click Play
    shown Pause
    before=0
    for _ in $(seq 100); do # until it has come past its end
      now=$(command_now | grep -oE -- '--step=[0-9]+' | grep -oE '[0-9]+')
      [ "$now" -lt $before ] && break
      before=$now
    done
    [ "$now" -lt $before ] || fail 'it does not begin again'
    click Pause
    shown Play
    quit
    ;;

  broken) # a step that cannot be read is told, and time stands still
    for i in 1 2 3; do
      run 0 "$mote" convert lattice:1000 run.$i.mote
    done
    open run.?.mote --size 900x700 --step 1 --cache 0
    truncate -s 5000 run.2.mote
    click Play
    shown Play
    at 1
    quit
    ;;

  closing) # while steps are read and built ahead
    many_particles many.0.vtp
    for i in 1 2 3 4; do
      ln -s many.0.vtp many.$i.vtp
    done
    for wait in 0 1 3; do
      open many.?.vtp --size 900x700 --step 1
      shown 'cache 1/5'
      sleep $wait
      press q
      for _ in $(seq 100); do
        kill -0 $process 2>/dev/null || break
        sleep 0.1
      done
      kill -0 $process 2>/dev/null && fail 'it goes on'
      wait $process
      [ $? = 0 ] || { cat err; fail 'another exit code than 0'; }
      : >"$MOTE_CONTROLS"
    done
    ;;

  follow) # a dump that grows, with a last step that is half written, is cut, goes and comes back
    zcat "$copper" >whole.dump
    # Where its steps begin, and how long it is.
    mapfile -t begins < <(grep -b 'ITEM: TIMESTEP' whole.dump | cut -d: -f1)
    grow() { head -c "$1" whole.dump >run.dump; }
    grow "${begins[3]}"
    open run.dump --size 900x700 --range 0 20 --follow
    at 3
    shown 'cache 3/3'
    tail -c +$((begins[3] + 1)) whole.dump | head -c $((begins[5] - begins[3] - 1000)) >>run.dump
    shown 'cache 4/4' # the fifth is half there
    at 4
    picture four.png
    tail -c +$((begins[5] - 1000 + 1)) whole.dump | head -c $((1000 + 40)) >>run.dump
    shown 'cache 5/5'
    at 5
    tail -c +$((begins[5] + 40 + 1)) whole.dump >>run.dump
    shown 'cache 7/7'
    at 7
    # Whoever looks at an earlier step goes on to.
    press Left
    at 6
    rm run.dump
    sleep 2
    press Home
    at 1
    grow "${begins[4]}"
    shown 'cache 4/4'
    press End
    at 4
    picture again.png
    alike four.png again.png
    grow "${begins[2]}"
    shown 'cache 2/2'
    at 2
    for _ in $(seq 30); do # whatever is there at a moment
      grow $((RANDOM * 100))
      sleep 0.05
    done
    cp whole.dump run.dump
    shown 'cache 7/7'
    press q
    wait $process
    [ $? = 0 ] || { cat err; fail 'it did not end well'; }
    ;;

  series) # files that come, when they are whole
    cp "$data/swirl.0.vtu" run.0000.vtu
    open run.0000.vtu --size 900x700 --color-by p --range -1 1 --follow
    picture first.png
    head -c 90000 "$data/swirl.1.vtu" >run.0001.vtu
    sleep 2
    [ -z "$(place step)" ] || fail 'half a file is a step'
    cp "$data/swirl.1.vtu" run.0001.vtu
    shown 'cache 2/2'
    at 2
    picture second.png
    differ first.png second.png
    cp "$data/swirl.0.vtu" other.0002.vtu # of another series
    cp "$data/swirl.0.vtu" run.0002.vtu
    shown 'cache 3/3'
    click Session
    click follow 0.1
    press Home
    at 1
    quit
    grep -q 'run.0002.vtu' run-*.json || fail 'the session lacks the file that came last'
    # The same of Mote's own files, one a step, converted from all steps of a dump, with maps.
    run 0 "$mote" convert "$copper" scratch.mote --all-steps
    [ "$(ls scratch.*.mote)" = "$(printf 'scratch.%04d.mote\n' 1 2 3 4 5 6 7)" ] || fail 'no seven files'
    open scratch.000[1-6].mote --size 900x700 --range 0 20 --follow
    at 7
    press Left Left
    at 5
    press x # the view was that of the sixth
    picture five.png
    quit
    open "$copper" --size 900x700 --range 0 20 --structure pkd-tree
    press Left Left
    at 5
    press x
    picture dump-five.png
    # Centres are rounded otherwise in the file.
    read -r wrong _ <<<"$(python3 "$tests/compare_png.py" five.png dump-five.png)"
    [ "${wrong%.*}" -lt 100 ] || fail "$wrong of 10,000 pixels of the file and of the dump differ"
    quit
    ;;

  cut) # a mapped file that is made shorter while it is drawn
    run 0 "$mote" convert "$copper" run.mote
    run 0 "$mote" convert lattice:2000000 large.mote
    open large.mote --size 900x700
    truncate -s 5000 large.mote
    press x y z bracketright
    for _ in $(seq 100); do
      grep -q 'cut short' err && break
      sleep 0.1
    done
    said err 'cut short'
    press q
    wait $process
    code=$?
    [ $code = 0 ] || { cat err; fail "exit code $code"; }
    ;;

  range) # of colours over all steps, in one step of undo
    for step in 0 1 2 3; do
      printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n' $step
      printf 'ITEM: ATOMS id type x y z heat\n1 1 4 4 4 %s\n2 1 6 4 4 %s\n' $((5 - step)) $((10 + step * step))
    done >hot.dump
    open hot.dump --size 900x900 --color-by heat --no-loop
    has_no '--range'
    picture own.png
    click 'Range of all steps'
    has '--range=2,19 '
    press Left Left
    at 2
    click 'Range of all steps'
    has '--range=2,19 '
    click Undo
    click Undo
    click Undo
    has_no '--range'
    picture again.png
    alike own.png again.png
    # Undone, the steps that were not shown count for nothing.
    press q
    wait $process
    open hot.dump --size 900x900 --color-by heat --no-loop --step 1
    picture own.png
    click 'Range of all steps'
    has '--range=2,19 '
    picture all.png
    differ own.png all.png
    click Undo
    has_no '--range'
    picture again.png
    alike own.png again.png
    # Steps that are in memory need no file.
    mv hot.dump away
    click 'Range of all steps'
    has '--range=2,19 '
    mv away hot.dump
    press q
    wait $process
    # Whose file is away for a while, and in memory neither, has what there was.
    open hot.dump --size 900x900 --color-by heat --no-loop --step 1 --cache 0
    mv hot.dump away
    click 'Range of all steps'
    has_no '--range'
    mv away hot.dump
    click 'Range of all steps'
    has '--range=2,19 '
    press q
    wait $process
    [ $? = 0 ] || { cat err; fail 'it did not end well'; }
    ;;

  odd) # steps without particles, and arrays that some steps have
    step() { # TIME COUNT COLUMNS VALUES
      printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n%s\nITEM: BOX BOUNDS pp pp pp\n' "$1" "$2"
      printf '0 9\n0 9\n0 9\nITEM: ATOMS id type x y z%s\n' "$3"
      for i in $(seq "$2"); do
        echo "$i 1 $i $((i % 3)) 1$4"
      done
    }
    { step 0 0 '' ''; step 1 8 '' ''; step 2 9 ' heat' ' 5'; step 3 0 ' heat' ' 5'; step 4 9 '' ''; } >odd.dump
    for size in 0 1G; do
      open odd.dump --size 900x700 --cache $size --step 3 --color-by heat --show heat=0:9
      picture three-$size.png
      for key in Left Left Right Right Right Right Home End space; do
        press $key
        [ $key = space ] && sleep 2
      done
      press space Home Right Right
      at 3
      picture again-$size.png
      alike three-$size.png again-$size.png
      press q
      wait $process
      [ $? = 0 ] || { cat err; fail 'it did not end well'; }
      grep -v 'has no array' err && fail 'another warning'
      said err "no array 'heat', so it is shown in one colour"
    done
    alike three-0.png three-1G.png
    ;;

  loading) # the window is closed while the file is read, and while it is built
    many_particles many.vtp
    for wait in 0 0.3 1 2; do
      "$mote" many.vtp --size 900x700 --no-preview >out 2>err &
      process=$!
      for _ in $(seq 150); do
        window=$(xdotool search --name '^Mote' 2>/dev/null | head -1)
        [ -n "$window" ] && break
        sleep 0.05
      done
      sleep $wait
      xdotool windowfocus "$window"
      xdotool key --window 0 q
      for _ in $(seq 100); do
        kill -0 $process 2>/dev/null || break
        sleep 0.1
        xdotool key --window 0 q 2>/dev/null # where the first came before the window could hear it
      done
      kill -0 $process 2>/dev/null && fail 'it goes on'
      wait $process
      [ $? = 0 ] || { cat err; fail 'it did not end well'; }
    done
    ;;

  resizing) # while the picture is refined, which begins anew and ends as it does without
    folded=--no-panel
    open "$copper" --size 640x480 --shadows soft --samples 64
    for size in '700 500' '400 300' '900 700' '640 480' '820 610'; do
      # shellcheck disable=SC2086
      xdotool windowsize "$window" $size
      sleep 0.15
    done
    xdotool windowsize --sync "$window" 720 540
    picture resized.png
    quit
    [ "$(png_size resized.png)" = 720x540 ] || fail "$(png_size resized.png)"
    rm -f ./*-001.png
    open "$copper" --size 720x540 --shadows soft --samples 64
    picture fresh.png
    alike resized.png fresh.png
    quit
    ;;

  *) fail "unknown case $3" ;;
esac
echo "$3: passed"
