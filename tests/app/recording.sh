#!/usr/bin/env bash
# recording.sh MOTE DATA CASE: one test of what --record writes and --play does, on the X server that
# DISPLAY names.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# ended: the window has played all, within a while.
ended() { untitled '(playing)'; }

# session NAME: has the window save its session and calls the file NAME.
session() {
  local file
  press ctrl+s
  for _ in $(seq 300); do
    file=$(ls -- *-001.json 2>/dev/null | head -1)
    [ -n "$file" ] && break
    sleep 0.1
  done
  [ -n "$file" ] || fail "no session $1"
  mv -- "$file" "$1"
}

# rows FILE: what a recording has, without times and what the window chose of itself.
rows() { sed -e 1d -e 's/"time":[0-9.e-]*,//' "$1" | grep -v '"what":"seen"'; }

# has_row FILE TEXT: within a while, as the program writes it.
has_row() {
  for _ in $(seq 100); do
    grep -qF -- "$2" "$1" && return
    sleep 0.1
  done
  cat "$1"
  fail "$1 has no $2"
}

case $3 in
  again) # all is done again: in the window, by hand and by undo, and without a display
    cp "$copper" .
    open copper-scratch.dump.gz --size 1000x760 --record done.rec
    head -1 done.rec | grep -q '^{"mote-recording":1,"mote":' || fail "$(head -1 done.rec)"
    press m
    click show
    click c_centro
    drag histogram 0.0 0.05 0.1 0.2 0.3
    has_row done.rec '"what":"release"'
    xdotool mousemove 640 400 mousedown 1 mousemove 690 400 sleep 0.1 mousemove 720 430 mouseup 1
    has_row done.rec '"what":"camera"'
    press Left
    has_row done.rec '"what":"change","settings":{"data":{"step":"6"}}'
    xdotool windowsize --sync "$window" 900 700
    has_row done.rec '"size":[900,700]'
    press d Control+z
    has_row done.rec '"action":"undo"'
    xdotool mousemove 500 250 keydown Control_L mousedown 3 sleep 0.1 mousemove 600 400 sleep 0.1 \
      mousemove 720 480 mouseup 3 keyup Control_L
    has_row done.rec '"what":"rectangle"'
    press Delete
    has_row done.rec '"action":"hide-picked"'
    has '--hide-ids'
    press Tab Tab # the first gives the panel the keys
    has_row done.rec '"panel":false'
    # What the pictures and sessions are called is another thing.
    cp done.rec unended.rec
    picture done.png
    session done.json
    quit
    tail -1 done.rec | grep -q '"what":"end"}$' || fail "no end: $(tail -1 done.rec)"
    [ "$(wc -c <done.rec)" -lt 60000 ] || fail "$(wc -c <done.rec) bytes"

    run 0 "$mote" render --play done.rec -o head.png
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    alike done.png head.png

    folded=
    open --play done.rec --play-speed 0 --record again.rec
    ended
    picture again.png
    alike done.png again.png
    session again.json
    cmp done.json again.json || { diff done.json again.json; fail "other settings"; }
    # Undo goes back as it did: the picked are there again, then the time step, the view.
    has '--hide-ids'
    press Control+z
    has_no '--hide-ids'
    has '--step=6 '
    has '--show=c_centro=[0-9]'
    press Control+z
    has '--step=7 '
    press Control+z Control+z
    has_no '--show=c_centro=[2-9]'
    press Control+z Control+z
    has_no '--color-map'
    quit_changed # as the session that was saved has all that was undone
    # What was played is recorded as it was done.
    [ "$(rows again.rec | head -30)" != "" ] || fail "nothing was recorded"
    rows done.rec | sed -e '/save-/,$d' >first
    rows again.rec | head -n "$(wc -l <first)" >second
    diff first second || fail "other rows"
    ;;

  small) # a window that becomes too small for its panel lets go of what was held there
    cp "$copper" .
    open copper-scratch.dump.gz --size 1000x760 --record done.rec
    click show
    click c_centro
    over histogram 0.0
    xdotool mousedown 1
    shown 'active histogram'
    xdotool mousemove $(place histogram 0.1) sleep 0.2 mousemove $(place histogram 0.2)
    has_row done.rec '"what":"drag"'
    xdotool windowsize --sync "$window" 289 700 sleep 0.3 mouseup 1
    has_row done.rec '"what":"release"'
    xdotool windowsize --sync "$window" 280 500
    has_row done.rec '"view":[280,500]'
    session done.json
    quit
    run 0 "$mote" render --play done.rec -o played.png --save-session played.json
    diff <(grep -A11 '"camera": \[' done.json) <(grep -A11 '"camera": \[' played.json) || fail "another camera"
    ;;

  plots) # are chosen again, and what is saved of them is saved again
    cp "$copper" .
    open copper-scratch.dump.gz --size 1000x900 --record plot.rec
    for group in Colour Selection; do click "group $group" 0.8; done
    click 'group Plot' 0.8
    click 'plot x'
    click z
    has_row plot.rec '"plot-x":"z"'
    click 'plot y'
    click c_centro
    click 'plot visible' 0.1
    has_row plot.rec '"plot-of":"visible"'
    click 'Save counts'
    has_row plot.rec '"action":"save-counts"'
    click 'group Plot' 0.8
    xdotool mousemove 640 450 click 1
    shown 'picked list'
    click 'Plot over time'
    has_row plot.rec '"action":"plot-over-time"'
    shown 'over time of'
    click 'Save over time'
    has_row plot.rec '"action":"save-over-time"'
    for file in plot over-time; do mv copper-scratch-001-$file.csv made-$file.csv || fail "no $file"; done
    press Control+z Control+z
    quit
    open --play plot.rec --play-speed 0 --no-panel
    ended
    for file in plot over-time; do alike made-$file.csv copper-scratch-001-$file.csv; done
    quit
    ;;

  steps) # that play are shown as they were, and pauses are kept
    open "$copper" --size 1000x760 --record played.rec --speed 20 --no-loop
    press Home
    has_row played.rec '"step":"1"'
    press space
    has_row played.rec '"what":"pass","settings":{"data":{"step":"7"}}'
    has_row played.rec '"playing":false'
    picture played.png
    quit
    open --play played.rec --play-speed 1
    ended
    picture again.png
    alike played.png again.png
    press Control+z # goes back to where it began to play
    has '--step=1 '
    quit
    run 0 "$mote" render --play played.rec -o head.png
    alike played.png head.png
    # Escape stops; keys wait.
    sed -e 's/"time":[0-9.]*,"what":"end"/"time":1000,"what":"end"/' played.rec >slow.rec
    open --play slow.rec
    titled '(playing)'
    press c
    press Escape
    untitled '(playing)'
    quit
    ;;

  opening) # of files and of nothing is done again
    mkdir other
    cp "$data/swirl.1.vtu" "$data/hopper.dump.gz" .
    open --size 1000x760 --record opened.rec
    press ctrl+o
    shown filter
    xdotool type --window 0 --delay 20 -- "$folder/hopper.dump.gz"
    xdotool key --window 0 Return
    titled hopper
    press g
    has_row opened.rec '"background"'
    picture opened.png
    quit
    open --play opened.rec --play-speed 0
    titled hopper
    ended
    picture again.png
    alike opened.png again.png
    press ctrl+z ctrl+z
    titled 'nothing open'
    quit
    run 0 "$mote" render --play opened.rec -o head.png
    alike opened.png head.png
    # In another folder, with the data beside it.
    mv opened.rec hopper.dump.gz other
    run 0 "$mote" render --play other/opened.rec -o head.png
    alike opened.png head.png
    # With other data, in the place of those that it begins with, and with other settings.
    cp "$copper" .
    open copper-scratch.dump.gz --size 1000x760 --record short.rec
    press m
    has_row short.rec '"color-map":'
    quit
    mv copper-scratch.dump.gz other/moved.dump.gz
    run 1 "$mote" render --play short.rec -o none.png
    one_sentence
    said err 'copper-scratch.dump.gz is not there any more'
    run 0 "$mote" render other/moved.dump.gz --play short.rec -o moved.png --size 320x200
    is_picture moved.png 320x200
    ;;

  panel) # begins, ends and plays by buttons; hidden data, saved views and key frames are in it
    cp "$copper" "$data/hopper.dump.gz" .
    open copper-scratch.dump.gz hopper.dump.gz --size 1000x1000 --samples 1 --color-by none
    click 'group Data' 0.8 # that of two data sets is unfolded by itself: fold it
    click 'group Colour' 0.8
    click 'group Selection' 0.8
    click 'group Recording' 0.8
    press g # what was before
    write record made.rec
    click Record
    shown 'Stop recording'
    has_row made.rec '"mote-recording":1'
    click 'group Recording' 0.8
    click 'group Data' 0.8
    click 'data 2' 0.5
    has_row made.rec '"hide-data":[2]'
    click 'group Data' 0.8
    click 'group Camera' 0.8
    press x
    click saved-view
    xdotool type --window 0 --delay 20 side
    click 'Save view'
    has_row made.rec '"saved-view":["side='
    press z
    has_row made.rec '"view":"+z"'
    click 'go to side'
    click 'group Camera' 0.8
    click 'group Film' 0.8
    click 'Add this view'
    click 'Add this view'
    shown 'key frames: 2'
    click 'Forget the last'
    shown 'key frames: 1'
    has_row made.rec '"action":"forget-key-frame"'
    click 'group Film' 0.8
    click 'group Recording' 0.8
    picture made.png
    click 'Stop recording'
    shown Record
    tail -1 made.rec | grep -q '"what":"end"}$' || fail "no end: $(tail -1 made.rec)"
    # Another one does not take its place.
    write record made.rec
    cp made.rec kept.rec
    click Record
    cmp made.rec kept.rec || fail "a recording is replaced"
    shown Record
    # What was recorded is what is played; what is there is no part of it.
    press g m
    click play-speed
    click 'as fast as it goes'
    click 'Play recording'
    titled '(playing)'
    ended
    picture again.png
    alike made.png again.png
    has '--hide-data=2'
    click 'group Recording' 0.8
    click 'group Film' 0.8
    shown 'key frames: 1' # as at the recording's end
    quit
    open --play made.rec --play-speed 0
    ended
    picture again.png
    alike made.png again.png
    quit
    run 0 "$mote" render --play made.rec -o head.png
    alike made.png head.png
    ;;

  errors) # each is a sentence
    cp "$copper" .
    open copper-scratch.dump.gz --size 1000x760 --record whole.rec
    press m
    has_row whole.rec '"color-map":"plasma"'
    picture whole.png
    quit
    fails() { # TEXT ARGUMENTS...
      local text=$1
      shift
      run 1 "$mote" "$@"
      one_sentence
      said err "$text"
    }
    fails 'there is no such file' --play missing.rec
    : >empty.rec
    fails 'the file is empty' --play empty.rec
    echo words >words.rec
    fails 'is no recording' render --play words.rec -o x.png
    sed -e 's/"mote-recording":1/"mote-recording":7/' whole.rec >later.rec
    fails 'version 7' --play later.rec
    { head -2 whole.rec; echo '{"time":1,"what":"flies"}'; } >flies.rec
    fails 'line 3: flies is nothing that' --play flies.rec
    { head -2 whole.rec; echo '{"time":1,"what":"change","settings":{"colour":{"color-map":7}}}'
      echo '{"time":2,"what":"end"}'; } >wrong.rec
    run 1 "$mote" render --play wrong.rec -o x.png
    { head -1 whole.rec; echo '{"time":1,"what":"change","settings":{"colour":{"colours":7}}}'; } >name.rec
    fails 'line 2: colour/colours is no setting' --play name.rec
    { head -1 whole.rec; echo '{"time":"soon"}'; tail -1 whole.rec; } >time.rec
    fails 'line 2 makes no sense' --play time.rec
    fails 'would be replaced' --play whole.rec --record whole.rec
    fails 'would be replaced' copper-scratch.dump.gz --record copper-scratch.dump.gz
    fails 'Cannot write' copper-scratch.dump.gz --record no/such/folder.rec
    fails 'must not end in .json' copper-scratch.dump.gz --record a.json
    run 0 "$mote" render copper-scratch.dump.gz -o x.png --samples 1 --save-session s.json
    fails 'is a session' s.json --play whole.rec
    # Cut off in the middle of a line: what is there is played, and told.
    end=$(grep -b '"what":"action","action":"save-picture"' whole.rec | head -1 | cut -d : -f 1)
    head -c $((end + 20)) whole.rec >cut.rec
    run 0 "$mote" render --play cut.rec -o cut.png
    said err 'was cut off'
    alike whole.png cut.png
    open --play cut.rec --play-speed 0
    ended
    picture cut.png
    alike whole.png cut.png
    press q
    wait $process || fail "exit code $?"
    said err 'was cut off'
    # What is not as it was is told.
    sed -e 's/"what":"change","settings":{"colour":{"color-map":"plasma"}}/"what":"did","settings":{"colour":{"color-map":"plasma"}}/' \
      whole.rec >stray.rec
    open --play stray.rec --play-speed 0
    ended
    press q
    wait $process || fail "exit code $?"
    said err '1 step led elsewhere'
    # A crash loses nothing.
    open copper-scratch.dump.gz --size 1000x760 --record killed.rec
    press m
    has_row killed.rec '"color-map":"plasma"'
    kill -KILL $process
    wait $process 2>/dev/null
    run 0 "$mote" render --play killed.rec -o x.png --samples 1
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
