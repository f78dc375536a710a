#!/usr/bin/env bash
# questions.sh MOTE DATA CASE: questions of docs/guide/pump-questions.md, answered in the window, on the
# X server that DISPLAY names. Each has the answer that its command has.
tests=$(cd "$(dirname "$0")" && pwd)
source "$tests/tasks_common.sh"
swirl=$data/swirl.1.vtu

case $3 in
  vortices) # of one array, in the colours of another
    begin 'Colour Selection Volume' "$swirl" --color-by U
    section Colour
    write calculate 'Q=q_criterion(U)'
    has "'--calculate=Q=q_criterion\(U\)'"
    section Volume
    write iso-array Q
    has '--iso-array=Q'
    click 'Add isosurface'
    has '--iso=[-0-9.]+'
    changed
    before=$(on_screen)
    write iso 5
    has '--iso=5 '
    until_other "$before"
    has '--color-by=U'
    quit
    ;;

  sector) # as the whole wheel, in the colours of the pressure
    begin 'Colour Selection Volume' pump:0.02:rotor
    section Slices
    write repeat-around 3
    has '--repeat-around=3'
    changed
    write wall-color data
    has '--wall-color=data'
    changed
    click edges 0.1
    has '--edges=[0-9.]+'
    changed
    quit
    ;;

  *)
    fail "no case $3"
    ;;
esac
