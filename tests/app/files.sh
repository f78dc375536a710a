#!/usr/bin/env bash
# files.sh MOTE DATA CASE: one test of files that Mote writes and makes. None of them may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
copper=$data/copper-scratch.dump.gz
# on_full_disk BLOCKS COMMAND...: where files have so many blocks at most, it ends with a sentence.
on_full_disk() {
  (
    trap '' XFSZ
    ulimit -f "$1"
    "${@:2}" >/dev/null 2>err
  )
  [ $? = 1 ] || fail "a full disk went unnoticed: ${*:2}"
  one_sentence
}

case $3 in
  convert) # a file of its own gives the picture that the dump gives
    run 0 "$mote" convert "$copper" a.mote
    said out 'a.mote: '
    said out 'built in'
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    run 0 "$mote" info a.mote
    for text in c_centro vtkOriginalPointIds 'time steps' spacing bounds; do said out "$text"; done
    for extra in '' '--show c_centro=5:' '--radius 0.9 --color-by type' '--radius-scale 0.7'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render "$copper" -o a.png --size 320x200 --caption '' $extra
      # shellcheck disable=SC2086
      run 0 "$mote" render a.mote -o b.png --size 320x200 --caption '' $extra
      is_picture b.png 320x200
      if command -v python3 >/dev/null; then
        wrong= bias=
        read -r wrong bias < <(python3 "$tests/compare_png.py" a.png b.png)
        [ -n "$bias" ] && [ "$wrong" -le 20 ] && [ "${bias#-}" -le 50 ] ||
          fail "the pictures differ: $wrong in 10,000 pixels, bias $bias, with '$extra'"
      fi
    done
    run 0 "$mote" convert a.mote b.mote # and again
    cmp a.mote b.mote || fail "a file written from a file is another"
    run 0 "$mote" convert "$copper" c.mote --radius 0.5 --step first
    cmp -s a.mote c.mote && fail "options changed nothing"
    for form in exact 8-byte 4-byte; do
      run 0 "$mote" convert "$copper" "$form.mote" --form "$form"
      run 0 "$mote" info "$form.mote"
      said out "$form, coordinates off by up to"
      run 0 "$mote" info --json "$form.mote"
      said out "\"form\": \"$form\""
      run 0 "$mote" render "$form.mote" -o a.png --size 320x200
      is_picture a.png 320x200
    done
    cmp a.mote exact.mote || fail "the exact form is not what is written without --form"
    [ "$(wc -c <4-byte.mote)" -lt "$(wc -c <8-byte.mote)" ] &&
      [ "$(wc -c <8-byte.mote)" -lt "$(wc -c <exact.mote)" ] || fail "short forms are not shorter"
    run 0 "$mote" convert 4-byte.mote again.mote
    cmp 4-byte.mote again.mote || fail "a file's form was not kept"
    run 1 "$mote" convert "$copper" d.mote --form 4-byte --radius 0.001
    one_sentence
    said err 'of the smallest radius, 0.001'
    [ ! -e d.mote ] || fail "a file in spite of an error"
    run 1 "$mote" convert "$copper" "$hopper"
    one_sentence
    said err .mote
    run 1 "$mote" convert a.mote
    one_sentence
    run 1 "$mote" convert "$copper" no/folder/a.mote
    one_sentence
    run 2 "$mote" convert
    head -c 5000 a.mote >short.mote
    run 1 "$mote" render short.mote -o a.png
    one_sentence
    said err 'cut short'
    on_full_disk 100 "$mote" convert "$copper" full.mote
    [ -z "$(ls -A | grep -e full -e tmp)" ] || { ls -A; fail "something was left"; }
    ;;

  others) # what is shown, for other programs
    count() { "$mote" info --json "$1" | grep -o "\"$2\": [0-9]*" | head -1 | grep -o '[0-9]*$'; }
    for file in a.vtp a.vtu a.xyz a.xyz.gz; do
      run 0 "$mote" convert "$copper" "$file"
      said out "$file: 24,480 particles, "
      run 0 "$mote" info "$file"
      for text in '24,480 points' 'c_centro' '26502' 'vectors (130.14, 0, 0) (0, 72.3, 0)'; do said out "$text"; done
      # The picture of the file is that of the dump.
      run 0 "$mote" render "$copper" -o a.png --size 320x200 --caption '' --no-legend --color-by c_pe --radius 1.4
      run 0 "$mote" render "$file" -o b.png --size 320x200 --caption '' --no-legend --color-by c_pe --radius 1.4
      if command -v python3 >/dev/null; then
        read -r wrong bias < <(python3 "$tests/compare_png.py" a.png b.png)
        [ "$wrong" = 0 ] || fail "the picture of $file differs: $wrong"
      fi
    done
    # What ranges, expressions, ids and cuts leave is what the picture counts.
    for hiding in '--show c_centro=5:' '--where type==1&&z>20' '--only-ids 100:5000' '--hide-ids 1:20000' \
      '--show z=10:30 --show type=1,3' '--show radius=0: --radius 2'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render "$copper" -o a.png --size 64x64 $hiding
      shown=$(grep -o '[0-9,]* of 24,480 particles shown' out | head -1)
      shown=${shown%% of*}
      for file in some.vtp some.xyz some.mote; do
        # shellcheck disable=SC2086
        run 0 "$mote" convert "$copper" $hiding $file
        said out "$file: ${shown:-24,480} particles"
        [ "$(count $file points)" = "$(echo "${shown:-24480}" | tr -d ,)" ] || fail "$file holds others"
      done
    done
    run 0 "$mote" convert "$copper" --cut x=0:65 --cut-axis 65,36,0,0,0,1 --cut r=:30 some.xyz
    python3 - some.xyz <<'END' || fail "others are cut away"
import sys
rows = open(sys.argv[1]).read().splitlines()[2:]
places = [[float(x) for x in row.split()[:3]] for row in rows]
assert 500 < len(places) < 12000, len(places)
for x, y, z in places:
    assert 0 <= x <= 65 and (x - 65) ** 2 + (y - 36) ** 2 <= 900 * (1 + 1e-9), (x, y, z)
END
    # The radius of all stays that of the few that are left; other radii become an array.
    run 0 "$mote" convert "$copper" --only-ids 1,24480 two.mote
    run 0 "$mote" info "$copper"
    spacing=$(sed -n 's/^ *spacing *\([0-9.]*\).*/\1/p' out)
    run 0 "$mote" convert two.mote two.xyz --radius-scale 1.5
    run 0 "$mote" convert "$copper" --only-ids 1,24480 --radius-scale 0.75 larger.mote
    run 0 "$mote" convert larger.mote larger.xyz --radius-scale 2
    for file in two.xyz larger.xyz; do
      python3 - $file "$spacing" <<'END' || fail "the radius in $file is another"
import sys
head, *rows = open(sys.argv[1]).read().splitlines()[1:]
assert "radius:R:1" in head and len(rows) == 2, head
for row in rows:
    assert abs(float(row.split()[-1]) / (1.5 * 0.5 * float(sys.argv[2])) - 1) < 2e-3, row
END
    done
    # Cells.
    run 0 "$mote" render "$data/swirl.0.vtu" -o a.png --size 64x64 --show x=0:
    cells=$(grep -o '[0-9,]* of [0-9,]* cells shown' out)
    run 0 "$mote" convert "$data/swirl.0.vtu" --show x=0: half.vtu
    said out "half.vtu: ${cells%% of*} cells"
    run 0 "$mote" convert "$data/swirl.0.vtu" --cut angle=350:370 slice.vtu
    run 0 "$mote" info slice.vtu
    said out 'hexahedra'
    run 0 "$mote" convert "$data/swirl.0.vtu" "$data/swirl.1.vtu" all.vtu --all-steps
    [ -s all.0001.vtu ] && [ -s all.0002.vtu ] || fail "not one file a step"
    run 0 "$mote" convert "$copper" all.xyz.gz --all-steps
    # What cannot be.
    run 1 "$mote" convert "$data/swirl.0.vtu" a.xyz
    one_sentence
    said err 'a .xyz file holds one set of particles'
    run 1 "$mote" convert pump:0.02 pump.vtu
    one_sentence
    said err "choose one: --hide-part '*' --show-part NAME"
    run 0 "$mote" convert pump:0.02 pump.vtu --hide-part '*' --show-part rotor
    run 0 "$mote" convert pump:0.02:rotor pump.vtu
    run 1 "$mote" convert "$copper" --show x=1e6: none.vtp
    one_sentence
    said err 'is shown'
    [ ! -e none.vtp ] || fail "a file of nothing"
    run 1 "$mote" convert a.vtp a.vtp
    one_sentence
    for file in full.vtp full.vtu full.xyz full.xyz.gz; do
      on_full_disk 50 "$mote" convert "$copper" $file
      said err "$file\": the file is larger than the limit"
    done
    [ -z "$(ls -A | grep -e full -e tmp)" ] || { ls -A; fail "something was left"; }
    ;;

  pieces) # pieces make the picture of the whole
    run 0 "$mote" convert pump:0.02:rotor whole.vtu
    run 0 "$mote" convert whole.vtu pump.pvtu --pieces 4
    said out '42,588 cells, 4 pieces'
    [ -s pump/pump_3.vtu ] && [ ! -e pump/pump_4.vtu ] || fail "not four pieces"
    for file in whole.vtu pump.pvtu; do
      run 0 "$mote" info "$file"
      said out 't = 0.0395'
      points=$(grep -o '[0-9,]* points' out)
      [ "${same:=$points}" = "$points" ] || fail "$file: $points, not $same"
      run 0 "$mote" render "$file" -o "$file.png" --size 300x200 --caption '' --color-by pressure
    done
    cmp whole.vtu.png pump.pvtu.png || fail "pieces make another picture"
    run 0 "$mote" convert "$copper" --show c_centro=5: some.pvtp --pieces 3
    said out '3 pieces'
    run 0 "$mote" convert "$copper" --show c_centro=5: some.vtp
    for file in some.vtp some.pvtp; do
      run 0 "$mote" info --json "$file"
      grep -o '"points": *[0-9]*' out >"$file.count"
      [ -s "$file.count" ] || fail "no count of $file"
    done
    cmp some.vtp.count some.pvtp.count || fail "particles are lost"
    run 1 "$mote" convert "$copper" a.mote --pieces 3
    one_sentence
    said err 'ranks read in parts'
    run 2 "$mote" convert "$copper" a.pvtp --pieces 0
    # All parts, as blocks.
    run 0 "$mote" convert pump:0.02 all.vtm
    said out '3 blocks'
    for file in pump:0.02 all.vtm; do
      run 0 "$mote" render "$file" -o one.png --size 300x200 --caption ''
      mv one.png "$(basename "$file" .vtm).png"
    done
    cmp pump:0.02.png all.png || fail "blocks make another picture"
    run 0 "$mote" info all.vtm
    [ "$(grep -c 't = 0.0395' out)" = 3 ] || fail "blocks have lost their time"
    run 0 "$mote" convert pump:0.001 steps.vtm --all-steps
    run 0 "$mote" info steps.0001.vtm steps.0002.vtm steps.0003.vtm
    said out 'time steps  3: 0, 0.0005, 0.001'
    run 1 "$mote" convert all.vtm some.vtm # beside some.pvtp, whose pieces are in that folder
    one_sentence
    said err 'would replace those of "some.pvtp"'
    run 0 "$mote" convert all.vtm high.vtm --hide-part inlet --show pressure=1e5:
    said out '2 blocks'
    run 1 "$mote" convert all/all_0.vtu all.vtm
    one_sentence
    said err 'lies in the folder'
    run 1 "$mote" convert all.vtm none.vtm --show pressure=1e9:
    one_sentence
    said err 'none.vtm would be empty'
    run 1 "$mote" convert pump:0.02:rotor a.pvtp
    one_sentence
    said err 'a .pvtp file holds'
    on_full_disk 50 "$mote" convert whole.vtu full.pvtu
    said err 'full_0.vtu": the file is larger than the limit'
    [ ! -e full.pvtu ] || fail "an index of pieces that are not there"
    on_full_disk 50 "$mote" convert all.vtm full.vtm
    said err 'full_0.vtu": the file is larger than the limit'
    [ ! -e full.vtm ] || fail "an index of blocks that are not there"
    # What was there stays, and nothing is left over.
    cp all.vtm old.vtm
    cp -r all old
    on_full_disk 500 "$mote" convert pump:0.02 all.vtm
    cmp all.vtm old.vtm && diff -r all old || fail "the old blocks did not stay"
    ;;
  generated) # particles that are made, wherever a file may be named
    for input in lattice:5000 random:5000:0.01 varied:5000; do
      run 0 "$mote" info "$input"
      grep -q -e '4,913 points' -e '5,000 points' out || fail "not so many points"
      run 0 "$mote" convert "$input" a.mote
      run 0 "$mote" convert "$input" b.mote --memory 1K
      cmp a.mote b.mote || fail "by way of scratch files it is another"
      run 0 "$mote" render "$input" -o a.png --size 320x200 --caption ''
      run 0 "$mote" render a.mote -o b.png --size 320x200 --caption ''
      is_picture a.png 320x200
      if command -v python3 >/dev/null; then
        wrong= bias=
        read -r wrong bias < <(python3 "$tests/compare_png.py" a.png b.png)
        [ -n "$bias" ] && [ "$wrong" -le 20 ] || fail "the pictures of $input differ: $wrong"
      fi
    done
    run 0 "$mote" render lattice:5000 -o b.png --size 320x200 --radius 0.01 --show x=0.2:0.5
    said out 'of 4,913 particles shown'
    run 0 "$mote" convert lattice:5000 c.mote --radius 0.01
    cmp -s a.mote c.mote && fail "options changed nothing"
    for wrong in lattice: lattice:x random:5 random:5:0 lattice:99999999999999; do
      run 1 "$mote" render "$wrong" -o c.png
      one_sentence
      said err "$wrong: "
      [ ! -e c.png ] || fail "a picture of $wrong"
    done
    run 1 "$mote" convert lattice:x d.mote
    one_sentence
    cp "$hopper" lattice:8 # a file of that name
    run 0 "$mote" info lattice:8
    said out '5,518 points'
    ;;

  streamed) # as much through files as there is: the same bytes, and nothing is left
    zcat "$copper" >copper.dump
    { echo 3; echo; echo 'O 0 0 0'; echo 'H 1 0 0'; echo 'H 0 1 0'; } >water.xyz
    for input in "$copper" copper.dump "$hopper" water.xyz; do
      run 0 "$mote" convert "$input" a.mote
      cp err said
      for memory in 1 300K; do
        run 0 "$mote" convert "$input" b.mote --memory $memory
        cmp a.mote b.mote || fail "with $memory another file"
        sed 's/b\.mote/a.mote/' err | cmp said - || fail "something else is said"
      done
    done
    on_full_disk 100 "$mote" convert "$copper" full.mote --memory 1K
    said err full.mote
    run 2 "$mote" convert "$copper" a.mote --memory 0
    run 2 "$mote" convert "$copper" a.mote --memory much
    # stopped on the way, and killed
    for signal in INT KILL; do
      timeout --preserve-status -s $signal 2 "$mote" convert random:100000000:0.0005 \
        stopped.mote --memory 1M >out 2>err
      [ $signal = KILL ] || said err interrupted
    done
    mkdir full
    if mount -t tmpfs -o size=1m none full 2>/dev/null; then
      run 1 "$mote" convert "$copper" full/a.mote --memory 1K
      one_sentence
      run 1 "$mote" convert random:200000:0.001 full/a.mote
      one_sentence
      said err 'disk is full'
      left=$(ls -A full)
      umount full
      [ -z "$left" ] || fail "left: $left"
    fi
    rmdir full
    left=$(ls -A | grep -v -x -e out -e err -e said -e 'copper.dump' -e 'water.xyz' -e '[ab].mote')
    [ -z "$left" ] || fail "left: $left"
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
