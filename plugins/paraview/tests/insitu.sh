#!/usr/bin/env bash
# insitu.sh: the simulation of ../insitu has Catalyst make its pictures.
root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../..
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "FAILED  $*" >&2
  exit 1
}
"$root/scripts/paraview" batch "$root/plugins/paraview/insitu/simulation.py" 100 "$folder" >"$folder/out" 2>&1 ||
  { cat "$folder/out"; fail "the simulation"; }
[ "$(ls "$folder"/*.png | wc -l)" = 2 ] || { cat "$folder/out"; fail "not two pictures: $(ls "$folder")"; }
for step in 000000 000100; do
  # Balls of several colours over one ground.
  oiiotool --stats "$folder/balls_$step.png" | awk '/Stats StdDev/ { exit !($3 > 5 && $4 > 5 && $5 > 5) }' ||
    fail "balls_$step.png shows nothing"
done
cmp -s "$folder/balls_000000.png" "$folder/balls_000100.png" && fail "nothing has moved"
echo "ok      a simulation's pictures are made while it runs"
echo 'all checks held'
