#!/usr/bin/env bash
# animate.sh MOTE DATA CASE: one test of mote animate. None may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
small=(--size 160x120 --samples 1)

# frames_are N: there are so many pictures f-001.png, ...
frames_are() {
  [ "$(ls f-*.png | wc -l)" = "$1" ] || fail "$(ls f-*.png | wc -l) frames, not $1"
}
differ() { cmp -s "$1" "$2" && fail "$1 and $2 look alike"; return 0; }

# film_is FILE FACTS: what a film of Theora holds.
film_is() {
  python3 "$tests/film_facts.py" "$1" >facts || { cat facts; fail "$1 is no film"; }
  [ "$(cat facts)" = "$2" ] || fail "$1 is: $(cat facts)"
}

case $3 in
  moves) # orbits and time steps; a frame is the picture that mote render makes
    run 0 "$mote" render "$hopper" -o last.png "${small[@]}" --color-by type --save-session view.json
    run 0 "$mote" animate "$hopper" -o f-%03d.png "${small[@]}" --color-by type --orbit 360 --frames 4
    said out '4 frames'
    frames_are 4
    alike f-001.png last.png
    differ f-001.png f-002.png
    differ f-002.png f-004.png
    rm f-*.png
    run 0 "$mote" animate view.json -o f-%03d.png --steps 2:6:2 --frames-per-step 2
    frames_are 6
    for step in 2 4 6; do
      run 0 "$mote" render view.json -o step.png --step $step
      alike step.png "f-00$((step - 1)).png"
      alike step.png "f-00$step.png"
    done
    rm f-*.png
    # One range of colours throughout, that of all steps of the film.
    run 0 "$mote" animate "$hopper" -o f-%03d.png "${small[@]}" --color-by v
    frames_are 7
    run 0 "$mote" render "$hopper" -o r.png "${small[@]}" --color-by v --all-steps
    alike f-001.png r.0001.png
    alike f-007.png r.0007.png
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    ;;

  keys) # the film begins and ends at its key frames, and lies between them
    run 0 "$mote" render "$hopper" -o a.png "${small[@]}" --color-by type --show z=0: \
      --save-session a.json
    run 0 "$mote" render "$hopper" -o b.png "${small[@]}" --color-by type --show z=5: \
      --azimuth 70 --zoom 2 --background white --save-session b.json
    run 0 "$mote" animate a.json --key-frames b.json,a.json -o f-%03d.png --frames 5
    frames_are 5
    said out "all frames show one of 7 time steps; --steps all plays them"
    alike f-001.png a.png
    alike f-003.png b.png
    alike f-005.png a.png
    differ f-002.png a.png
    differ f-002.png b.png
    run 0 "$mote" render "$data/swirl.1.vtu" -o c.png "${small[@]}" --save-session c.json
    run 1 "$mote" animate a.json --key-frames c.json -o f.ogv
    one_sentence
    said err 'other data'
    run 0 "$mote" render a.json -o d.png --orthographic --save-session d.json
    run 1 "$mote" animate a.json --key-frames d.json -o f.ogv
    one_sentence
    ;;

  video) # Theora of any size; others by ffmpeg, where it is
    run 0 "$mote" animate "$hopper" -o film.ogv --size 161x99 --samples 1 --rate 12
    film_is film.ogv '161x99 28 frames 12 fps playable complete'
    run 0 "$mote" animate "$data/swirl.1.vtu" -o film.ogv --size 160x120 --samples 1 --orbit 36 \
      --quality low
    film_is film.ogv '160x120 25 frames 25 fps playable complete'
    mkdir there
    printf '#!/bin/sh\nfor file; do :; done\necho "$@" >words\ncat >"$file"\n' >there/ffmpeg
    chmod +x there/ffmpeg
    PATH=$PWD/there:$PATH run 0 "$mote" animate "$hopper" -o film.mp4 --size 50x40 --samples 1
    said words '-s 50x40 -r 25'
    [ "$(stat -c %s film.mp4)" = $((56 * 50 * 40 * 3)) ] || fail "$(stat -c %s film.mp4) bytes of frames"
    if command -v ffmpeg ffprobe >/dev/null; then # the real one
      run 0 "$mote" animate "$hopper" -o real.mp4 --size 64x48 --samples 1
      run 0 ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames -of csv=p=0 real.mp4
      said out 64,48,56
      rm real.mp4
    fi
    # Its failures are told, and leave what was there.
    printf '#!/bin/sh\nhead -c 10 >/dev/null\nexit 1\n' >there/ffmpeg
    PATH=$PWD/there:$PATH run 1 "$mote" animate "$hopper" -o film.mp4 --size 500x400 --samples 1
    one_sentence
    [ "$(stat -c %s film.mp4)" = $((56 * 50 * 40 * 3)) ] || fail "the former film is gone"
    rm film.mp4
    PATH= run 1 "$mote" animate "$hopper" -o film.mp4
    one_sentence
    said err '.ogv'
    run 1 "$mote" render "$hopper" -o film.mp4 --all-steps
    one_sentence
    said err 'mote animate FILE -o film.mp4'
    ls | grep -q part && fail "something is left: $(ls)"
    true
    ;;

  wrong) # is told before anything is read
    for name in film.xyz film.png nowhere/film.ogv f-%s.png f-%d-%d.png nowhere/f-%d.png; do
      run 1 "$mote" animate "$hopper" -o "$name" --orbit 90 "${small[@]}"
      one_sentence
    done
    run 1 "$mote" animate "$data/swirl.1.vtu" -o film.ogv
    said err '--orbit 360'
    run 1 "$mote" animate "$hopper" -o film.ogv --steps 3:9
    said err '7 time steps'
    for steps in 0:2 3:2 a 1:2:3:4 :; do
      run 2 "$mote" animate "$hopper" -o film.ogv --steps $steps
      one_sentence
    done
    run 2 "$mote" animate "$hopper" -o film.ogv --frames 0
    run 2 "$mote" animate "$hopper"
    [ "$(ls | grep -v -e err -e out)" = "" ] || fail "something is left: $(ls)"
    ;;

  stop) # Ctrl-C leaves a film that plays, of the frames that there are
    env --default-signal=INT "$mote" animate "$hopper" -o film.ogv --orbit 360 --frames 100000 \
      "${small[@]}" >out 2>err &
    process=$!
    for _ in $(seq 300); do
      [ -s film.part.ogv ] && break
      sleep 0.05
    done
    sleep 0.5
    kill -INT $process
    wait $process
    [ $? = 130 ] || { cat out err; fail "the exit code is not 130"; }
    said out 'of 100,000 frames'
    frames=$(sed -n 's/.*, \([0-9]*\) of 100,000 frames.*/\1/p' out)
    film_is film.ogv "160x120 $frames frames 25 fps playable complete"
    ls | grep -q part && fail "something is left: $(ls)"
    true
    ;;

  *)
    fail "no case $3"
    ;;
esac
