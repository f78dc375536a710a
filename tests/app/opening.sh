#!/usr/bin/env bash
# opening.sh MOTE DATA CASE: one test of how files come into the window, and of a user's first
# minutes in it, on the X server that DISPLAY names.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# dialog_on FOLDER: opens the list of files and goes to a folder, by keys alone.
dialog_on() {
  press ctrl+o
  shown 'active filter'
  xdotool type --window 0 --delay 20 -- "$1"
  xdotool key --window 0 Return
  shown "$2"
}

case $3 in
  start) # without a file the window explains itself and offers demo data, then what was open
    open --size 1000x760
    titled 'nothing open'
    press s c k ctrl+s x p Left space # nothing is there to do this with
    click 'Try: Hopper'
    titled hopper
    has 'hopper.dump.gz'
    picture hopper.png
    is_picture hopper.png 680x760
    press ctrl+z
    titled 'nothing open'
    press ctrl+y
    titled hopper
    quit
    [ "$(ls)" = "$(ls | grep -vE '^Mote|mote-')" ] || fail "something was saved of nothing: $(ls)"
    open --size 1000x760
    click 'Opened last: hopper.dump.gz'
    titled hopper
    picture again.png
    alike hopper.png again.png
    quit
    # Without a panel, too, it neither ends nor draws what is not there.
    folded=--no-panel
    open --size 400x300
    press s r x Tab q
    wait $process || fail "exit code $? without a file"
    ;;

  small) # windows have no list of files, and keep their keys
    open "$data/swirl.0.vtu" --size 1000x760
    shown Undo
    xdotool windowsize --sync "$window" 289 600
    sized small.png 289x600
    press ctrl+o
    has '--size=289x600'
    # So they do where the list, or a field, is open when the window becomes small.
    xdotool windowsize --sync "$window" 1000 760
    shown Undo
    press ctrl+o
    shown filter
    xdotool windowsize --sync "$window" 289 600
    sized small.png 289x600
    has '--size=289x600'
    xdotool windowsize --sync "$window" 1000 760
    shown Cancel # it is still there
    xdotool key --window 0 Escape
    gone Cancel
    quit
    ;;

  dialog) # a plain list, by keys and by the mouse; replaces, adds, is undone
    mkdir -p lists/below lists/empty
    cp "$copper" "$data/hopper.dump.gz" "$data/swirl.0.vtu" "$data/swirl.1.vtu" lists
    for i in a b c; do printf '1\n\nAr 0 0 1\n' >lists/below/atom.$i.xyz; done
    echo words >lists/below/words.unknown
    echo '{"other": 1}' >lists/below/other.json
    open lists/hopper.dump.gz --size 1000x760
    dialog_on "$folder/lists" swirl.*.vtu
    gone words.unknown
    xdotool type --window 0 --delay 20 COPP # of whatever case
    gone swirl.*.vtu
    shown copper-scratch.dump.gz
    xdotool key --window 0 Return
    titled copper-scratch
    has "render [^ ]*lists/copper-scratch.dump.gz "
    # What is no file is made.
    press ctrl+o
    shown Cancel
    xdotool type --window 0 --delay 20 pump:0.001:rotor
    xdotool key --window 0 Return
    titled pump:0.001
    press ctrl+z
    titled copper
    # What was open last is offered.
    dialog_on "$folder/lists" Recent
    click Recent
    click 'recent hopper.dump.gz'
    titled hopper
    press ctrl+z
    titled copper
    # Escape leaves that list, and then the dialog. A letter that no field takes holds nothing up.
    press ctrl+o
    click Recent
    shown 'recent hopper.dump.gz'
    # The dialog lies over all else, the axes too.
    at_rest 330 600 110 55 >/dev/null
    [ "$(python3 "$tests/screen.py" 330 600 110 55 red)" = 0 ] || fail "axes over the dialog"
    press Escape
    gone 'recent hopper.dump.gz'
    over copper-scratch.dump.gz
    xdotool mousedown 1 key --window 0 x mouseup 1
    click Recent
    shown 'recent hopper.dump.gz'
    press Escape
    gone 'recent hopper.dump.gz'
    press Escape
    gone Cancel
    # The list is laid out whole where the click that opens it comes behind many keys.
    press ctrl+o
    shown Recent
    settled
    xdotool key --window 0 --delay 0 s w i r l s w i r l mousemove $(place Recent) click 1
    click 'recent hopper.dump.gz'
    titled hopper
    press ctrl+z
    titled copper
    press ctrl+z
    titled hopper
    # Folders: down, and up again by Backspace to where it was.
    dialog_on "$folder/lists" below/
    xdotool key --window 0 Return
    shown atom.b.xyz
    gone words.unknown
    gone other.json
    xdotool key --window 0 BackSpace
    shown below/
    # Of a path the last part need not be whole.
    xdotool type --window 0 --delay 20 -- "$folder/lists/be"
    shown below/
    gone copper-scratch.dump.gz
    xdotool key --window 0 Return
    shown atom.b.xyz
    xdotool type --window 0 --delay 20 -- "$folder/lists/cop"
    shown copper-scratch.dump.gz
    xdotool key --window 0 Return
    titled copper
    press ctrl+z
    titled hopper
    dialog_on "$folder/lists" below/
    # Two at once by the mouse, in place of what is open.
    click copper-scratch.dump.gz 0.3
    xdotool keydown Control_L
    click swirl.*.vtu 0.3
    xdotool keyup Control_L
    click Open
    titled 'and 1 more'
    has 'copper-scratch.dump.gz [^ ]*swirl.0.vtu [^ ]*swirl.1.vtu'
    press ctrl+z
    titled hopper
    has_no copper
    # One more beside it, by keys; in place of nothing it could not be read, and all stays.
    dialog_on "$folder/lists/below" atom.a.xyz
    xdotool key --window 0 Down ctrl+Return
    titled 'hopper.dump.gz and 1 more'
    has 'hopper.dump.gz [^ ]*atom.b.xyz'
    head -c 20000 "$copper" >lists/below/cut.dump.gz
    dialog_on "$folder/lists/below" cut.dump.gz
    xdotool type --window 0 --delay 20 cut
    gone atom.a.xyz
    xdotool key --window 0 Return
    shown messages
    titled 'hopper.dump.gz and 1 more'
    has 'hopper.dump.gz [^ ]*atom.b.xyz'
    click messages
    shown message
    press ctrl+o
    shown Cancel
    xdotool key --window 0 Escape
    gone Cancel
    quit
    ;;

  sessions) # are opened as files are, and bring their settings
    cp "$data/hopper.dump.gz" "$data/swirl.1.vtu" .
    run 0 "$mote" render hopper.dump.gz -o hopper.png --size 680x760 --samples 2 --show type=2 \
      --color-by v --azimuth 50 --save-session grains.json
    open swirl.1.vtu --size 1000x760 --samples 2
    picture swirl.png
    dialog_on "$folder" grains.json
    xdotool type --window 0 --delay 20 grains
    gone swirl.1.vtu
    xdotool key --window 0 Return
    titled hopper
    has '--show=type=2 '
    picture opened.png
    alike hopper.png opened.png
    press ctrl+z
    titled swirl
    picture again.png
    alike swirl.png again.png
    quit
    # Only changes of a session are asked about, and once.
    open grains.json --size 1000x760 --samples 2
    press x Left
    has '--step=[0-9]'
    quit
    open grains.json --size 1000x760 --samples 2
    press m
    has '--color-map='
    press q e # another key: it is asked anew
    quit_changed
    open grains.json --size 1000x760 --samples 2
    press m ctrl+s
    shown Undo
    for _ in $(seq 100); do [ -s hopper-001.json ] && break; sleep 0.1; done
    quit
    # The view is as large as it was, however wide the panel is.
    open swirl.1.vtu --size 1000x700 --samples 2 --ui-scale 1.3
    press ctrl+s
    for _ in $(seq 100); do [ -s swirl-001.json ] && break; sleep 0.1; done
    has '--size=[0-9]+x700 '
    size=$(command_now | grep -o -- '--size=[0-9x]*')
    quit
    open swirl-001.json
    has "$size "
    quit
    ;;

  drop) # files that are dropped on the window
    open "$copper" --size 700x500
    python3 "$tests/drop_files.py" "$window" "$data/swirl.0.vtu" "$data/swirl.1.vtu" ||
      fail "the window takes no files"
    titled 'swirl.*.vtu'
    press ctrl+z
    titled copper
    quit
    ;;

  hints) # come once, one after the other, and can be put off
    rm -r "$XDG_STATE_HOME"
    open "$copper" --size 1000x760
    click 'Next hint'
    click Later
    gone Later
    quit
    open "$copper" --size 1000x760
    for _ in 1 2 3 4; do click 'Next hint'; done
    shown Done
    click Done
    gone Done
    quit
    open "$copper" --size 1000x760
    shown Undo
    gone 'Next hint'
    quit
    rm -r "$XDG_STATE_HOME"
    open "$copper" --size 1000x760
    click 'No hints'
    gone 'Next hint'
    quit
    open "$copper" --size 1000x760
    shown Undo
    gone 'Next hint'
    quit
    # Who cannot be remembered is shown them again, and nothing else happens.
    rm -r "$XDG_STATE_HOME" && touch "$XDG_STATE_HOME"
    open "$copper" --size 1000x760
    click 'No hints'
    gone 'Next hint'
    quit
    ;;

  messages) # what the terminal is told, the window tells, too
    for q in '' ':q:R:1'; do
      printf '2\nProperties=species:S:1:pos:R:3%s\nA 0 0 0%s\nB 1 1 1%s\n' "$q" "${q:+ 1}" "${q:+ 2}"
    done >some.xyz
    open some.xyz --size 1000x760 --show q=1.5:
    gone messages
    press Left
    shown messages
    click messages
    shown message
    press q
    wait $process || fail "exit code $?"
    said err "no array 'q'"
    ;;

  *)
    fail "no case $3"
    ;;
esac
