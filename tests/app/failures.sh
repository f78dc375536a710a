#!/usr/bin/env bash
# failures.sh MOTE DATA CASE: one test of what the command line says when something is wrong. None of
# them may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
copper=$data/copper-scratch.dump.gz

case $3 in
  errors) # one sentence, exit code 1, no picture
    failing() {
      run 1 "$mote" "$@"
      one_sentence
    }
    failing render missing.dump -o a.png
    said err missing.dump
    failing info "$data"
    failing render "$hopper" -o a.png --color-by nothing
    said err 'it has id'
    failing render "$hopper" -o a.png --color-by v:7
    failing render "$hopper" -o a.png --show-by nothing --show-range 0 1
    failing render "$hopper" -o a.png --show nothing=0:1
    said err 'radius as drawn, and id'
    failing render "$hopper" -o a.png --show v:7=0:1
    failing render "$hopper" -o a.png --show id=0: --show type=0: --show v:0=0: --show v:1=0: \
      --show v:2=0:
    said err 'at most four arrays'
    failing render "$hopper" -o a.png --radius nothing
    failing render "$hopper" -o a.png --radius -1
    failing render "$hopper" -o a.png --time -5
    said err 'begins at time 0'
    failing render "$hopper" -o a.png --log --range -1 1
    failing render "$hopper" -o a.png --structure coherent-grid --form 4-byte
    said err 'has no forms'
    failing render "$hopper" -o a.picture
    failing render "$hopper" -o nowhere/a.png
    failing render "$hopper" -o /dev/full
    echo "words, no particles" >words.unknown
    failing info words.unknown
    said err .dump
    ls a.* >/dev/null 2>&1 && fail "a picture in spite of an error"
    true
    ;;

  usage) # exit code 2
    misused() {
      run 2 "$mote" "$@"
      said err 'mote: '
      said err --help
    }
    misused
    misused render "$hopper"
    misused render -o a.png
    misused --no-such-option "$hopper"
    misused render "$hopper" -o a.png --range 2 1
    misused render "$hopper" -o a.png --range 1
    misused render "$hopper" -o a.png --range nan 1
    misused render "$hopper" -o a.png --all-steps --step 1
    misused render "$hopper" -o a.png --all-steps --time 1
    misused render "$hopper" -o a.png --show-range 2 1
    misused render "$hopper" -o a.png --show-by type
    misused render "$hopper" -o a.png --show id
    misused render "$hopper" -o a.png --show =1:2
    misused render "$hopper" -o a.png --show id=
    misused render "$hopper" -o a.png --show id=:
    misused render "$hopper" -o a.png --show id=one:2
    misused render "$hopper" -o a.png --show id=2:1
    said err 'LO must not be greater than HI'
    misused render "$hopper" -o a.png --show id=1:2 --show id=3:4
    said err 'given twice'
    misused render "$hopper" -o a.png --show a=1 --show b=1 --show c=1 --show d=1 --show e=1 \
      --show f=1 --show g=1 --show h=1 --show i=1
    said err 'at most eight'
    misused render "$hopper" -o a.png --structure octree
    said err pkd-paper
    misused render "$hopper" -o a.png --form 5-byte
    said err 8-byte
    misused convert "$hopper" a.mote --form small
    misused convert "$hopper" a.mote --structure pkd-tree # there is no other in a file
    misused "$hopper" --structure octree
    misused render "$hopper" -o a.png --shadows long
    misused render "$hopper" -o a.png --shadows 65
    misused render "$hopper" -o a.png --light behind
    misused render "$hopper" -o a.png --light 0,0,0
    misused render "$hopper" -o a.png --light-size -1
    misused render "$hopper" -o a.png --light-size 100
    misused render "$hopper" -o a.png --ambient-occlusion -1
    misused render "$hopper" -o a.png --ambient-occlusion 1.5
    misused render "$hopper" -o a.png --ambient-occlusion some
    misused bake "$hopper" --side 5
    misused render "$hopper" -o a.png --occlusion-reach 1
    misused render "$hopper" -o a.png --ambient-occlusion 1 --occlusion-reach 0
    misused render "$hopper" -o a.png --path-trace --ambient-occlusion 2
    misused render "$hopper" -o a.png --noise 0
    misused render "$hopper" -o a.png --noise 2
    misused render "$hopper" -o a.png --time inf
    misused render "$hopper" -o a.png --zoom nan
    misused render "$hopper" -o a.png --radius-scale 0
    said err 'above zero'
    misused render "$hopper" -o a.png --size 70000x10
    said err 65536
    misused render "$hopper" -o a.png --size 100
    misused render "$hopper" -o a.png --view sideways
    misused render "$hopper" -o a.png --background mudd
    misused render "$hopper" -o a.png --color-map rainbow
    misused render "$hopper" -o a.png --step 0
    misused render "$hopper" -o a.png --type-radius 1:2
    misused render "$hopper" -o a.png --time 1 --step 1
    ;;

  truncated)
    head -c 20000 "$hopper" >cut.dump.gz
    run 1 "$mote" render cut.dump.gz -o a.png
    one_sentence
    said err cut.dump.gz
    zcat "$hopper" | head -c 30000 >cut.dump
    run 1 "$mote" render cut.dump -o a.png
    one_sentence
    [ ! -e a.png ] || fail "a picture of a broken file"
    # Of a run that was killed while it wrote the steps before are shown.
    zcat "$hopper" | head -c 1900000 >killed.dump
    run 0 "$mote" render killed.dump -o a.png --size 160x120 --caption ""
    one_sentence
    said err 'killed.dump: the last time step is damaged'
    run 0 "$mote" render "$hopper" -o b.png --size 160x120 --caption "" --step 6
    cmp -s a.png b.png || fail "another picture than that of the last whole step"
    run 0 "$mote" info killed.dump
    said out 'time steps  6:'
    ;;

  nodisplay)
    run 1 "$mote" "$hopper"
    one_sentence
    said err 'no display'
    run 1 env DISPLAY=:9876 "$mote" "$hopper"
    one_sentence
    ;;

  stdout_full)
    [ -e /dev/full ] || exit 0
    "$mote" info "$hopper" >/dev/full 2>err
    [ $? = 1 ] || fail "a full standard output went unnoticed"
    one_sentence
    ;;

  disk_full) # files end at half a kilobyte, as on a full disk
    (
      trap '' XFSZ
      ulimit -f 1
      "$mote" render "$hopper" -o a.png >/dev/null 2>/dev/null
    )
    [ $? = 1 ] || fail "a full disk went unnoticed"
    [ -z "$(ls | grep -v -e '^out$' -e '^err$')" ] || { ls; fail "something was left"; }
    ;;

  interrupt)
    # Shells start background commands with SIGINT ignored; timeout does not.
    timeout --preserve-status -s INT 3 "$mote" render "$copper" -o a.png --samples 60000 >out 2>err
    code=$?
    [ $code = 130 ] || { cat out err; fail "exit code $code, not 130"; }
    said err interrupted
    [ -z "$(ls | grep -v -e '^out$' -e '^err$')" ] || { ls; fail "something was left"; }
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
