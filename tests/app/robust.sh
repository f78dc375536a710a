#!/usr/bin/env bash
# robust.sh MOTE DATA CASE: one test of files and numbers that nobody means well with. None of them
# may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz
small='--size 160x120 --samples 1'

# failing ARGUMENTS...: one sentence and exit code 1.
failing() {
  run 1 "$mote" "$@"
  one_sentence
}

# grid FILE POINT...: eight points, the last of which are given, as the corners of one hexahedron.
grid() {
  local file=$1 id=7
  shift
  [ -z "$ID" ] || id=$ID
  {
    printf '%s\n' '# vtk DataFile Version 3.0' grid ASCII 'DATASET UNSTRUCTURED_GRID' 'POINTS 8 double'
    printf '%s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '0 0 1' '1 0 1' '1 1 1' '0 1 1' | head -n $((8 - $#))
    printf '%s\n' "$@" 'CELLS 1 9' "8 0 1 2 3 4 5 6 $id" 'CELL_TYPES 1' 12 'POINT_DATA 8' \
      'SCALARS p double 1' 'LOOKUP_TABLE default' 1 2 3 4 5 6 7 8
  } >"$file"
}

case $3 in
  unnamed) # columns and arrays without a name
    printf ',x,y,z\n0,0,0,1\n1,1,1,2\n' >a.csv # as pandas writes them
    printf 'x,y,z,\n0,0,1,5\n1,1,2,6\n' >b.csv
    printf 'column2,,x,y,z\n7,0,0,0,1\n8,1,1,1,2\n' >c.csv
    printf '2\nProperties=pos:R:3::R:1\n0 0 0 1\n1 1 1 2\n' >d.xyz
    for file in a.csv b.csv c.csv d.xyz; do
      # shellcheck disable=SC2086
      run 0 "$mote" render $file -o a.png $small
      run 0 "$mote" info $file
      said out column
    done
    run 0 "$mote" info c.csv
    said out 'column2 '
    said out column2_
    # VTK's own reader takes no array without a name.
    for name in '' 'Name=""'; do
      cat >e.vtp <<FILE
<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="2">
<PointData><DataArray type="Float64" $name format="ascii">1 2</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 1 1</DataArray></Points>
</Piece></PolyData></VTKFile>
FILE
      failing info e.vtp
    done
    ;;

  outputs) # what is read is never replaced by chance
    kept() { # FILE ARGUMENTS...
      local file=$1
      shift
      cp "$file" copy
      failing "$@"
      said err 'would be replaced'
      cmp -s "$file" copy || fail "$file is another after: $*"
    }
    # shellcheck disable=SC2086
    run 0 "$mote" render "$hopper" -o e.exr $small
    ln -s e.exr link.exr
    ln e.exr hard.exr
    kept e.exr silhouettes e.exr -o e.exr
    kept e.exr silhouettes e.exr -o ./link.exr
    kept e.exr silhouettes link.exr -o hard.exr
    zcat "$hopper" >dump.png # a LAMMPS dump is known by what it holds
    kept dump.png render dump.png -o "$PWD/dump.png"
    cp dump.png steps.0001.png
    kept steps.0001.png render steps.0001.png -o steps.png --all-steps
    run 0 "$mote" convert "$hopper" a.mote
    kept a.mote convert a.mote a.mote --form 4-byte
    ln -s dump.png maps.moteao
    kept dump.png bake dump.png -o maps.moteao
    cp "$data/swirl.1.vtu" swirl.vtu
    ln -s swirl.vtu table.csv
    kept swirl.vtu average swirl.vtu -a p -o table.csv
    kept swirl.vtu probe swirl.vtu --from 0,0,0 --to 0,0,1 -o table.csv
    ;;

  bake) # maps that are complete stay when baking others is stopped
    run 0 "$mote" bake "$hopper" -o a.moteao --samples 4 --side 4
    cp a.moteao copy
    # A second signal, which timeout sends to its whole group, would end it at once.
    timeout --foreground --preserve-status -s INT 3 "$mote" bake "$hopper" -o a.moteao \
      --samples 400 --side 16 --threads 1 >out 2>err
    code=$?
    [ $code = 130 ] || { cat out err; fail "exit code $code, not 130"; }
    cmp a.moteao copy || fail "a part of new maps in place of all of the old"
    said err 'a.moteao holds other maps, and stays'
    ;;

  cells) # names of points that are not there, grids without coordinates, no space at all
    for ID in 8 999999999 -1; do
      grid bad.vtk
      for command in info 'average -a p' 'probe --from 0,0,0 --to 1,1,1' 'render -o a.png'; do
        # shellcheck disable=SC2086
        failing $command bad.vtk
        said err "bad.vtk: cell 0 names the point $ID, and there are 8 points"
      done
    done
    ID=
    printf '%s\n' '# vtk DataFile Version 3.0' surface ASCII 'DATASET POLYDATA' 'POINTS 3 float' \
      '0 0 0 1 0 0 0 1 0' 'POLYGONS 1 4' '3 0 1 3' >surface.vtk
    failing info surface.vtk
    said err 'names the point 3'
    printf '%s\n' '# vtk DataFile Version 3.0' grid ASCII 'DATASET RECTILINEAR_GRID' 'DIMENSIONS 2 2 2' \
      'X_COORDINATES 2 float' '0 1' 'Y_COORDINATES 2 float' '0 1' >flat.vtk
    for command in info 'average -a p' 'probe --from 0,0,0 --to 1,1,1'; do
      # shellcheck disable=SC2086
      failing $command flat.vtk
      said err '2 x 2 x 2 points'
    done
    grid point.vtk '0 0 0' '0 0 0' '0 0 0' '0 0 0' '0 0 0' '0 0 0' '0 0 0' '0 0 0'
    run 0 "$mote" info point.vtk
    failing average point.vtk -a p
    # What is left out is told of in the picture, but for faces that are listed as cells, too; a
    # polyhedron is drawn.
    printf '%s\n' '# vtk DataFile Version 3.0' mixed ASCII 'DATASET UNSTRUCTURED_GRID' 'POINTS 8 float' \
      '0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1' 'CELLS 3 22' '8 0 1 2 3 4 5 6 7' '3 0 1 2' \
      '8 0 0 0 0 0 0 0 0' 'CELL_TYPES 3' '12 5 12' 'POINT_DATA 8' 'SCALARS p float 1' 'LOOKUP_TABLE default' \
      '0 1 2 3 4 5 6 7' >mixed.vtk
    run 0 "$mote" render mixed.vtk -o a.png --size 160x120 --samples 1
    said out '3 cells (1 cannot be drawn)'
    printf '%s\n' '# vtk DataFile Version 3.0' poly ASCII 'DATASET UNSTRUCTURED_GRID' 'POINTS 6 float' \
      '0 0 0 1 0 0 0 1 0 1 1 0 0.5 0.5 1 0.5 0.5 -1' 'CELLS 1 34' \
      '33 8 3 0 1 4 3 1 3 4 3 3 2 4 3 2 0 4 3 1 0 5 3 3 1 5 3 2 3 5 3 0 2 5' \
      'CELL_TYPES 1' 42 'POINT_DATA 6' 'SCALARS p float 1' 'LOOKUP_TABLE default' '0 1 2 3 4 5' >poly.vtk
    run 0 "$mote" render poly.vtk -o b.png --size 160x120 --samples 1
    said out '1 cell;'
    run 0 "$mote" info poly.vtk
    said out '1 polyhedra'
    ;;

  streams) # pipes and devices in place of files get a sentence at once, whoever names them
    mkfifo pipe
    ended() { # COMMAND...: within a while, with a sentence
      timeout 20 "$@" >out 2>err
      [ $? = 1 ] || { cat out err; fail "no sentence but exit code $?: $*"; }
      one_sentence
      said err 'regular file'
    }
    for ending in dump bin mote xyz pts csv gro cfg h5 pdb vtp vtu vtk ply obj stl gltf case cgns foam json pvd; do
      ln -s /dev/zero "zero.$ending"
      mkfifo "pipe.$ending"
      ended "$mote" info "zero.$ending"
      ended "$mote" render "pipe.$ending" -o a.png
    done
    element() { echo "<VTKFile type=\"$1\" version=\"0.1\"><$2>$3</$2></VTKFile>"; }
    element Collection Collection '<DataSet timestep="0" file="pipe.vtp"/>' >parts.pvd
    element vtkMultiBlockDataSet vtkMultiBlockDataSet '<DataSet index="0" file="pipe.vtp"/>' >parts.vtm
    element PPolyData PPolyData '<Piece Source="pipe.vtp"/>' >parts.pvtp
    printf 'FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: pipe\n' >parts.case
    for file in parts.pvd parts.vtm parts.pvtp parts.case; do ended "$mote" info $file; done
    mkdir -p case/constant/polyMesh case/0
    touch case/a.foam
    for name in points faces owner neighbour boundary; do mkfifo "case/constant/polyMesh/$name"; done
    ended "$mote" info case/a.foam
    ended "$mote" silhouettes pipe.json -o a.png
    ended "$mote" --play pipe
    ;;

  far) # numbers that are too large
    for place in 1e150 1e200 1e300; do
      grid far.vtk "1 1 $place" '0 1 1'
      grid large.vtk "0 0 0" "$place 0 0" "$place $place 0" "0 $place 0" "0 0 $place" \
        "$place 0 $place" "$place $place $place" "0 $place $place"
      for file in far.vtk large.vtk; do
        run 0 "$mote" info $file
        "$mote" average $file -a p --resolution 8 >out 2>err
        grep -e inf -e nan out && fail "no numbers in the average of $file"
        for structure in cylgrid cartgrid cylbvh cartbvh; do
          # shellcheck disable=SC2086
          timeout 60 "$mote" render $file -o a.png $small --cell-structure $structure >out 2>err
          [ $? -le 1 ] || fail "$structure crashes over $file"
        done
      done
      failing average large.vtk -a p --resolution 8
    done
    for x in 1e300 1e30; do
      printf 'x,y,z\n0,0,0\n%s,1,1\n' $x >far.csv
      failing render far.csv -o a.png
      said err "may reach to 1e+18"
    done
    printf 'x,y,z\n100000000000000001,0,0\n100000000000000005,1,1\n' >offset.csv
    failing render offset.csv -o a.png
    said err 'subtract an offset'
    failing render "$hopper" -o a.png --radius 1e308
    said err 'choose other units or --radius'
    # What is large but within reach is drawn.
    printf 'x,y,z\n0,0,0\n1e15,1e14,1e15\n' >large.csv
    # shellcheck disable=SC2086
    run 0 "$mote" render large.csv -o a.png $small
    printf 'x,y,z\n1000000000,0,0\n1000000001,1,1\n' >offset.csv
    # shellcheck disable=SC2086
    run 0 "$mote" render offset.csv -o a.png $small
    ;;

  options) # values that mean nothing, and those that end where a file begins
    for value in nan inf -inf 1e999; do
      run 2 "$mote" render "$data/swirl.1.vtu" -o a.png --iso=$value
      one_sentence
    done
    for radius in nonsense 5 spacing; do
      failing render "$data/swirl.1.vtu" -o a.png --radius $radius
      said err 'holds cells alone'
    done
    failing render "$data/swirl.1.vtu" -o a.png --type-radius 1=2
    run 0 "$mote" probe --points 3 --from 0,0,0 --to 0,0,0.05 "$data/swirl.1.vtu"
    run 0 "$mote" probe --points 3 --from 0 0 0 --to 0 0 0.05 "$data/swirl.1.vtu"
    run 0 "$mote" average -a p --axis 0,0,1 "$data/swirl.1.vtu"
    for option in '--range 0 1' '--show id=1:10' '--show-range 0 1' '--background white' \
      '--background white,navy' '--type-radius 1=0.1,2=0.2'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render -o a.png $small $option "$hopper"
    done
    for option in '--iso 0' '--opacity 0%=0,100%=1'; do
      # shellcheck disable=SC2086
      run 0 "$mote" render -o a.png $small $option "$data/swirl.1.vtu"
    done
    run 2 "$mote" render "$hopper" -o a.png --background white,navy,red
    ;;

  memory) # a picture says what it needs
    failing render "$hopper" -o a.png --size 65536x65536
    said err 'needs about'
    (
      ulimit -v 4000000
      "$mote" render "$hopper" -o a.png --size 20000x20000 --threads 2 >out 2>err
    )
    [ $? = 1 ] || { cat out err; fail "no failure"; }
    one_sentence
    said err 'needs about'
    [ ! -e a.png ] || fail "a picture in spite of an error"
    # Nor does the limit of a control group end it without a word, where this may make one.
    for limit in /sys/fs/cgroup/memory/mote-$$/memory.limit_in_bytes /sys/fs/cgroup/mote-$$/memory.max; do
      ! ldd "$mote" | grep -qE 'lib[at]san' && mkdir "${limit%/*}" 2>/dev/null || continue
      code=skipped
      if [ -e "$limit" ] && echo 1000000000 2>/dev/null >"$limit"; then
        (
          echo "$BASHPID" >"${limit%/*}/cgroup.procs"
          exec "$mote" render lattice:40000000 -o a.png --size 40x30
        ) >out 2>err
        code=$?
      fi
      rmdir "${limit%/*}"
      [ $code != skipped ] || continue
      [ $code = 1 ] || { cat out err; fail "exit code $code in a control group"; }
      one_sentence
      said err 'not enough memory'
    done
    ;;

  ignored) # a shell's background commands are not interrupted
    "$mote" render "$hopper" -o a.png --size 160x120 --samples 4000 >out 2>err & # SIGINT is ignored
    sleep 0.5
    while kill -INT $! 2>/dev/null; do sleep 0.2; done
    wait $! || { cat out err; fail "interrupted"; }
    is_picture a.png 160x120
    ;;

  series) # .mote files that differ in a number are steps
    for step in 1 2; do
      run 0 "$mote" convert "$hopper" "part.$step.mote" --radius 0.$step
    done
    run 0 "$mote" info part.1.mote part.2.mote
    said out 'part.*.mote'
    said out 'time steps  2'
    # shellcheck disable=SC2086
    run 0 "$mote" render part.2.mote part.1.mote -o s.png $small --all-steps
    said out 's.0002.png'
    said out ' 5,518 particles;'
    run 0 "$mote" render part.1.mote part.2.mote -o one.png $small --step 1
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
