#!/usr/bin/env bash
# time.sh MOTE DATA CASE: one test of time in the window, on the X server that DISPLAY names: steps
# that are read ahead, the panel's section of time.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# at STEP: the window shows this step, counted from 1.
at() { has "--step[= ]$1( |\$)"; }

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

  *) fail "unknown case $3" ;;
esac
echo "$3: passed"
