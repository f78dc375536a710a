#!/usr/bin/env bash
# settings.sh MOTE DATA CASE: one test of options, sessions and help. None may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
copper=$data/copper-scratch.dump.gz

case $3 in
  show) # ranges of several values at a time
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show id=1:100 --show type=1
    said out 'of 5,518 particles shown'
    count=$(sed 's/.*, \([0-9]*\) of 5,518.*/\1/' out)
    [ "$count" -gt 0 ] && [ "$count" -le 100 ] || fail "$count particles of the first 100 shown"
    run 0 "$mote" render "$hopper" -o b.png --size 320x200 --show x=:0 --show y=-5:5 --show z=1: \
      --show radius=0.3:0.8 --show type=1:3 --show v:0=-9:9 --show v:magnitude=0:9 --show vz=-9:9
    said out 'of 5,518 particles shown'
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    cmp -s a.png b.png && fail "ranges changed nothing"
    # both ends belong to a range, and the two options hold together
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show id=5:10 --show-by id --show-range 1 5
    said out ' 1 of 5,518 particles shown'
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show id=5: --show-by id --show-range 1 4
    said out ' 0 of 5,518 particles shown'
    one_sentence
    ;;

  where) # an expression chooses as ranges do, and makes arrays to colour and choose by
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show type=2,3 --show z=1: --color-by vz
    some=$(sed 's/.*, \([0-9,]*\) of 5,518.*/\1/' out)
    run 0 "$mote" render "$hopper" -o b.png --size 320x200 --where "(type == 2 || type == 3) && z >= 1" \
      --color-by vz
    said out ", $some of 5,518 particles shown"
    cmp -s a.png b.png || fail "an expression and ranges differ"
    run 0 "$mote" render "$hopper" -o c.png --size 320x200 --where "kinds && z >= 1" --color-by copy \
      --title vz --calculate "kinds=abs(type - 2.5) < 1" --calculate "copy=kinds*vz + !kinds*vz"
    run 0 "$mote" render "$hopper" -o d.png --size 320x200 --where "type == 2 || type == 3" \
      --show z=1: --color-by vz --title vz
    cmp -s c.png d.png || fail "arrays that are calculated differ"
    run 0 "$mote" render "$hopper" -o e.png --size 320x200 --calculate "speed=v.magnitude" \
      --show speed=1: --radius 0.4
    run 0 "$mote" render "$hopper" -o f.png --size 320x200 --calculate "wide=0.4 + 0*type" \
      --show v=1: --radius wide --color-by v --title v
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    run 0 "$mote" render "$data/swirl.1.vtu" -o g.png --size 320x200 --calculate "half=U/2" --color-by half
    # a time step that lacks an array goes without, which is told once
    for q in '' ':q:R:1'; do
      printf '2\nProperties=species:S:1:pos:R:3%s\nA 0 0 0%s\nB 1 1 1%s\n' "$q" "${q:+ 1}" "${q:+ 2}"
    done >some.xyz
    run 0 "$mote" render some.xyz -o s.png --all-steps --size 64x64 --where "q > 1" \
      --color-by type
    said out ' 1 of 2 particles shown'
    [ "$(wc -l <err)" = 1 ] || { cat err; fail "a step without the array is not told once"; }
    said err "no array 'q'"
    # what is wrong is told, with what there is
    run 1 "$mote" render "$hopper" -o a.png --where "energy > 2"
    one_sentence
    said err "no array 'energy'"
    said err 'type, '
    run 1 "$mote" render "$data/swirl.1.vtu" -o a.png --where "energy > 0"
    one_sentence
    said err "no array 'energy'"
    for wrong in 'type = 2' 'type ==' '(type' ''; do
      run 2 "$mote" render "$hopper" -o a.png --calculate "a=$wrong"
      one_sentence
    done
    run 2 "$mote" render "$hopper" -o a.png --calculate x=2
    one_sentence
    ;;

  elements) # types that the data, or the user, name after elements have their colours and names
    symbols=(H He Li Be B C N O F Ne Na Mg Al Si)
    {
      printf '14\nProperties=species:S:1:pos:R:3\n'
      for i in $(seq 14); do echo "${symbols[i - 1]} $i 0 0"; done
    } >named.xyz
    dump() { # COLUMNS: with a type and, where asked for, an element
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n14\nITEM: BOX BOUNDS ff ff ff\n0 15\n-1 1\n-1 1\n'
      echo "ITEM: ATOMS $1 x y z"
      for i in $(seq 14); do echo "$i ${2:+${symbols[i - 1]} }$i 0 0"; done
    }
    dump type >numbered.dump
    dump 'type element' named >named.dump
    names=$(for i in $(seq 14); do echo -n "${i}=${symbols[i - 1]},"; done)
    paint() { # OUT FILE ARGUMENTS...
      run 0 "$mote" render "$2" -o "$1" --size 320x400 --samples 1 --color-by type --radius 0.4 \
        --view +z --caption '' "${@:3}"
    }
    paint xyz.png named.xyz
    paint dump.png named.dump
    paint told.png numbered.dump --type-names "${names%,}"
    paint plain.png numbered.dump
    cmp xyz.png dump.png && cmp xyz.png told.png || fail "names that are told otherwise give other colours"
    cmp -s plain.png told.png && fail "elements have no colours"
    paint palette.png named.xyz --color-map types
    cmp -s palette.png xyz.png && fail "the palette of types is not chosen"
    # Files of the Protein Data Bank have the numbers of the periodic table.
    {
      for i in 6 7 8; do
        printf 'ATOM  %5d %2s   ALA A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s  \n' $i "${symbols[i - 1]}" $i 0 0 "${symbols[i - 1]}"
      done
      echo END
    } >some.pdb
    printf '3\nProperties=species:S:1:pos:R:3\nC 6 0 0\nN 7 0 0\nO 8 0 0\n' >some.xyz
    paint pdb.png some.pdb --color-by atom_type --title type
    paint some.png some.xyz
    cmp pdb.png some.png || fail "atoms of the Protein Data Bank have other colours"
    # Names that are no elements are told in the legend alone; the session has them.
    paint hopper.png "$hopper" --caption ''
    paint layers.png "$hopper" --type-names '1=lowest' --save-session layers.json
    cmp -s hopper.png layers.png && fail "the legend has no names"
    run 0 "$mote" render layers.json -o again.png
    cmp layers.png again.png || fail "the session has other names"
    run 2 "$mote" render "$hopper" -o a.png --type-names 1
    one_sentence
    # One that is no element leaves the others their colours.
    paint wall.png numbered.dump --type-names "${names/5=B,/5=wall,}" --no-legend
    paint boron.png numbered.dump --type-names "${names%,}" --no-legend
    paint palette.png numbered.dump --no-legend
    other=$(python3 "$tests/compare_png.py" wall.png boron.png | cut -d' ' -f1)
    all=$(python3 "$tests/compare_png.py" palette.png boron.png | cut -d' ' -f1)
    [ "$other" -gt 0 ] && [ $((5 * other)) -lt "$all" ] || fail "an unknown name changes $other of $all pixels"
    # A hidden data set is not there; the number of one that is none is refused.
    run 0 "$mote" render "$copper" "$hopper" -o both.png --size 160x120 --samples 1 --color-by none --hide-data 2
    run 0 "$mote" render "$copper" -o one.png --size 160x120 --samples 1 --color-by none
    said out '24,480 particles'
    run 1 "$mote" render "$copper" -o a.png --hide-data 2
    one_sentence
    # What is hidden of volumes is not counted as shown.
    run 0 "$mote" render pump:0.001 -o cells.png --size 64x64 --samples 1 --hide-data 1
    grep -Eq ' [0-9,]+ of [0-9,]+ cells shown' out || { cat out; fail "all cells are counted as shown"; }
    ;;

  periodic) # images of a box, and particles that are wrapped into it or unwrapped
    dump() { # LO HI: an atom and its image numbers in a box of 10
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 10\n0 10\n0 10\n'
      printf 'ITEM: ATOMS id type x y z ix iy iz\n1 1 %s 5 5 2 0 0\n2 1 4 %s 12 0 -1 0\n' "$1" "$2"
    }
    dump 13 5 >a.dump
    run 0 "$mote" info a.dump --positions wrapped
    said out '[3, 4] x [5, 5] x [5, 12]' # no image along z, where there are walls
    dump 3 5 >a.dump
    run 0 "$mote" info a.dump --positions unwrapped
    said out '[4, 23] x [-5, 5] x [5, 12]'
    run 0 "$mote" info a.dump --calculate 'far=x + 1'
    said out 'far'
    run 0 "$mote" render a.dump -o a.png --size 320x200 --radius 1
    run 0 "$mote" render a.dump -o b.png --size 320x200 --radius 1 --replicate 3,2,1
    said out '2 particles, 6 images'
    cmp -s a.png b.png && fail "images change nothing"
    # what a session keeps it draws again
    run 0 "$mote" render a.dump -o c.png --size 320x200 --radius 1 --replicate 3,2,1 \
      --positions wrapped --save-session s.json
    run 0 "$mote" render s.json -o d.png
    cmp c.png d.png || fail "a session forgets images or positions"
    run 2 "$mote" render a.dump -o a.png --replicate 3,0,1
    one_sentence
    run 2 "$mote" render a.dump -o a.png --replicate 300,300,300
    one_sentence
    echo '1 2 3' >b.pts
    for option in '--replicate 2,2,2' '--positions wrapped'; do
      # shellcheck disable=SC2086
      run 1 "$mote" render b.pts -o a.png $option
      one_sentence
      said err 'box'
    done
    sed 's/ix iy iz/jx jy jz/' a.dump >c.dump
    run 1 "$mote" render c.dump -o a.png --positions unwrapped
    one_sentence
    said err "'ix'"
    ;;

  error) # a budget is kept, and not ten times better than asked
    look=(--size 160x120 --no-legend --caption '')
    # budgets NAME OPTIONS...: pictures of several budgets against one that has hardly any error
    budgets() {
      local file=$1
      shift
      run 0 "$mote" render "$file" "${look[@]}" "$@" -o true.png --samples 200 --tolerance 1e-5
      run 0 "$mote" render "$file" "${look[@]}" "$@" -o empty.png --samples 1 --camera 0,0,1e6,0,0,2e6,0,1,0,1
      for budget in 0.5 1 2; do
        run 0 "$mote" render "$file" "${look[@]}" "$@" -o some.png --error "$budget%"
        said out 'expected error '
        error=$(python3 "$tests/compare_png.py" some.png true.png empty.png)
        awk -v e="$error" -v b="$budget" 'BEGIN { exit !(e <= b && e >= b / 10) }' ||
          fail "$file: an error of $error % with a budget of $budget %"
      done
    }
    budgets "$hopper"
    budgets "$hopper" --shadows soft --ao live
    budgets "$data/swirl.1.vtu"
    for wrong in 1 1mm % 0% -1% 101% 0.1px; do
      run 2 "$mote" render "$hopper" -o a.png "--error=$wrong"
      one_sentence
    done
    run 2 "$mote" render "$hopper" -o a.png --error 1% --noise 0.1
    ;;

  lods) # an error of places chooses levels of detail: outlines keep to it, and use it
    look=(--size 256x256 --samples 1 --no-legend --caption '')
    # places FILE ERROR...: the outline of each against the exact one.
    places() {
      local file=$1
      shift
      run 0 "$mote" render "$file" "${look[@]}" -o true.png
      ! grep -q 'levels of detail' out || fail 'levels of detail, which nobody asked for'
      run 0 "$mote" render "$file" "${look[@]}" -o empty.png --camera 0,0,1e6,0,0,2e6,0,1,0,1
      for budget in "$@"; do
        run 0 "$mote" render "$file" "${look[@]}" -o some.png --error "${budget}px"
        said out "levels of detail within $(awk -v b="$budget" 'BEGIN { print b / 2 }') px"
        error=$(python3 "$tests/edge_error.py" some.png true.png empty.png)
        awk -v e="$error" -v b="$budget" 'BEGIN { exit !(e <= b && e >= b / 10) }' ||
          fail "$file: outlines are $error px off with a budget of $budget px"
      done
    }
    places sphere:1000000 3 4 8 12
    python3 "$tests/many_particles.py" many.vtp 165
    places many.vtp 4 8
    # Few particles are exact, and what was asked for counts.
    run 0 "$mote" render "$hopper" "${look[@]}" -o a.png --error 4px
    ! grep -q 'levels of detail' out || fail 'levels of detail, which nobody asked for'
    run 0 "$mote" render sphere:100000 "${look[@]}" -o a.png --error 4px --lod-error 0.5
    said out 'levels of detail within 0.5 px'
    # Of colours they take a small part.
    run 0 "$mote" render sphere:1000000 "${look[@]}" --samples 300 -o true.png
    for budget in 0.5 2; do
      run 0 "$mote" render sphere:1000000 --size 256x256 --no-legend --caption '' -o some.png --error "$budget%"
      said out 'levels of detail within 0.'
      error=$(python3 "$tests/compare_png.py" some.png true.png empty.png)
      awk -v e="$error" -v b="$budget" 'BEGIN { exit !(e <= b && e >= b / 10) }' ||
        fail "an error of $error % with a budget of $budget %"
    done
    ;;

  values) # what options mean
    run 0 "$mote" render "$hopper" -o a.png --size 160x120 --samples 1 --show type=1,3:4
    grep -q 'of 5,518 particles shown' out || fail "nothing is hidden"
    run 0 "$mote" render "$hopper" -o b.png --size 160x120 --samples 1 --show type=2
    several=$(sed -n 's/.* \([0-9,]*\) of 5,518.*/\1/p' out | tr -d ,)
    run 0 "$mote" render "$hopper" -o b.png --size 160x120 --samples 1 --show type=1,3,4
    [ $((5518 - several)) = "$(sed -n 's/.* \([0-9,]*\) of 5,518.*/\1/p' out | tr -d ,)" ] ||
      fail "the others are not all the rest"
    cmp a.png b.png || fail "3:4 is not 3,4"
    run 1 "$mote" render "$hopper" -o b.png --show z=1:2,3:4
    said err 'takes one range'
    run 0 "$mote" render "$data/swirl.1.vtu" -o a.png --size 160x120 --samples 1 --color-by p \
      --show p=:-5e-5,5e-5:
    run 0 "$mote" render "$data/swirl.1.vtu" -o b.png --size 160x120 --samples 1 --color-by p
    cmp -s a.png b.png && fail "a volume hides nothing"
    run 0 "$mote" render "$copper" -o a.png --size 160x120 --samples 1 --color-by z
    run 0 "$mote" render "$copper" -o b.png --size 160x120 --samples 1 --color-by x
    cmp -s a.png b.png && fail "x and z look alike"
    run 0 "$mote" render "$hopper" -o a.png --size 160x120 --samples 1 --color-by type
    run 0 "$mote" render "$hopper" -o b.png --size 160x120 --samples 1 --color-by type --types 4,3,2,1
    cmp -s a.png b.png && fail "types keep their colours"
    run 2 "$mote" render "$hopper" -o b.png --types 1,1
    run 2 "$mote" render "$hopper" -o b.png --legend-format %s
    said err '--legend-format'
    run 1 "$mote" render "$hopper" -o film.mp4
    one_sentence
    said err 'mote animate'
    run 1 "$mote" probe "$hopper" --from 0,0,0 --to 0,0,1
    said err 'holds no cells'
    run 1 "$mote" average "$data/swirl.1.vtu" -a U -o a.txt
    said err '.csv'
    run 1 "$mote" render "$hopper" -o a.png --type-radius 1=2 --radius nix
    said err "'nix'"
    run 2 "$mote" silhouettes a.png -o b.png --thickness 0
    said err '--thickness'
    grep -q silhouette-thickness err && fail "an option of another command is named"
    run 0 "$mote" render "$hopper" -o a.png --size 160x120 --size 80x60 --samples 1
    [ "$(png_size a.png)" = 80x60 ] || fail "the last of two sizes does not count"
    ;;

  idle) # options that do nothing get a sentence, and a picture all the same
    idle() {
      local sentence=$1
      shift
      run 0 "$mote" render "$@" -o a.png --size 160x120 --samples 1
      said err "mote: warning: $sentence"
      one_sentence
    }
    idle '--iso: there is no surface at 77' "$data/swirl.1.vtu" --color-by p --iso 77
    idle '--shadows, --silhouettes do nothing' "$data/swirl.1.vtu" --cloud on --shadows soft --silhouettes
    idle '--ambient-occlusion does nothing' "$data/swirl.1.vtu" --cloud on --ao live
    idle 'the options of volumes' "$hopper" --opacity 0%=0.5
    printf 'x,y,z,v\n0,0,0,-1\n1,1,1,2\n' >signed.csv
    idle 'the options of volumes' "$hopper" --opacity 0%=0.5
    idle '--path-trace, --light do nothing' "$data/swirl.1.vtu" --cloud on --path-trace --light left
    idle '--structure, --form do nothing' "$data/swirl.1.vtu" --structure pkd-tree --form 4-byte
    idle '--sample-distance does nothing' "$data/swirl.1.vtu" --cloud on --sample-distance 0.001
    idle '--tolerance does nothing' "$data/swirl.1.vtu" --cloud on --integrator trilinear --tolerance 0.5
    idle '--integrator, --tolerance do nothing here: there is no cloud' "$data/swirl.1.vtu" --integrator trilinear --tolerance 0.5
    idle '--cloud off leaves nothing' "$data/swirl.1.vtu" --cloud off --slice none --walls 0
    idle '--range, --title do nothing' "$hopper" --color-by none --range 0 1 --title speed
    idle '--legend-side does nothing' "$hopper" --no-legend --legend-side left
    idle '--light-size does nothing' "$hopper" --light-size 60
    idle '--color-map types does nothing' "$copper" --color-by c_centro --color-map types
    idle '--log: values at or below 0' signed.csv --color-by v --log
    # What is next to nothing beside values that are 0 is rounding.
    printf 'x,y,z,v\n0,0,0,0\n1,0,0,1e-15\n2,0,0,0.001\n3,0,0,1\n' >tiny.csv
    run 0 "$mote" render tiny.csv -o a.png --size 320x200 --color-by v --log
    run 0 "$mote" render tiny.csv -o b.png --size 320x200 --color-by v --log --range 1e-6 1
    cmp -s a.png b.png || fail "logarithmic colours begin at rounding"
    ;;

  sessions) # what render saves it renders again, wherever the files go
    run 0 "$mote" render "$copper" -o a.png --size 320x200 --show c_centro=3: --shadows hard \
      --silhouettes=3 --save-session s.json
    run 0 "$mote" render s.json -o b.png
    cmp a.png b.png || fail "another picture"
    mkdir moved
    cp "$copper" moved
    cp s.json moved
    sed -i 's|"[^"]*copper|"/gone/copper|' moved/s.json
    run 0 "$mote" render moved/s.json -o b.png --save-session moved/again.json
    cmp a.png b.png || fail "another picture after the move"
    run 0 "$mote" render moved/again.json -o c.png --color-map plasma --size 320x200
    cmp -s a.png c.png && fail "the command line has no say"
    rm "moved/$(basename "$copper")"
    run 1 "$mote" render moved/s.json -o d.png
    said err 'is not there any more'
    echo '{"mote-session": 1, "files": ["x"], "light": {"shadow": 1}}' >bad.json
    run 1 "$mote" render bad.json -o d.png
    said err bad.json
    one_sentence
    python3 -c 'n = 1000000; print("{\"mote-session\": 1, \"files\": " + n * "[" + n * "]" + "}")' >bad.json
    run 1 "$mote" render bad.json -o d.png
    said err 'lie in one another too deeply'
    run 1 "$mote" render moved/again.json "$copper" -o d.png
    said err 'give it alone'
    # The file of a colour map goes with the session.
    printf '0 0 1\n1 1 0\n' >own.txt
    run 0 "$mote" render "$copper" -o a.png --size 320x200 --color-by c_centro --color-map own.txt --save-session map.json
    grep -q '"color-map": "own.txt"' map.json || fail "where the colour map is: $(grep color-map map.json)"
    run 0 "$mote" render "$copper" -o b.png --size 320x200 --color-by c_centro --color-map viridis
    cmp -s a.png b.png && fail "not the file's colours"
    mkdir far
    mv own.txt map.json far
    run 0 "$mote" render far/map.json -o b.png
    cmp a.png b.png || fail "another picture with the colour map's file"
    rm far/own.txt
    run 1 "$mote" render far/map.json -o b.png
    said err 'own.txt is not there any more'
    said err '"color-map"'
    # Lines are as thick at another size, as a share of the picture, unless it is said how thick.
    run 0 "$mote" render s.json -o a.png --size 640x400 --save-session twice.json
    run 0 "$mote" render s.json -o b.png --size 640x400 --silhouette-thickness 3
    run 0 "$mote" render twice.json -o c.png
    cmp a.png b.png || fail "lines are not twice as thick at twice the size"
    cmp a.png c.png || fail "a session has other lines than its picture"
    # A range that mote chose is chosen anew for another array; a switch is turned off.
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --log --save-session s.json
    run 0 "$mote" render s.json -o a.png --color-by type --log=false
    run 0 "$mote" render "$hopper" -o b.png --size 320x200 --color-by type
    cmp a.png b.png || fail "the range of one array colours another"
    # Other commands read a session's data, too.
    run 0 "$mote" info s.json
    said out '5,518 points'
    # Nothing is overwritten, and what cannot be written is told before any work.
    cp "$hopper" mine.dump.gz
    run 1 "$mote" render mine.dump.gz -o a.png --save-session mine.dump.gz
    said err '.json'
    cmp mine.dump.gz "$hopper" || fail "the data are gone"
    rm a.png
    run 1 "$mote" render "$hopper" -o a.png --save-session no/folder/s.json
    one_sentence
    [ ! -e a.png ] || fail "a picture before the sentence"
    : >empty.json
    run 1 "$mote" render empty.json -o a.png
    said err 'empty'
    run 1 "$mote" render missing.json -o a.png
    said err 'there is no such file'
    ;;

  topics) # help about a group, an option, the keys; the reference is what the table says
    for topic in data colour selection radius structure volume camera light silhouettes picture \
      keys formats animate shadows legend cloud color bake render probe \
      --range -c ao save-session all-steps; do
      run 0 "$mote" help "$topic"
      [ "$(wc -l <out)" -ge 2 ] || fail "little help about $topic"
    done
    run 0 "$mote" help
    said out silhouettes
    run 1 "$mote" help nonsense
    said err selection
    run 0 "$mote" help --format markdown
    cmp out "$(dirname "$data")/docs/settings.md" ||
      fail "docs/settings.md is not what mote help --format markdown prints"
    run 0 "$mote" help keys --format markdown
    cmp out "$(dirname "$data")/docs/keys.md" ||
      fail "docs/keys.md is not what mote help keys --format markdown prints"
    run 0 "$mote" help --format man
    sed 's/\\-/-/g' out >page
    for text in --all-steps --memory --tolerance 'Values: auto, volume, surface' lattice 'EXIT STATUS'; do
      said page "$text"
    done
    if command -v man >/dev/null; then
      man -l --warnings out >/dev/null 2>err
      [ ! -s err ] || { cat err; fail "the manual page is ill"; }
    fi
    run 0 "$mote" help --format bash
    bash -n out || fail "the completion is no bash"
    source out
    COMP_WORDS=(mote render --shad) COMP_CWORD=2
    _mote
    [ "${COMPREPLY[*]}" = --shadows ] || fail "completed to ${COMPREPLY[*]}"
    COMP_WORDS=(mote render --cells s) COMP_CWORD=3
    _mote
    [ "${COMPREPLY[*]}" = surface ] || fail "completed to ${COMPREPLY[*]}"
    : >'my run.dump'
    COMP_WORDS=(mote render my) COMP_CWORD=2
    _mote
    [ "${COMPREPLY[0]}" = 'my run.dump' ] || fail "completed to ${COMPREPLY[*]}"
    # A disk that is full is told of, and so is a command that is none.
    for words in help "help data" --help --version; do
      "$mote" $words >/dev/full 2>err && fail "$words to a full disk went unnoticed"
      one_sentence
    done
    run 2 "$mote" rendr "$hopper" -o a.png
    said err "'rendr'"
    said err 'render, '
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
