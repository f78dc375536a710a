#!/usr/bin/env bash
# cli.sh MOTE DATA CASE: one test of the command line. None of them may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
copper=$data/copper-scratch.dump.gz

case $3 in
  help)
    run 0 "$mote" --help
    said out --color-by
    said out .dump
    said out render
    run 0 "$mote" render --help
    said out --all-steps
    run 0 "$mote" --version
    ;;

  render) # a good picture of any file without one option
    for file in "$data"/*.dump.gz; do
      run 0 "$mote" render "$file" -o picture.png
      is_picture picture.png 1280x960
      said out "picture.png: 1280x960"
      [ ! -s err ] || { cat err; fail "something on standard error"; }
    done
    ;;

  formats)
    run 0 "$mote" render "$hopper" -o a.png --size 320x200
    is_picture a.png 320x200
    run 0 "$mote" render "$hopper" -o a.jpg --size 320x200
    run 0 "$mote" render "$hopper" -o a.tif --size 320x200
    run 0 "$mote" render "$hopper" -o a.exr --size 320x200
    for options in '--structure coherent-grid' '--structure pkd-tree --form 8-byte' \
      '--structure pkd-paper' '--form 4-byte'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render "$copper" -o structure.png --size 320x200 $options
      is_picture structure.png 320x200
    done
    [ "$(head -c 4 a.exr | od -A n -t x1 | tr -d ' ')" = 762f3101 ] || fail "a.exr is no EXR"
    for view in auto iso iso-y +x -x +y -y +z -z; do
      run 0 "$mote" render "$hopper" -o view.png --size 320x200 --view "$view"
    done
    run 0 "$mote" render "$hopper" -o b.png --size 320x200 --color-by none --radius spacing \
      --radius-scale 0.5 --orthographic --zoom 2 --azimuth 30 --elevation 10 --no-legend \
      --background '#ffffff,navy' --caption '' --threads 1 --samples 4
    cmp -s a.png b.png && fail "options changed nothing"
    ;;

  shown) # what a range leaves is counted; nothing left is worth a warning
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show-by id --show-range 1 10
    said out '10 of 5,518 particles shown'
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --show-by id --show-range -2 -1
    said out '0 of 5,518 particles shown'
    one_sentence
    ;;

  light) # every light and shadow is another picture
    before=
    for light in '' '--shadows hard' '--shadows soft' '--shadows soft --light-size 40' \
      '--shadows 3 --light right-top' '--light eye' '--light 60,20' '--light 0,0,1 --shadows hard' \
      '--light -1,0,1' '--ambient-occlusion 2' '--ambient-occlusion 2 --occlusion-reach 1' \
      '--ambient-occlusion 2 --shadows soft' --path-trace '--path-trace --light-size 40'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render "$hopper" -o "light.png" --size 320x200 --samples 4 $light
      is_picture light.png 320x200
      sum=$(md5sum <light.png)
      case $before in *"$sum"*) fail "no other picture with $light" ;; esac
      before="$before $sum"
    done
    ;;

  silhouettes) # every option of them is another picture; an EXR has them in a layer of their own
    before=
    for lines in '' '--silhouettes' '--silhouettes=2' '--silhouettes --silhouette-thickness 3' \
      '--silhouettes --silhouette-color white' '--silhouettes --silhouette-groups particle' \
      '--silhouettes=1e9 --silhouette-groups type' '--silhouettes=3%' --silhouette-on-pixels \
      '--silhouettes=2 --silhouette-thickness 1:4' '--silhouettes=2 --silhouette-opacity 0.2' \
      '--silhouettes=2 --silhouette-no-hulls' '--silhouettes=0 --silhouette-step-pixels 9'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render $lines "$hopper" -o lines.png --size 320x200 --samples 4
      is_picture lines.png 320x200
      sum=$(md5sum <lines.png)
      case $before in *"$sum"*) fail "no other picture with $lines" ;; esac
      before="$before $sum"
    done
    run 0 "$mote" render "$hopper" -o off.png --size 320x200 --samples 4 --silhouettes=off \
      --silhouette-thickness 3
    sum=$(md5sum <off.png)
    case $before in " $sum"*) ;; *) fail "lines that are off" ;; esac
    run 0 "$mote" render "$hopper" -o a.exr --size 320x200 --samples 1 --silhouettes
    grep -qa silhouettes a.exr || fail "no silhouettes in a.exr"
    run 0 "$mote" render "$hopper" -o b.exr --size 320x200 --samples 1
    grep -qa silhouettes b.exr && fail "silhouettes in b.exr, which nobody asked for"
    run 1 "$mote" render "$hopper" -o a.png --size 320x200 --silhouettes --silhouette-groups nothing
    one_sentence
    said err nothing
    for wrong in --silhouettes=thick --silhouettes=-1 '--silhouette-thickness 0' \
      '--silhouette-thickness 4:1' '--silhouette-color noone'; do
      # shellcheck disable=SC2086
      run 2 "$mote" render "$hopper" -o a.png $wrong
      one_sentence
    done
    ;;

  noise) # rays are cast until the noise is low; an EXR then tells the variance
    run 0 "$mote" render "$hopper" -o a.png --size 320x200 --noise 0.02
    said out ' samples per pixel, noise 0.01'
    coarse=$(sed 's/.*, \([0-9]*\) samples per pixel.*/\1/' out)
    run 0 "$mote" render "$hopper" -o b.exr --size 320x200 --noise 0.01
    fine=$(sed 's/.*, \([0-9]*\) samples per pixel.*/\1/' out)
    [ "$fine" -gt "$coarse" ] || fail "$fine rays for less noise than with $coarse"
    grep -qa variance b.exr || fail "no variance in b.exr"
    run 0 "$mote" render "$hopper" -o c.exr --size 320x200 --noise 0.001 --samples 5
    said out ', 5 samples per pixel, noise 0.0'
    run 0 "$mote" render "$hopper" -o c.exr --size 320x200
    said out ', 16 samples per pixel'
    grep -qa variance c.exr && fail "variance in c.exr, which nobody asked for"
    true
    ;;

  vanishing) # an array that one step lacks is told once; the range holds again later
    frame() { # STEP COLUMNS ROWS...
      printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n%s\n' "$1" "$(($# - 2))"
      printf 'ITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n0 4\nITEM: ATOMS %s\n' "$2"
      shift 2
      printf '%s\n' "$@"
    }
    {
      frame 0 'id type x y z c_pe' '1 1 1 1 1 5' '2 1 2 2 2 6' '3 1 3 3 3 7'
      frame 1 'id type x y z' '1 1 1 1 1' '2 1 2 2 2'
      frame 2 'id type x y z c_pe' '1 1 1 1 1 6' '2 1 2 2 2 8'
      frame 3 'id type x y z' '1 1 1 1 1' '2 1 2 2 2'
      frame 4 'id type x y z c_pe' '1 1 1 1 1 6' '2 1 2 2 2 7' '3 1 3 3 3 8' '4 1 3 1 3 9'
    } >film.dump
    run 0 "$mote" render film.dump -o a.png --size 320x200 --all-steps --show c_pe=6:8
    [ "$(wc -l <err)" = 2 ] || { cat err; fail 'a step without the array is not told once'; }
    said err "no array 'c_pe', so it is shown without that range"
    said err "no array 'c_pe', so it is shown in one colour"
    for line in '2 of 3 particles shown' '2 particles;' '2 particles;' '2 particles;' \
      '3 of 4 particles shown'; do
      said out "$line"
    done
    run 1 "$mote" render film.dump -o a.png --size 320x200 --step 2 --show c_pe=6:8
    one_sentence
    ;;

  allsteps) # a file of each time step, and its maps
    run 0 "$mote" convert "$hopper" heap.mote --all-steps
    steps=$(ls heap.*.mote | wc -l)
    [ "$steps" -gt 1 ] && [ -e heap.0001.mote ] && [ ! -e heap.mote ] || fail "$(ls)"
    [ "$(wc -l <out)" = "$steps" ] || fail 'not a line for each file'
    run 0 "$mote" info "$hopper"
    grep 'time steps' out >dump.times
    run 0 "$mote" info heap.*.mote
    grep 'time steps' out >files.times
    cmp -s dump.times files.times || { cat dump.times files.times; fail 'other times'; }
    run 0 "$mote" bake heap.*.mote --all-steps --side 1 --samples 9
    [ "$(ls heap.0001.mote.*.moteao | wc -l)" = "$steps" ] || fail "$(ls)"
    run 0 "$mote" render heap.*.mote --step 2 --ambient-occlusion baked -o baked.png --size 320x200
    [ ! -s err ] || { cat err; fail 'the maps are not used'; }
    run 0 "$mote" bake heap.*.mote --all-steps --side 1 --samples 9 # as it was
    [ "$(grep -c 'as it was' out)" = "$steps" ] || { cat out; fail 'baked again'; }
    run 0 "$mote" bake heap.0001.mote heap.0002.mote -o maps.moteao --all-steps --side 1 --samples 9
    [ -e maps.0001.moteao ] && [ -e maps.0002.moteao ] && [ ! -e maps.moteao ] || fail "$(ls)"
    run 2 "$mote" bake "$hopper" --all-steps --step 2
    # The first step of a pour has no particle.
    { printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n'
      printf 'ITEM: ATOMS id type x y z\n'
      printf 'ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n'
      printf 'ITEM: ATOMS id type x y z\n1 1 1 1 1\n2 1 2 2 2\n'; } >pour.dump
    run 0 "$mote" bake pour.dump --all-steps --side 1 --samples 9
    said out 'no particle'
    [ ! -e pour.dump.1.moteao ] && [ -e pour.dump.2.moteao ] || fail "$(ls)"
    run 0 "$mote" convert pour.dump pour.mote --all-steps
    said out 'no particle'
    ;;

  boxes) # that LAMMPS and LIGGGHTS write beside their .vtk files
    for step in 1 2; do
      printf '# vtk DataFile Version 2.0\nparticles\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 1 1\n' >run$step.vtk
      printf '# vtk DataFile Version 2.0\nbox\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 2 2 2\nX_COORDINATES 2 float\n-1 2
Y_COORDINATES 2 float\n0 %s\nZ_COORDINATES 2 float\n0 1\n' $((step + 2)) >run${step}_boundingBox.vtk
    done
    run 0 "$mote" info run*.vtk --step 1
    said out 'box         origin (-1, 0, 0), vectors (3, 0, 0) (0, 3, 0) (0, 0, 1)'
    run 0 "$mote" info run*.vtk
    said out 'vectors (3, 0, 0) (0, 4, 0) (0, 0, 1)'
    ! grep -q hexahedra out || fail "the box is data"
    run 0 "$mote" info run2.vtk
    said out 'vectors (3, 0, 0) (0, 4, 0) (0, 0, 1)'
    run 0 "$mote" info run2_boundingBox.vtk
    said out '1 hexahedra'
    # A tilted one, of LAMMPS; a damaged one is none.
    printf '# vtk DataFile Version 2.0\nbox\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float
0 0 0 4 0 0 5 3 0 1 3 0 0.5 0 2 4.5 0 2 5.5 3 2 1.5 3 2\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n' >run2_boundingBox.vtk
    run 0 "$mote" info run2.vtk
    said out 'box         origin (0, 0, 0), vectors (4, 0, 0) (1, 3, 0) (0.5, 0, 2)'
    echo nothing >run2_boundingBox.vtk
    run 0 "$mote" info run2.vtk
    ! grep -q '  box ' out || fail "there is a box of a damaged file"
    ;;

  series) # two files that differ in a number are two steps of one series
    zcat "$hopper" >part.1.dump
    zcat "$hopper" >part.2.dump
    run 0 "$mote" info part.1.dump part.2.dump
    said out 'part.*.dump'
    run 0 "$mote" info "$data"/swirl.0.vtu "$data"/swirl.1.vtu # as do files of VTK
    said out 'time steps  2: 7.5, 8'
    run 0 "$mote" render "$data"/swirl.?.vtu -o s.png --size 320x200 --all-steps --color-by p
    cmp -s s.0001.png s.0002.png && fail "both steps look alike"
    is_picture s.0002.png 320x200
    run 0 "$mote" render "$data"/swirl.?.vtu -o t.png --size 320x200 --time 7.9 --color-by p
    is_picture t.png 320x200
    head -c 90000 "$data"/swirl.0.vtu >cut.1.vtu
    cp "$data"/swirl.0.vtu cut.0.vtu
    run 1 "$mote" render cut.0.vtu cut.1.vtu -o c.png --all-steps
    one_sentence
    said err cut.1.vtu
    ;;

  steps)
    run 0 "$mote" render "$copper" -o last.png --size 320x200 --caption ''
    run 0 "$mote" render "$copper" -o first.png --size 320x200 --caption '' --step first
    cmp -s last.png first.png && fail "first and last step look alike"
    # No value is none, and not the word behind it.
    run 0 "$mote" render "$copper" -o empty.png --caption= --size 320x200
    alike last.png empty.png
    run 0 "$mote" render "$copper" --caption= -o empty.png --size=320x200
    alike last.png empty.png
    run 2 "$mote" render "$copper" -o empty.png --samples= --size 320x200
    said err samples
    run 0 "$mote" render "$copper" -o all.png --size 320x200 --all-steps
    [ ! -e all.0000.png ] && [ -e all.0001.png ] && [ -e all.0002.png ] || fail "no numbered pictures"
    [ "$(wc -l <out)" = "$(ls all.*.png | wc -l)" ] || fail "not a line for every picture"
    run 1 "$mote" render "$copper" -o a.png --step 1000
    one_sentence
    ;;

  info)
    run 0 "$mote" info "$copper" "$hopper"
    said out c_centro
    said out 'time steps'
    said out bounds
    said out spacing
    said out hopper.dump.gz
    ;;

  volume) # cells are seen as clouds and surfaces
    run 0 "$mote" render pump:0.002 -o a.png --size 320x240 --samples 1
    is_picture a.png 320x240
    grep -q ' cells; read in' out || fail "no word about the cells"
    [ ! -s err ] || { cat err; fail "something on standard error"; }
    for options in '--integrator cell-by-cell --tolerance 0.01' '--integrator inverse-distance' \
      '--sample-distance 0.02' '--cell-structure cartgrid --cloud-tolerance 0' '--lit' \
      '--opacity 0%=0,100%=0.5' '--opacity-unit 0.5' '--iso 120000' '--iso 0,120000 --cloud off' \
      '--color-by velocity:magnitude' '--show pressure=100000:' '--time 0.01' '--nan-color red'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render pump:0.002 -o b.png --size 320x240 --samples 1 $options
      is_picture b.png 320x240
    done
    run 0 "$mote" render pump:0.002 -o b.exr --size 64x48 --samples 1 --iso 120000 --cloud off
    run 0 "$mote" render "$data/swirl.0.vtu" -o b.png --size 320x240 --samples 1
    is_picture b.png 320x240
    run 0 "$mote" render "$data/swirl.0.vtu" "$hopper" -o b.png --size 320x240 --samples 1
    is_picture b.png 320x240
    run 0 "$mote" render "$hopper" "$data/swirl.0.vtu" -o b.png --size 320x240 --samples 1
    said err 'swirl.0.vtu is not shown: its volume has no v magnitude'
    run 0 "$mote" render pump:0.002 -o b.png --size 320x240 --samples 1 --show x=0:1 --show velocity:0=0:1
    said out ' of 12,944 cells shown'
    run 1 "$mote" render pump:0.002 -o c.png --show radius=0:1
    one_sentence
    run 0 "$mote" render pump:0.002 -o b.png --size 320x240 --samples 1 --color-by none
    said out triangles
    run 1 "$mote" render pump:0.002 -o c.png --color-by speed
    said err "no array 'speed'"
    run 0 "$mote" render pump:0.002 -o b.png --size 320x240 --samples 1 --cells surface
    is_picture b.png 320x240
    said out triangles
    run 1 "$mote" render pump:0.002 -o c.png --cells volume --color-by none
    one_sentence
    for wrong in '--opacity 5' '--opacity 5=2' '--opacity-unit 0' '--iso x' '--cells soup' \
      '--integrator best' '--cloud-tolerance 2' '--nan-color soup'; do
      # shellcheck disable=SC2086
      run 2 "$mote" render pump:0.002 -o c.png $wrong
    done
    [ ! -e c.png ] || fail "a picture in spite of errors"
    # A step without the array is left out, with a word, and the next one has it again.
    sed 's/Name="p"/Name="q"/' "$data/swirl.0.vtu" >step.1.vtu
    cp "$data/swirl.0.vtu" step.0.vtu
    cp "$data/swirl.1.vtu" step.2.vtu
    run 0 "$mote" render step.0.vtu step.1.vtu step.2.vtu --all-steps --color-by p -o step.png \
      --size 160x120 --samples 1
    one_sentence
    said err "no array 'p'"
    [ -e step.0003.png ] || fail "no third step"
    ;;

  pump) # a mesh that is made stands where a file may
    run 0 "$mote" info pump:0.0005
    for text in 'pump:0.0005: inlet' 'pump:0.0005: rotor' 'pump:0.0005: diffuser' '80: 0, 0.0005' \
      pressure velocity '429 hexahedra' 'scaled Jacobian 0.82' 'bad cells   none' \
      'mean by volume'; do
      said out "$text"
    done
    run 0 "$mote" info pump:0.0005:rotor --time 0.01
    said out 't = 0.01'
    grep -q inlet out && fail "more parts than were asked for"
    for wrong in pump:x pump:99 pump:0.01:blade; do
      run 1 "$mote" info "$wrong"
      one_sentence
      said err "$wrong: "
    done
    ;;

  average) # over circles: tables, pictures, and sentences
    run 0 "$mote" average pump:0.001 --array pressure --resolution 30
    [ "$(head -n 1 out)" = axial,radial,volume,pressure,pressure_deviation ] || fail "other columns"
    [ "$(wc -l <out)" -gt 100 ] || fail "hardly a row"
    # All of the volume is there.
    run 0 "$mote" average "$data/swirl.1.vtu" -a U -o u.csv
    awk -F, 'NR > 1 { v += $3 } END { exit !(v > 0.00013395 && v < 0.00013397) }' u.csv ||
      fail "the volume is another than that of the cells"
    run 0 "$mote" average "$data/swirl.1.vtu" -a U --axis 0,0,2 --origin 0,0,1 -o v.csv
    [ "$(wc -l <u.csv)" = "$(wc -l <v.csv)" ] || fail "the same axis gives other bins"
    awk -F, 'NR == 2 { exit !($1 > -1.031 && $1 < -1.029) }' v.csv || fail "the origin is not used"
    run 0 "$mote" average "$data/swirl.1.vtu" -a U -c U_circumferential -m plasma -o u.png
    is_picture u.png 1280x480
    # Axes with numbers: left of the bins, below them; titles follow the letters' size.
    [ "$(python3 "$tests/drawn.py" u.png 0 130 100 400)" -gt 100 ] || fail "no numbers left of the average"
    [ "$(python3 "$tests/drawn.py" u.png 200 900 370 430)" -gt 100 ] || fail "no numbers below the average"
    run 0 "$mote" average "$data/swirl.1.vtu" -a p --font-scale 2 -o large.png
    is_picture large.png 1280x480
    cmp -s large.png u.png && fail "letters have one size"
    # Arrays are named as elsewhere; ranges take a part, of which the picture is narrow.
    run 0 "$mote" average "$data/swirl.1.vtu" -a U:2 -o c.csv
    [ "$(head -n 1 c.csv)" = axial,radial,volume,U:2,U:2_deviation ] || fail "other columns of a component"
    cut -d, -f 4 u.csv | tail -n +2 >axial.txt # U_axial is U:2 about z
    cut -d, -f 4 c.csv | tail -n +2 | cmp - axial.txt || fail "a component has other averages"
    run 0 "$mote" average "$data/swirl.1.vtu" -a point:U -o w.csv
    cmp u.csv w.csv || fail "point:U is not U"
    run 1 "$mote" average "$data/swirl.1.vtu" -a cell:U
    run 0 "$mote" average "$data/swirl.1.vtu" -a p --radial-range 0.01 0.02 --axial-range 0 9 -o part.csv
    awk -F, 'NR > 1 && ($1 < 0 || $2 < 0.01 || $2 > 0.0205) { exit 1 }' part.csv || fail "bins outside the ranges"
    [ "$(wc -l <part.csv)" -gt 100 ] || fail "hardly a bin in the ranges"
    run 0 "$mote" average "$data/swirl.1.vtu" -a p --axial-range 0 0.01 -o tall.png
    [ "$(png_size tall.png | cut -dx -f 1)" -lt 900 ] || fail "a tall picture is wide"
    run 2 "$mote" average "$data/swirl.1.vtu" -a p --radial-range 2 1
    run 1 "$mote" average "$data/swirl.1.vtu" -a nothing
    one_sentence
    said err 'it has p, U'
    run 1 "$mote" average "$data/swirl.1.vtu" -a U -c nothing -o a.png
    one_sentence
    # Of several steps a picture shows the mean.
    for steps in swirl.0 swirl.1; do run 0 "$mote" average "$data/$steps.vtu" -a p --range -1 1 -o $steps.svg; done
    run 0 "$mote" average "$data/swirl.0.vtu" "$data/swirl.1.vtu" -a p --range -1 1 --all-steps -o mean.svg
    said mean.svg 'mean of 2 time steps'
    for steps in swirl.0 swirl.1; do ! cmp -s mean.svg $steps.svg || fail "the mean is that of $steps"; done
    run 1 "$mote" average "$data/swirl.1.vtu" -a p -o a.gif
    one_sentence
    run 1 "$mote" average "$data/swirl.1.vtu" -a p -o no/folder/a.csv
    one_sentence
    run 1 "$mote" average "$hopper" -a radius
    one_sentence
    run 2 "$mote" average "$data/swirl.1.vtu"
    run 2 "$mote" average "$data/swirl.1.vtu" -a p --axis 1,2
    ;;

  probe) # values along a line
    run 0 "$mote" probe "$data/swirl.1.vtu" --from 0,0,-0.02 --to 0,0,0.08 --points 11
    [ "$(head -n 1 out)" = distance,x,y,z,part,U:0,U:1,U:2,p ] || fail "other columns"
    [ "$(wc -l <out)" = 12 ] || fail "not a row for every point"
    # The jet in the narrow pipe, and water that flows back behind it.
    awk -F, 'NR == 3 { exit !($8 > 0.05) }' out || fail "no jet"
    awk -F, 'NR > 7 && $8 < 0 { back = 1 } END { exit !back }' out || fail "nothing flows back"
    run 0 "$mote" probe pump:0.002 --from 0,0,-0.2 --to 0,0,-0.1 --points 21 -o line.csv
    grep -q '^0,0,0,-0.2,,nan,nan,nan,nan$' line.csv || fail "something outside of the pump"
    grep -q 'pump:0.002: inlet,' line.csv || fail "nothing inside of the inlet"
    # Many points take another search, which knows hexahedra and their kin alone: triangles are found as well.
    printf '%s\n' '# vtk DataFile Version 3.0' t ASCII 'DATASET UNSTRUCTURED_GRID' 'POINTS 3 double' '0 0 0 1 0 0 0 1 0' \
      'CELLS 1 4' '3 0 1 2' 'CELL_TYPES 1' 5 >triangle.vtk
    run 0 "$mote" probe triangle.vtk --from 0,0.1,0 --to 1,0.1,0 --points 11 -o triangle.csv
    [ "$(grep -c 'triangle.vtk' triangle.csv)" -ge 9 ] || fail "a triangle is not found"
    run 0 "$mote" probe "$data/swirl.1.vtu" --from 0,0,-0.02 --to 0,0,0.08 -c U:2 -o jet.png
    is_picture jet.png 1280x800
    run 0 "$mote" probe "$data/swirl.1.vtu" --from 0,0,-0.02 --to 0,0,0.08 -c U -o speed.png
    cmp -s jet.png speed.png && fail "a component and the magnitude look alike"
    [ "$(python3 "$tests/drawn.py" jet.png 0 130 100 600)" -gt 100 ] || fail "no numbers beside the values"
    run 1 "$mote" probe "$data/swirl.1.vtu" --from 0,0,0 --to 0,0,0.1 -c nothing -o a.png
    one_sentence
    said err 'p, U'
    run 1 "$mote" probe "$data/swirl.1.vtu" --from 0,0,0 --to 0,0,0 -o a.png
    one_sentence
    run 1 "$mote" probe pump:0.002 --from 0,0,5 --to 0,0,6
    one_sentence
    run 1 "$mote" probe pump:0.002 --from 0,0,-0.2 --to 0,0,-0.1 -o no/folder/a.csv
    one_sentence
    run 2 "$mote" probe pump:0.002 --from 0,0,5
    run 2 "$mote" probe pump:0.002 --from 0,0,x --to 0,0,6
    ;;

  json)
    run 0 "$mote" info --json "$copper" "$hopper"
    if command -v python3 >/dev/null; then
      python3 -c 'import json; d = json.load(open("out")); assert len(d) == 2 and d[0]["points"] > 0
assert any(a["name"] == "c_centro" for a in d[0]["arrays"])' || fail "not the right JSON"
    fi
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
