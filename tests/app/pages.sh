#!/usr/bin/env bash
# pages.sh MOTE DATA PAGE: the commands of a page of the docs run as printed, what it names are options,
# and its links lead somewhere.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/common.sh"
root=$(dirname "$data")
page=$root/$3
ln -s "$data" data
meshes=$MOTE_SHARED_DATA/hexahedra
if [ -d "$meshes" ]; then
  ln -s "$meshes"/*.vtu .
else
  echo "There is no $meshes: commands with its meshes are left out."
fi

mote() { "$mote" "$@"; }
while read -r command; do
  [[ ! $command =~ \ ([^ ]+\.vtu) || -e ${BASH_REMATCH[1]} || $command == *\** ]] || continue
  # Those that only show how names stand: "mote FILE", "mote --play FILE other.dump".
  [[ ! $command =~ (FILE|run\.|trajectory\.) ]] || continue
  case $command in
    'mote --follow '*) continue ;; # goes on
    data/make-rotor.py*) python3 $command >out || fail "$command"; continue ;;
    'mote '[a-z]*' '* | 'mote data/'* | 'mote lattice:'* | 'mote '*.vtu) ;;
    *) fail "what is '$command'?" ;;
  esac
  # What opens a window makes a picture instead: the same options, the same data.
  [[ $command =~ ^mote\ (render|animate|convert|info|average|integrate|probe|silhouettes|bake|help)\  ]] ||
    command="mote render ${command#mote } -o window.png --size 96x72"
  command=${command/1000000000/1000}
  command=${command/720x540/96x72} # of real meshes: smaller, and soon done
  eval "run 0 $command"
done < <(sed -nE 's,^    ((mote|data/make-rotor.py) .*),\1,p' "$page")

run 0 "$mote" help --format bash # names all options
mv out help
for option in $(sed -n -e '/^    mote /p' -e 's/`\(--[a-z-]*\)/\n    mote \1\n/gp' "$page" |
  sed -n '/^    mote /p' | grep -oE -e ' --[a-z][a-z-]*' | sort -u); do
  grep -qE -e " $option([ \"|)]|$)" help || fail "$3 names $option, which is no option"
done

# A heading's anchor: small letters, without what is no letter, dashes between words.
anchors() { sed -n 's/^#* //p' "$1" | tr '[:upper:]' '[:lower:]' | sed -e 's/[^a-z0-9 -]//g' -e 's/ /-/g'; }
for link in $(grep -oE '\]\([^) ]+\)' "$page" | sed -e 's/^](//' -e 's/)$//' | grep -v '^http'); do
  file=${link%%#*}
  target=$page
  [ -z "$file" ] || target=$(dirname "$page")/$file
  [ -e "$target" ] || fail "$3 leads to $file, which is not there"
  [[ $link != *#* ]] || anchors "$target" | grep -qxF "${link#*#}" || fail "$3: no heading for $link"
done
