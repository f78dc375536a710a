#!/usr/bin/env bash
# asking.sh MOTE DATA CASE: one test of what users ask about what they see: picking, lists of the
# picked, on the X server that DISPLAY names. What is picked is told by the lists that are saved.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

# list NAME: has the window save the list of the picked and calls the file NAME.
list() {
  local file
  press ctrl+e
  for _ in $(seq 300); do
    file=$(ls -- *-001-picked.csv 2>/dev/null | head -1)
    [ -n "$file" ] && break
    sleep 0.05
  done
  [ -n "$file" ] || fail "no list $1 is saved"
  mv -- "$file" "$1"
}

# picked N: so many are picked, within a while.
picked() {
  for _ in $(seq 100); do
    rm -f now.csv
    list now.csv
    [ "$(wc -l <now.csv)" = $(($1 + 1)) ] && return
    sleep 0.1
  done
  fail "$(($(wc -l <now.csv) - 1)) are picked, not $1"
}

# none: nothing is picked.
none() {
  press ctrl+e
  command_now >/dev/null # answered after it
  ls -- *-picked.csv 2>/dev/null && fail "something is picked"
}

# marks: how many pixels of the screen have the colour of marks.
marks() { python3 "$tests/screen.py" 0 0 1000 760 marked; }
# marked COMPARISON: as many pixels are marked, within a while.
marked() {
  for _ in $(seq 100); do
    [ "$(marks)" "$1" "$2" ] && return
    sleep 0.1
  done
  fail "$(marks) pixels are marked, not $1 $2"
}

# at X Y: the mouse goes there and rests.
at() { xdotool mousemove "$1" "$2" sleep 0.2; }

case $3 in
  click) # picks, with Shift adds and takes away; it is marked, listed, and pictures and sessions have the marks
    open "$copper" --size 1000x760 --color-by none
    picture start.png
    none
    at 640 400
    xdotool click 1
    marked -gt 20
    picked 1
    head -1 now.csv | grep -qx 'index,x,y,z,id,type,c_centro,c_pe' || fail "$(head -1 now.csv)"
    first=$(tail -1 now.csv)
    shown 'picked list' # the panel's section has opened
    veiled() { python3 "$tests/halves.py" "$1" marks; }
    picture marked.png
    [ "$(veiled start.png)" = '0 0' ] || fail "marks of nothing: $(veiled start.png)"
    read -r marked ruled < <(veiled marked.png)
    [ "$marked" -gt 20 ] && [ "$ruled" = 0 ] || fail "the picture has $marked pixels of a mark, $ruled of a ruler"
    at 560 380
    xdotool keydown Shift_L click 1 keyup Shift_L
    picked 2
    grep -qxF "$first" now.csv || fail "the first is gone"
    picture two.png
    read -r marked ruled < <(veiled two.png)
    [ "$marked" -gt 40 ] && [ "$ruled" -gt 50 ] || fail "the picture has $marked pixels of marks, $ruled of a ruler"
    has '--picked=[0-9]+,[0-9]+ '
    eval "$(command_now | sed -e "s|^mote|$mote|" -e 's|-o [^ ]*|-o head.png|')" >said
    alike two.png head.png
    press ctrl+s
    for _ in $(seq 100); do
      [ -s copper-scratch-001.json ] && break
      sleep 0.1
    done
    run 0 "$mote" render copper-scratch-001.json -o session.png
    alike two.png session.png
    at 640 400
    xdotool keydown Shift_L click 1 keyup Shift_L
    picked 1
    grep -qxF "$first" now.csv && fail "the first stays"
    press P # adds by the keyboard; p picks one
    picked 2
    press p
    picked 1
    [ "$(tail -1 now.csv)" = "$first" ] || fail "another is picked by the key"
    # What is dragged picks nothing, and what is picked stays so at other times.
    xdotool mousemove 640 400 mousedown 1 mousemove 680 400 sleep 0.1 mousemove 720 410 mouseup 1
    picked 1
    [ "$(tail -1 now.csv)" = "$first" ] || fail "dragging picks"
    press Left
    sleep 0.5
    picked 1
    [ "$(cut -d , -f 5 <(tail -1 now.csv))" = "$(echo "$first" | cut -d , -f 5)" ] ||
      fail "another one is picked at another time: $(tail -1 now.csv)"
    press Escape
    marked -eq 0
    none
    quit
    ;;

  rectangle) # picks what is seen in it, or all; the picked are hidden, and shown alone
    open "$copper" --size 1000x760
    click 'group Selection' 0.8 # which leaves room for the list
    picture start.png
    rectangle 1 600 300 700 400
    marked -gt 3000
    list seen.csv
    seen=$(wc -l <seen.csv)
    [ "$seen" -gt 50 ] || fail "$seen are seen in the rectangle"
    rectangle 3 600 300 700 400
    list all.csv
    [ "$(wc -l <all.csv)" -gt $((3 * seen)) ] || fail "$(wc -l <all.csv) in all, $seen seen"
    # All that are seen in the middle are among those that are there.
    rectangle 1 620 320 680 380
    list inner.csv
    [ "$(sort inner.csv all.csv | uniq -d | wc -l)" = "$(wc -l <inner.csv)" ] ||
      fail "some that are seen are not there"
    click 'picks through' 0.05
    rectangle 1 600 300 700 400
    list through.csv
    cmp all.csv through.csv || fail "the box and the button differ"
    click 'picks through' 0.05
    xdotool keydown Shift_L
    rectangle 1 500 350 520 370
    xdotool keyup Shift_L
    list more.csv
    [ "$(wc -l <more.csv)" -gt "$(wc -l <all.csv)" ] || fail "Shift does not add"
    rectangle 1 600 300 700 400
    click 'Hide picked'
    has '--hide-ids=[0-9,:]*'
    marked -eq 0
    picture hidden.png
    differ start.png hidden.png
    rectangle 1 600 300 700 400
    list behind.csv
    [ "$(sort behind.csv seen.csv | uniq -d | wc -l)" = 1 ] || fail "what is hidden is picked"
    press u
    has_no '--hide-ids'
    press Escape
    picture again.png
    alike start.png again.png
    rectangle 1 600 300 700 400
    list seen.csv
    press i
    has '--only-ids=[0-9,:]*'
    picture only.png
    differ start.png only.png
    press ctrl+s
    for _ in $(seq 100); do
      [ -s copper-scratch-001.json ] && break
      sleep 0.1
    done
    "$mote" render copper-scratch-001.json -o session.png --size 680x760 >said 2>&1 ||
      { cat said; fail "no picture of the session"; }
    alike only.png session.png
    click Undo
    has_no '--only-ids'
    press Escape
    picture undone.png
    alike start.png undone.png
    quit_changed
    ;;

  cells) # of volumes and of meshes are picked
    open "$data/swirl.1.vtu" --size 1000x760
    at 660 380
    xdotool click 1
    picked 1
    head -1 now.csv | grep -q '^cell,x,y,z,.*U' || fail "$(head -1 now.csv)"
    marked -gt 20
    shown 'picked list'
    cell=$(tail -1 now.csv | cut -d, -f1)
    head -1 now.csv | grep -q '^cell,x,y,z,nearest point,' || fail "no point: $(head -1 now.csv)"
    press i
    has "--only-ids=$cell"
    has "--picked=$cell"
    shown '1 of 8,547 cells shown'
    marked -gt 20
    press u
    has_no '--only-ids'
    shown '8,547 of 8,547 cells shown'
    press Delete
    has "--hide-ids=$cell"
    shown '8,546 of 8,547 cells shown'
    marked -eq 0
    press u
    at 340 40
    xdotool click 1
    none
    # A rectangle takes the cells that are seen in it, or with the right button all.
    rectangle 1 620 350 700 410
    list seen.csv
    [ "$(wc -l <seen.csv)" -gt 5 ] || fail "$(wc -l <seen.csv) lines of cells in a rectangle"
    head -1 seen.csv | grep -q '^cell,' || fail "$(head -1 seen.csv)"
    rectangle 3 620 350 700 410
    list all.csv
    [ "$(wc -l <all.csv)" -gt $((2 * $(wc -l <seen.csv))) ] || fail "hardly more cells with those behind: $(wc -l <all.csv)"
    quit
    printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n' >flat.ply
    printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >>flat.ply
    open flat.ply --size 1000x760 --view +z
    at 620 420
    xdotool click 1
    picked 1
    head -1 now.csv | grep -q '^cell,' || fail "$(head -1 now.csv)"
    marked -gt 5
    press Escape
    rectangle 3 340 40 980 740
    picked 1
    quit
    # Walls and slices of a volume have cells, too, and what is told of them makes sense.
    open pump:0.001:rotor --size 1000x800
    for x in 500 560 620 680 740; do
      xdotool mousemove $x 400 sleep 0.7 click 1 sleep 0.1
    done
    shown 'picked list'
    quit
    ;;

  copy) # puts the list into the clipboard
    python3 -c 'import tkinter' 2>/dev/null || { echo "no tkinter: not tested"; exit 0; }
    open "$copper" --size 1000x760
    rectangle 1 600 300 700 400
    list seen.csv
    press ctrl+c
    paste() {
      python3 -c 'import tkinter; print(tkinter.Tk().clipboard_get(), end="")' 2>/dev/null
    }
    for _ in $(seq 50); do
      paste >pasted
      [ -s pasted ] && break
      sleep 0.2
    done
    tr '\t' , <pasted | cmp - seen.csv || fail "another list is in the clipboard"
    quit
    ;;

  ruler) # tells distance and angle of two and three picked, by the nearest image where the box is periodic
    ruled() { python3 "$tests/screen.py" 330 140 500 600 ruled; }
    # told NAME VALUE: the panel tells this number, within a while.
    told() {
      for _ in $(seq 100); do
        awk -v name="$1" -v value="$2" '$1 == name && $2 + 0 >= 0.9999 * value && $2 + 0 <= 1.0001 * value {
          found = 1 } END { exit !found }' "$MOTE_CONTROLS" && return
        sleep 0.05
      done
      grep "^$1" "$MOTE_CONTROLS"
      fail "no $1 of $2 is told"
    }
    open "$copper" --size 1000x860 --color-by none
    none
    at 640 440
    press p
    [ "$(ruled)" = 0 ] || fail "a ruler between one and nothing"
    at 560 420
    press P
    picked 2
    mv now.csv two.csv
    told distance "$(awk -F , 'NR > 1 { for (i = 2; i < 5; i++) d[NR] = (d[NR] == "" ? "" : d[NR] " ") $i }
      END { split(d[2], a, " "); split(d[3], b, " ")
        for (i = 1; i < 4; i++) s += (a[i] - b[i]) ^ 2
        print sqrt(s) }' two.csv)"
    for _ in $(seq 100); do
      [ "$(ruled)" -gt 100 ] && break
      sleep 0.1
    done
    [ "$(ruled)" -gt 100 ] || fail "no ruler is drawn"
    at 600 380
    press P
    picked 3
    told angle "$(awk -F , 'NR > 1 { for (i = 1; i < 4; i++) p[NR - 1, i] = $(i + 1) }
      END { for (i = 1; i < 4; i++) {
          a = p[1, i] - p[2, i]; b = p[3, i] - p[2, i]
          ab += a * b; aa += a * a; bb += b * b }
        c = ab / sqrt(aa * bb); print atan2(sqrt(1 - c * c), c) * 180 / 3.14159265358979 }' now.csv)"
    press Escape
    gone 'picked list'
    [ "$(ruled)" = 0 ] || fail "the ruler stays"
    quit
    printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 10\n0 10\n0 10\n' >two.dump
    printf 'ITEM: ATOMS id type x y z\n1 1 0.5 5 5\n2 1 9.25 5 5\n' >>two.dump
    open two.dump --size 1000x860 --view +z
    rectangle 3 330 150 990 800
    picked 2
    told distance 1.25
    shown 'distance 1.25 to the nearest image'
    quit
    ;;

  widths) # of the list's columns are those of their texts, without any input after the pick
    open "$copper" --size 1000x860
    click 'group Colour' 0.8
    click 'group Selection' 0.8
    xdotool mousemove 640 400
    press p
    shown 'picked list'
    settled
    read -r left top < <(place 'picked list' 0 0)
    read -r right bottom < <(place 'picked list' 1 1)
    at_rest "$left" "$top" $((right - left)) $((bottom - top)) >first
    python3 "$tests/screen.py" "$left" "$top" $((right - left)) 40 save list.png
    [ "$(python3 "$tests/drawn.py" list.png 150 $((right - left - 20)) 0 39 light)" -gt 100 ] ||
      fail "the columns are too narrow for their texts"
    xdotool mousemove 700 800 sleep 0.2 mousemove 640 400
    at_rest "$left" "$top" $((right - left)) $((bottom - top)) >second
    cmp first second || fail "the list is laid out anew by the next input"
    quit
    ;;

  plot) # of values: a histogram or a scatter plot, in which ranges are dragged
    open "$copper" --size 1000x1000 --color-by c_centro
    # What the panel draws without a frame of the view is on the screen, too.
    panel_now() { python3 "$tests/screen.py" 0 200 310 400; }
    click 'group Colour' 0.8
    before=$(at_rest 0 200 310 400)
    click 'group Selection' 0.8
    for _ in $(seq 50); do
      [ "$(panel_now)" != "$before" ] && break
      sleep 0.1
    done
    [ "$(panel_now)" != "$before" ] || fail "a section that is folded stays on the screen"
    click 'group Plot' 0.8
    picture all.png
    drag plot 0.1 0.2 0.3 0.5
    has '--show=c_centro=[0-9.]+:[0-9.]+ '
    has_no '--show=[^ ]*[0-9]{10}' # digits that nobody dragged
    picture some.png
    differ all.png some.png
    click 'plot visible' 0.1
    click 'plot log' 0.1
    click 'Show all of these'
    has_no '--show'
    picture again.png
    alike all.png again.png
    waits_for() { # FILE that the panel writes
      for _ in $(seq 100); do
        [ -e "$1" ] && return
        sleep 0.1
      done
      fail "there is no $1"
    }
    click 'Save counts'
    waits_for copper-scratch-001-plot.csv
    [ "$(head -1 copper-scratch-001-plot.csv)" = 'c_centro from,c_centro to,count' ] || fail "$(head -1 copper-scratch-001-plot.csv)"
    click 'plot y'
    click z
    gone z
    click 'Save plot'
    waits_for copper-scratch-001-plot.png
    is_picture copper-scratch-001-plot.png 1280x800
    over plot 0.2 0.9
    xdotool mousedown 1
    shown 'active plot'
    xdotool mousemove $(place plot 0.3 0.7) sleep 0.1 mousemove $(place plot 0.7 0.2) sleep 0.1 mouseup 1
    gone 'active plot'
    has '--show=c_centro=[0-9.]+:[0-9.]+ --show=z=[-0-9.]+:[0-9.]+ '
    picture both.png
    differ all.png both.png
    press ctrl+z
    has_no '--show'
    picture undone.png
    alike all.png undone.png
    drag plot 0.2 0.4 0.7 # along x alone: z is left as it is
    has '--show=c_centro=[0-9.]+:[0-9.]+ '
    has_no '--show=z'
    picture flat.png
    differ all.png flat.png
    press ctrl+z
    picture undone.png
    alike all.png undone.png
    # The ranges come up above the plot; what is pressed in it stays under the mouse.
    click 'group Selection' 0.8
    over plot 0.2 0.5
    read -r x y < <(place plot 0.2 0.5)
    xdotool mousedown 1
    shown 'active plot'
    for i in 1 2 3 4 5 6; do xdotool mousemove $((x + 20 * i)) $((y + 2 * i)) sleep 0.2; done
    xdotool mouseup 1
    gone 'active plot'
    has '--show=z=[-0-9.]+:[0-9.]+ '
    command_now | sed 's/.*--show=z=\([-0-9.]*\):\([0-9.]*\) .*/\1 \2/' |
      awk '{ exit !($2 > $1 && $2 - $1 < 0.15 * 39.77) }' || fail "the plot went away: $(command_now)"
    quit
    ;;

  usual) # what colours is plotted over time, though the first steps lack it
    { for time in 0 5; do
        printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n' $time
        printf '0 20\n0 20\n0 20\nITEM: ATOMS id type x y z\n7 1 10 10 10\n'
      done
      for time in 10 15; do
        printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n' $time
        printf '0 20\n0 20\n0 20\nITEM: ATOMS id type x y z heat\n7 1 10 10 10 %s\n' $time
      done; } >warm.dump
    open warm.dump --size 900x1000 --radius 3 --view +x --color-by heat --step last
    xdotool mousemove 600 500
    press p
    shown 'picked list'
    click 'group Colour' 0.8
    click 'group Selection' 0.8
    click 'Plot over time'
    shown '10 to 15, t = 0 to 15'
    quit
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
