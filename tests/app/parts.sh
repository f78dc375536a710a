#!/usr/bin/env bash
# parts.sh MOTE DATA CASE WRITER: one test of parts: blocks and patches of files by their names. WRITER writes samples.
tests=$(realpath "$(dirname "$0")")
if [ "$3" = window ]; then source "$tests/panel_common.sh"; else source "$tests/common.sh"; fi
"$4" . || fail "no samples"

# draw OUT ARGUMENTS...: a picture.
draw() {
  local picture=$1
  shift
  run 0 "$mote" render "$@" -o "$picture" --size 160x120 --samples 1 --caption ''
  [ "$(png_size "$picture")" = 160x120 ] || fail "no picture $picture"
}

differ() { ! cmp -s "$1" "$2" || fail "$1 and $2 are the same"; }

case $3 in
  info) # what parts there are
    run 0 "$mote" info foam/case.foam
    grep -Eq '^ +parts +4$' out || fail "no count of parts"
    grep -Eq '^ +1 +internalMesh +volume +12 +36$' out || fail "no volume: $(cat out)"
    grep -Eq '^ +4 +walls +surface +24 +32 +not shown unless --show-part names it$' out || fail "no patch: $(cat out)"
    said out 'case.foam: inlet'
    run 0 "$mote" info foam/system/controlDict --show-part inlet --hide-part internal\*
    grep -Eq 'internalMesh.* hidden$' out || fail "nothing is hidden"
    grep -Eq ' inlet +surface +4 +9$' out || fail "the inlet is not shown"
    (cd foam && run 0 "$mote" info . && said out 'foam: inlet') || fail "a folder is no case"
    run 0 "$mote" info --json foam/case.foam
    python3 - out <<'PY' || fail "wrong JSON"
import json, sys

parts = json.load(open(sys.argv[1]))
assert [p["part"] for p in parts] == ["internalMesh", "inlet", "outlet", "walls"], parts
assert [p["kind"] for p in parts] == ["volume"] + 3 * ["surface"]
assert [p["hidden"] for p in parts] == [False, True, True, True]
assert parts[0]["times"] == [0, 0.5] and parts[0]["cells"] == 12
assert "p" in [a["name"] for a in parts[0]["arrays"]]
PY
    run 0 "$mote" info decomposed/case.foam
    grep -Eq ' internalMesh +volume +24 ' out || fail "not both processors"
    run 0 "$mote" info a.cgns --step 1
    grep -Eq ' fluid +volume +12 ' out && grep -Eq ' walls +surface +24 .* not shown' out || fail "no zones: $(cat out)"
    said out 'step 1, t = 0'
    run 0 "$mote" info ensight/box.case
    grep -Eq ' fluid +volume +12 ' out && grep -Eq ' inlet +surface +4 .* not shown' out || fail "no parts: $(cat out)"
    # Damaged files get a sentence, and nothing else is printed.
    for file in a.cgns ensight/box.geo ensight/box.p.1 foam/constant/polyMesh/owner a.vts; do
      cp $file whole
      for part in 3 10; do
        head -c $(($(stat -c %s whole) * part / 16)) whole >$file
        run 1 "$mote" info a.cgns ensight/box.case foam/case.foam a.vts
        one_sentence
        said err "${file%%/*}"
      done
      cp whole $file
    done
    cp a.cgns whole
    printf 'FILE' | dd of=a.cgns bs=1 seek=12000 conv=notrunc 2>/dev/null
    "$mote" info a.cgns >out 2>err || one_sentence
    cp whole a.cgns
    run 0 "$mote" info a.vtm
    grep -Eq ' fluid +volume +12 ' out && grep -Eq ' block 2 +volume +12 ' out || fail "no blocks: $(cat out)"
    ;;

  pictures) # patches would hide the volume, and are hidden at first
    draw usual.png foam/case.foam
    [ ! -s err ] || fail "told of patches that nobody asked for: $(cat err)"
    said out '12 cells;' # and no count of what was never asked for
    draw walls.png foam/case.foam --show-part walls
    [ ! -s err ] || fail "told in spite of a choice: $(cat err)"
    said out '12 cells, 48 triangles;'
    draw patches.png foam/case.foam --show-part '*' --hide-part internalMesh
    draw same.png foam/case.foam --show-part inlet --show-part outlet --show-part walls
    for one in walls patches; do differ usual.png $one.png; done
    alike patches.png same.png
    draw alone.png foam/case.foam --hide-part internalMesh --show-part 'in*t'
    said out '0 of 12 cells shown, 8 triangles;'
    [ ! -s err ] || fail "something on standard error: $(cat err)"
    differ alone.png patches.png
    run 1 "$mote" render foam/case.foam -o a.png --hide-part blade
    one_sentence
    said err "no part 'blade'; there is internalMesh, inlet, outlet, walls"
    run 2 "$mote" render foam/case.foam -o a.png --hide-part ''
    # Time steps of the format's own.
    draw first.png foam/case.foam --step 1 --range 0 12
    draw last.png foam/case.foam --time 0.7 --range 0 12
    differ first.png last.png
    draw time.png foam/case.foam --time 0.3 --range 0 12
    alike first.png time.png
    run 1 "$mote" render foam/case.foam -o a.png --step 3
    # A session and what it prints keep them.
    run 0 "$mote" render foam/case.foam -o a.png --size 160x120 --samples 1 --caption '' --show-part walls --save-session s.json
    said s.json '"show-part"'
    run 0 "$mote" render s.json -o b.png
    alike a.png b.png
    # Structured grids are volumes.
    draw grid.png a.vts --color-by q
    said out '12 cells'
    draw faces.png a.vts --color-by q --cells surface
    differ grid.png faces.png
    # Files go by names, too.
    draw one.png a.vts foam/case.foam --hide-part 'case.foam*'
    said out '12 of 24 cells'
    ;;

  commands) # other commands take what is shown
    run 0 "$mote" average foam/case.foam --array p --resolution 10 -o a.csv
    run 0 "$mote" probe foam/case.foam --from 0.1,0.5,0.5 --to 2.9,0.5,0.5 --points 5 -o b.csv
    grep -q 'case.foam: internalMesh' b.csv || fail "not in the mesh: $(cat b.csv)"
    run 1 "$mote" probe foam/case.foam --from 0.1,0.5,0.5 --to 2.9,0.5,0.5 -o c.csv --hide-part '*'
    one_sentence
    said err 'leave nothing'
    run 0 "$mote" convert foam/case.foam walls.mote --show-part walls --hide-part internalMesh
    run 0 "$mote" info walls.mote
    said out '48 triangles'
    ;;

  window) # a box for each
    open foam/case.foam --size 900x700
    shown 'data 4'
    has_no '--show-part'
    click 'data 4' 0.3
    has '--show-part=walls'
    picture walls.png
    click 'data 1' 0.3
    has '--hide-part=internalMesh.*--show-part=walls'
    click 'data 4' 0.3
    has_no '--show-part'
    click 'data 1' 0.3
    has_no '--hide-part'
    picture usual.png
    differ usual.png walls.png
    press ctrl+z
    has '--hide-part=internalMesh'
    press Left
    has '--step=1'
    has '--hide-part=internalMesh'
    quit
    ;;

  *)
    fail "no case $3"
    ;;
esac
