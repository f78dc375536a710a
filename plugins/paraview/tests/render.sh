#!/usr/bin/env bash
# render.sh: `scripts/paraview render` and `convert` from one rank, two and four, and what they say of errors.
root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../..
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "FAILED  $*" >&2
  exit 1
}
render() { "$root/scripts/paraview" render "$@" 2>"$folder/err" || { cat "$folder/err"; return 1; }; }
refused() { # WORDS ARGUMENT...
  local words=$1
  shift
  "$root/scripts/paraview" "${act:-render}" "$@" >"$folder/out" 2>&1 && fail "taken: $*"
  grep -qF "$words" "$folder/out" || fail "no '$words' in: $(tail -3 "$folder/out")"
  echo "ok      refused: $words"
}
# alike A B STEPS: hardly a pixel differs by more than so many of 255.
alike() {
  oiiotool --fail "$(python3 -c "print($3.5 / 255)")" --failpercent 0.02 --hardfail 1 --diff "$1" "$2" >"$folder/diff" || {
    cat "$folder/diff"
    fail "$1 and $2 differ"
  }
}

# as_on_one FILE LOOK DIFFERENCE RANKS GHOSTS:SHARE: of the picture of one rank, pixels that differ by more are at most
# so many in a hundred.
as_on_one() {
  local file=$1 look=$2 ranks=$4 ghosts=${5%:*} one options
  one=$folder/one-${file%.*}${look:+-lit}.png
  read -ra options <<<"--size 300x200 --samples 4 $look"
  [ -s "$one" ] || render "$folder/$file" -o "$one" "${options[@]}" || fail "$file, 1"
  render "$folder/$file" -o "$folder/lit.png" "${options[@]}" --ranks $ranks --ghosts $ghosts || fail "$file, $ranks"
  oiiotool --fail $3 --failpercent "${5#*:}" --hardfail 1 --diff "$one" "$folder/lit.png" >"$folder/diff" || {
    cat "$folder/diff"
    fail "$file on $ranks ranks, ghosts $ghosts: another picture $look"
  }
}

for pair in copper-scratch.dump.gz:0 swirl.1.vtu:16; do # edges of clouds differ a little
  data=${pair%:*}
  for ranks in 1 2 4; do
    render "$root/data/$data" -o "$folder/$ranks.png" --size 300x200 --ranks $ranks || fail "$data, $ranks"
    [ -s "$folder/$ranks.png" ] || fail "no picture of $data from $ranks ranks"
  done
  for ranks in 2 4; do
    alike "$folder/1.png" "$folder/$ranks.png" "${pair#*:}"
  done
  echo "ok      $data: two and four ranks make the picture of one"
done
# Each side has a picture of its own.
printf '2\n\nA 0 0 0\nB 0 9 3\n' >"$folder/row.xyz"
for view in +x -x +y -y +z -z iso iso-y; do
  render "$folder/row.xyz" -o "$folder/row$view.png" --size 90x60 --color-by type --view $view || fail "--view $view"
done
[ "$(md5sum "$folder"/row*.png | cut -c1-32 | sort -u | wc -l)" = 8 ] ||
  fail "pictures from different sides are the same"
refused "invalid choice: 'q'" "$folder/row.xyz" -o "$folder/q.png" --view q
echo "ok      sides to look from"
# Light, lines and rays: particles of ranks know those beside them, or all. Shadows go farther.
awk 'BEGIN { srand(3); print 20000 "\n"; for (i = 0; i < 20000; ++i) print "A", 10 * rand(), 6 * rand(), 4 * rand() }' >"$folder/random.xyz"
all='--shadows --ambient-occlusion --silhouettes'
for ranks in 2 4; do
  for ghosts in 0:0.1 inf:0.01; do
    as_on_one random.xyz '' 0.02 $ranks $ghosts
    as_on_one random.xyz "$all" 0.02 $ranks $ghosts
  done
done
echo "ok      light, lines and rays: two and four ranks make the picture of one"
# The same of polygons: 40 spheres, in a file that the first rank reads.
awk 'BEGIN {
  srand(5); rows = 12; columns = 24
  for (s = 0; s < 40; ++s) {
    x = 10 * rand(); y = 6 * rand(); z = 4 * rand(); r = 0.5 + 0.4 * rand()
    for (i = 0; i <= rows; ++i)
      for (j = 0; j < columns; ++j) {
        a = 3.14159265 * i / rows; b = 2 * 3.14159265 * j / columns
        print "v", x + r * sin(a) * cos(b), y + r * sin(a) * sin(b), z + r * cos(a)
      }
    for (i = 0; i < rows; ++i)
      for (j = 0; j < columns; ++j) {
        p = s * (rows + 1) * columns + i * columns + 1
        print "f", p + j, p + columns + j, p + columns + (j + 1) % columns, p + (j + 1) % columns
      }
  }
}' >"$folder/balls.obj"
as_on_one balls.obj '' 0.1 2 0:0.5
for ranks in 2 4; do
  for ghosts in 0:0.5 inf:0.02; do
    as_on_one balls.obj "$all" 0.1 $ranks $ghosts
  done
done
echo "ok      light, lines and rays of polygons: two and four ranks make the picture of one"
# Pieces hold what the file had, each once, in boxes.
for ranks in 1 2 4; do
  "$root/scripts/paraview" convert "$folder/random.xyz" -o "$folder/pieces$ranks.pvtp" --ranks $ranks >"$folder/out" 2>&1 ||
    fail "convert, $ranks: $(tail -3 "$folder/out")"
  grep -qF 'pvtp: 20,000 particles' "$folder/out" || fail "convert, $ranks: $(tail -1 "$folder/out")"
  [ "$(ls "$folder/pieces$ranks" | wc -l)" = $ranks ] || fail "pieces: $(ls "$folder/pieces$ranks")"
done
render "$folder/random.xyz" -o "$folder/whole.png" --size 300x200 || fail 'random.xyz'
for ranks in 1 2; do
  render "$folder/pieces4.pvtp" -o "$folder/pieces.png" --size 300x200 --ranks $ranks || fail "pieces4.pvtp, $ranks"
  alike "$folder/whole.png" "$folder/pieces.png" 1
done
"$root/scripts/paraview" convert "$root/data/copper-scratch.dump.gz" -o "$folder/late.pvtp" --step 5 --ranks 2 >"$folder/out" 2>&1 ||
  fail "convert --step: $(tail -3 "$folder/out")"
render "$root/data/copper-scratch.dump.gz" -o "$folder/whole.png" --size 300x200 --step 5 || fail 'step 5'
render "$folder/late.pvtp" -o "$folder/pieces.png" --size 300x200 || fail 'late.pvtp'
alike "$folder/whole.png" "$folder/pieces.png" 1
echo 'ok      one, two and four ranks write pieces, which are drawn as the whole'
act=convert refused 'ends in .pvtp' "$folder/random.xyz" -o "$folder/x.vtu" --ranks 2
act=convert refused 'there is no such file' "$folder/no.xyz" -o "$folder/x.pvtp"
act=convert refused 'has steps 1 to 7' "$root/data/copper-scratch.dump.gz" -o "$folder/x.pvtp" --step 8
refused 'there is no such file' "$root/data/nothing.vtu" -o "$folder/x.png"
refused "no array 'nothing'; it has p, U" "$root/data/swirl.1.vtu" -o "$folder/x.png" --color-by nothing
refused 'has steps 1 to 7' "$root/data/copper-scratch.dump.gz" -o "$folder/x.png" --step 9
refused "'large' is no size" "$root/data/swirl.1.vtu" -o "$folder/x.png" --size large
refused 'cannot be shown as volume' "$root/data/copper-scratch.dump.gz" -o "$folder/x.png" --as volume
echo 'all checks held'
