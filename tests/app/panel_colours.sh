#!/usr/bin/env bash
# panel_colours.sh MOTE DATA CASE: one test of the panel's colours and opacities, on the X server that DISPLAY
# names; see panel.sh.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/panel_common.sh"

case $3 in
  colours) # components and maps are chosen from lists; the range is that of what is shown
    {
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n64\nITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n'
      echo 'ITEM: ATOMS id type x y z vx vy vz'
      for i in $(seq 0 63); do
        echo "$i $((1 + i % 2)) $((i % 4)) $((i / 4 % 4)) $((i / 16)) $((i * i)) $((-2 * i)) 0"
      done
    } >flow.dump
    open flow.dump --color-by v --size 1000x860
    click component
    click 'v: vy'
    has '--color-by=v:1 '
    picture forth.png
    click color-map
    click 'plasma reversed'
    has '--color-map=plasma .*--reverse'
    picture back.png
    differ forth.png back.png
    click color-map
    click 'plasma'
    has_no '--reverse'
    printf '0 0 1\n1 1 0\n' >own.txt
    click color-map
    click 'from a file ...'
    write color-map own.txt
    has '--color-map=own.txt'
    picture own.png
    differ forth.png own.png
    refused color-map missing.txt
    has '--color-map=own.txt'
    # Of what a type, an expression and ids hide, nothing counts.
    click 'type 1' 0.05
    has '--show=type=2'
    click 'Range of what is shown'
    has '--range=-126,-2 '
    write where 'x >= 0 && vx < 3000'
    click 'Range of what is shown'
    has '--range=-106,-2 '
    quit
    open flow.dump --color-by v:1 --hide-ids 0:2,61:63 --size 1000x860
    click 'Range of what is shown'
    has '--range=-120,-6 '
    gone 'Even about 0' # none has the other sign
    quit
    # What is seen, of a slice: less than the whole has, as long as the walls have no values.
    open pump:0.02 --color-by pressure --slice z=0.03 --size 1000x860
    click 'Range of view'
    has '--range='
    seen=$(command_now | grep -o -- '--range=[^ ]*')
    click 'Even about 0'
    has_no "$seen"
    has '--range=-([0-9.e+]+),\1 '
    gone 'Even about 0'
    quit
    ;;

  outliers) # that stretch the range are told, and left out when asked for: the legend says so
    open "$copper" --size 1000x860
    shown outliers
    picture all.png
    click 'Range without outliers'
    has '--percentiles=1,99 '
    gone outliers
    picture most.png
    differ all.png most.png
    write 'range low' 0.5
    has '--range=0.5,[0-9.]+ '
    has_no '--percentiles'
    click 'Range without outliers'
    has '--percentiles=1,99 '
    has_no '--range'
    press Left # another step widens it
    has '--range=[0-9.]+,[0-9.]+ '
    press Right
    click 'Range of all steps'
    has '--range=0,[0-9.]+ '
    has_no '--percentiles'
    click 'Range of the data'
    has_no '--percentiles'
    shown outliers
    click color-by
    click type # no array of types has any
    gone outliers
    gone 'Range without outliers'
    quit
    open "$copper" --size 1000x860 --percentiles 1 99 # as it was asked for
    picture asked.png
    alike most.png asked.png
    quit
    ;;

  typelist) # has a line for each type: its colour, name and radius are chosen there
    {
      printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n56\nITEM: BOX BOUNDS ff ff ff\n0 8\n0 8\n0 2\n'
      echo 'ITEM: ATOMS id type x y z'
      for i in $(seq 0 55); do echo "$i $((1 + i % 14)) $((i % 8)) $((i / 8)) 0"; done
    } >many.dump
    open many.dump --color-by type --size 1000x860 --view +z
    picture start.png
    write 'type 2 name' wall
    has '--type-names=2=wall '
    picture named.png
    differ start.png named.png
    write 'type 14 radius' 0.9
    has '--type-radius=1=0\.[0-9]*,.*14=0.9 '
    picture large.png
    differ named.png large.png
    write 'type 14 radius' 0
    has_no '--type-radius'
    picture small.png
    alike named.png small.png
    click 'type 3 colour'
    sleep 0.5
    read -r x y < <(place 'type 3 colour')
    xdotool mousemove $((x + 40)) $((y + 60)) mousedown 1 mousemove $((x + 60)) $((y + 70)) sleep 0.3 mouseup 1
    press Escape
    settled
    has "'--type-colors=3=#[0-9a-f]{6}' "
    picture painted.png
    differ named.png painted.png
    press Control+s
    for _ in $(seq 100); do ls ./*.json >/dev/null 2>&1 && break; sleep 0.05; done
    grep -A 3 '"type-colors"' ./*.json | grep -q '3=#' || fail "the session has no colour of the type"
    click 'Usual colours'
    has_no '--type-colors'
    picture usual.png
    alike named.png usual.png
    press Control+z
    quit
    ;;

  curve) # of opacities is changed by the keys alone, and as numbers
    open "$data/swirl.1.vtu" --size 1000x860 --opacity 0%=0,100%=0.8
    shown opacity
    picture start.png
    press Tab
    go_to opacity
    press space
    shown 'active opacity'
    xdotool key --window 0 --delay 100 Up Up Right Next Down
    press space
    gone 'active opacity'
    has '--opacity=[^, ]*=0.04,[^, ]*=0.78 '
    press Tab Tab # folded, and back without the keys
    press Tab Tab
    click Rising
    has '--opacity=0%=0,100%=0.8'
    click 'opacity points'
    write 'opacity 1 opacity' 0.3
    has '--opacity=[^, ]*=0.3,[^, ]*=0.8 '
    click 'Add point'
    has '--opacity=[^, ]*=0.3,[^, ]*=0.55,[^, ]*=0.8 '
    click 'forget opacity 2'
    has '--opacity=[^, ]*=0.3,[^, ]*=0.8 '
    picture changed.png
    differ start.png changed.png
    quit
    ;;

  volume) # opacities are drawn, dragged, and chosen
    open "$data/swirl.1.vtu" --size 1000x860
    picture usual.png
    click Rising
    has '--opacity=0%=0,100%=0.8'
    picture rising.png
    differ usual.png rising.png
    height=0.98 drag opacity 0.0 0.1 0.2
    has_no '--opacity=0%'
    over opacity 0.6 0.2
    # However busy the program is: two slow clicks are no double click, and two quick ones are one.
    before=$(inputs)
    kill -STOP $process
    xdotool click --repeat 2 --delay 700 1
    kill -CONT $process
    settled $((before + 4))
    has_no '--opacity=[^, ]*,[^, ]*,'
    xdotool click --repeat 2 --delay 60 1
    has '--opacity=[^, ]*,[^, ]*,[^, ]* '
    click Usual
    has_no '--opacity'
    picture again.png
    alike usual.png again.png
    quit
    ;;

  parts) # of a pump: one alone, its colours, its cells, its files
    open pump:0.002 --color-by pressure --opacity 0%=0.9,100%=0.9 --size 1000x1000
    section=$("$mote" info pump:0.002:rotor | awk '$2 == "pressure"')
    click 'data 1' 0.3
    click 'data 3' 0.3
    has '--hide-part=inlet --hide-part=diffuser'
    click 'Range of what is shown'
    read -r low high < <(sed 's/.*\[\(.*\), \(.*\)\].*/\1 \2/' <<<"$section")
    has "--range=${low:0:4}[.0-9]*,${high:0:4}[.0-9]* " # but for rounding
    click 'Range of the data'
    press r
    xdotool mousemove 700 470 sleep 0.2 click 1
    shown 'picked list'
    shown 'Hide picked'
    press ctrl+e
    for _ in $(seq 100); do
      [ -s pump-0.002-001-picked.csv ] && break
      sleep 0.1
    done
    grep -q '^cell,of,.*pressure' pump-0.002-001-picked.csv || fail "no pressure of the cell"
    quit
    ;;

  *)
    fail "no case $3"
    ;;
esac
