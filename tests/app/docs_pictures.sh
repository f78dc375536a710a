#!/usr/bin/env bash
# docs_pictures.sh MOTE DATA: docs/make makes every picture of the guide but those of the window, and
# docs/pictures has them all and no other.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/common.sh"
docs=$(dirname "$data")/docs
mkdir made
run 0 "$docs/make" --small --into made "$mote"
shown=$(sed -n 's/.*(\(\.\.\/\)\{0,1\}pictures\/\([^)]*\)).*/\2/p' "$docs"/getting-started.md "$docs"/guide/*.md | sort -u)
[ "$shown" = "$(ls "$docs/pictures")" ] || { diff <(echo "$shown") <(ls "$docs/pictures"); fail "pictures and pages differ"; }
for name in $shown; do
  case $name in
    window.jpg | panel.jpg) continue ;; # screens, by docs/make-window
    vessel.png | mixer.png | turbine-*.png) [ -d "$MOTE_SHARED_DATA/hexahedra" ] || continue ;;
  esac
  [ -s "made/$name" ] || fail "docs/make does not make $name"
done
