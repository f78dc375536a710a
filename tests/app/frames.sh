#!/usr/bin/env bash
# frames.sh MOTE DATA CASE: what the window shows is the same on X servers with and without shared
# memory: with it frames are given to the server as images, without it by OpenGL.
tests=$(cd "$(dirname "$0")" && pwd)

if [ "$3" = screen ]; then # on the X server that DISPLAY names: fingerprints of what is on it
  source "$tests/panel_common.sh"
  open "$copper" --size 1000x700 --samples 4
  shown Undo
  press Escape # the greeting goes
  for group in Colour Selection; do
    click "group $group" 0.8 # which leaves room
  done
  click 'group Costs' 0.8
  shown 'quality 4 samples per pixel'
  xdotool mousemove 1279 1023
  at_rest 320 0 680 660 # but for the status line, which tells the time that a frame took
  xdotool windowsize --sync "$window" 900 760
  sized other.png 580x760
  click 'group Costs' 0.8 # of which the panel's part alone is shown anew
  gone 'quality 4 samples per pixel'
  picture sharp.png # the view has its samples by then
  xdotool mousemove 1279 1023
  at_rest 0 0 900 720
  quit
  exit
fi

source "$tests/common.sh"
for memory in + -; do
  server="-screen 0 1280x1024x24 -noreset $([ $memory = + ] || echo -extension MIT-SHM)"
  xvfb-run -a -s "$server" "$tests/frames.sh" "$mote" "$data" screen >"screen$memory" 2>said ||
    { cat said "screen$memory"; fail "no frames"; }
done
[ "$(wc -l <screen+)" = 2 ] && [ "$(sort -u screen+ | wc -l)" = 2 ] || { cat screen+; fail "frames do not change"; }
cmp screen+ screen- || { paste screen+ screen-; fail "frames differ"; }
