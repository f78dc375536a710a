#!/usr/bin/env bash
# silhouettes.sh MOTE DATA CASE: one test of `mote silhouettes`. None of them may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
copper=$data/copper-scratch.dump.gz

# draw OPTIONS...: draws the silhouettes of depth.exr into lines.png.
draw() {
  run 0 "$mote" silhouettes depth.exr -o lines.png "$@"
  [ ! -s err ] || { cat err; fail "something on standard error"; }
}

# differs OPTIONS...: they make another picture than those before, which goes to before.png.
differs() {
  draw "$@"
  cmp -s lines.png before.png && fail "no difference: $*"
  mv lines.png before.png
}

case $3 in
  pictures) # every option is another picture
    run 0 "$mote" render "$copper" -o depth.exr --size 400x300
    draw
    is_picture lines.png 400x300
    said out 'lines.png: 400x300, silhouettes at steps from '
    cp lines.png before.png
    differs --lines-only
    is_picture before.png 400x300
    differs --lines-only --threshold 3%
    differs --lines-only --threshold 0.3
    said out 'silhouettes at steps from 0.3;'
    differs --lines-only --threshold 0.3 --step-pixels 8
    differs --lines-only --threshold 30%
    differs --lines-only --threshold 30% --no-hulls
    differs --lines-only --threshold 30% --groups particle
    differs --lines-only --on-pixels
    differs --lines-only --thickness 3
    differs --lines-only --thickness 1:3
    differs --lines-only --opacity 1
    differs --lines-only --color DarkRed
    differs --lines-only --color '#00f'
    differs --lines-only --far 150
    differs --lines-only --along-rays --step-pixels 5
    differs --lines-only --view-angle 90
    differs --lines-only --orthographic 100
    differs --reduce 4
    [ "$(png_size before.png)" = 100x75 ] || fail "not reduced: $(png_size before.png)"
    draw --lines-only --threads 1
    cp lines.png before.png
    draw --lines-only --threads 2
    cmp lines.png before.png || fail "the number of threads makes a difference"
    for file in lines.jpg lines.tif lines.exr; do
      run 0 "$mote" silhouettes depth.exr -o $file
    done
    ;;

  errors)
    run 0 "$mote" render "$copper" -o depth.exr --size 100x80
    run 0 "$mote" render "$copper" -o colors.png --size 100x80
    run 0 "$mote" silhouettes --help
    said out --threshold
    # a wrong command line
    for wrong in '' 'depth.exr' '-o a.png' 'depth.exr -o a.png --threshold x' \
      'depth.exr -o a.png --threshold -1' 'depth.exr -o a.png --threshold off' 'depth.exr -o a.png --thickness 3:1' \
      'depth.exr -o a.png --thickness 0' 'depth.exr -o a.png --opacity 2' \
      'depth.exr -o a.png --color nocolour' 'depth.exr -o a.png --reduce 0' \
      'depth.exr -o a.png --view-angle 180' 'depth.exr -o a.png --orthographic 0' \
      'depth.exr -o a.png --orthographic 5 --along-rays'; do
      # shellcheck disable=SC2086
      run 2 "$mote" silhouettes $wrong
      one_sentence
    done
    # what cannot be done
    echo "no image" >text.exr
    head -c 3000 depth.exr >short.exr
    for file in none.exr text.exr short.exr .; do
      run 1 "$mote" silhouettes "$file" -o a.png
      one_sentence
      said err "Cannot read"
    done
    run 1 "$mote" silhouettes colors.png -o a.png
    one_sentence
    said err 'has no array "depth"'
    run 1 "$mote" silhouettes depth.exr -o a.png --groups material
    one_sentence
    said err 'has no array "material" of numbers; it has '
    run 1 "$mote" silhouettes depth.exr -o a.png --depth normal
    one_sentence
    said err 'must have one'
    run 1 "$mote" silhouettes depth.exr -o a.gif
    one_sentence
    run 1 "$mote" silhouettes depth.exr -o missing/a.png
    one_sentence
    [ ! -e a.png ] || fail "a picture after an error"
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
