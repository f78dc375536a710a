#!/usr/bin/env bash
# meshes.sh MOTE DATA CASE: one test of triangles in pictures. None of them may need a display.
tests=$(realpath "$(dirname "$0")")
source "$tests/common.sh"
unset DISPLAY
hopper=$data/hopper.dump.gz

# draw OUT ARGUMENTS...: a picture, without complaints.
draw() {
  local picture=$1
  shift
  run 0 "$mote" render "$@" -o "$picture" --size 320x240 --samples 4
  [ "$(png_size "$picture")" = 320x240 ] || fail "no picture $picture"
  [ ! -s err ] || { cat err; fail "something on standard error"; }
}

differ() { ! cmp -s "$1" "$2" || fail "$1 and $2 are the same"; }

# vtp FILE POINTS: a tetrahedron as triangles, with values of points and of cells.
vtp() {
  cat >"$1" <<VTP
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="${3:-0}" NumberOfStrips="0" NumberOfPolys="4">
<PointData><DataArray type="Float64" Name="height" format="ascii">0 0.5 1 2</DataArray></PointData>
<CellData><DataArray type="Float64" Name="face" format="ascii">${3:+9 }1 2 3 4</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">$2</DataArray></Points>
<Lines><DataArray type="Int64" Name="connectivity" format="ascii">${3:+0 1}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">${3:+2}</DataArray></Lines>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 2 1 0 1 3 0 3 2 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>
</Piece></PolyData></VTKFile>
VTP
}
corners='0 0 0 1 0 0 0 1 0 0 0 1'

case $3 in
  colours) # by points, by cells, by a coordinate, by none; ranges and maps
    vtp a.vtp "$corners"
    run 0 "$mote" info a.vtp
    said out '4 points, 4 triangles'
    draw points.png a.vtp
    said out '4 triangles'
    draw cells.png a.vtp --color-by face
    draw x.png a.vtp --color-by x
    draw none.png a.vtp --color-by none
    draw plain.png a.vtp --color-by none --plain-color navy
    differ none.png plain.png
    draw unused.png a.vtp --plain-color navy
    cmp -s points.png unused.png || fail "the plain colour is seen where an array colours"
    run 2 "$mote" render a.vtp -o b.png --plain-color soup
    said err soup
    draw map.png a.vtp --color-map plasma
    draw range.png a.vtp --range 0 1
    for other in cells x none map range; do differ points.png $other.png; done
    draw again.png a.vtp --color-by height
    cmp -s points.png again.png || fail "other colours than those chosen of itself"
    run 1 "$mote" render a.vtp -o b.png --color-by nothing
    said err "no array 'nothing'"
    run 0 "$mote" render a.vtp -o b.exr --size 64x48 --samples 1
    vtp line.vtp "$corners" 1
    run 0 "$mote" render line.vtp -o b.png --size 160x120
    said err '1 line or vertex, which has no area'
    said out '4 triangles (1 cannot be drawn)'
    ;;

  hidden) # triangles and cells of volumes, by ranges, expressions and numbers
    vtp a.vtp "$corners"
    draw all.png a.vtp
    draw three.png a.vtp --hide-ids 0
    said out '3 of 4 cells shown, 3 triangles'
    draw where.png a.vtp --where 'face > 1'
    draw faces.png a.vtp --show face=2:
    for other in where faces; do cmp -s three.png $other.png || fail "$other.png shows other triangles"; done
    differ all.png three.png
    # What is left is seen as if it were alone; the picture frames it.
    draw low.png a.vtp --show z=:0.1
    said out '1 of 4 cells shown'
    run 0 "$mote" render a.vtp -o b.png --size 160x120 --show z=5:
    one_sentence
    said err 'leave no cell'
    run 1 "$mote" render a.vtp -o b.png --show nothing=1
    said err "no array 'nothing'; it has x, y, z, and"
    run 1 "$mote" render a.vtp -o b.png --where 'nothing > 1'
    said err nothing
    # Of a volume; its isosurfaces; its walls, with those that come to light.
    for look in '' '--iso 0.02 --cloud off' '--cells surface'; do
      set -- --color-by U --view +y $look # options
      draw whole.png "$data/swirl.1.vtu" "$@"
      draw half.png "$data/swirl.1.vtu" "$@" --show x=0:
      half=$(grep -o '[0-9,]* of 8,547 cells' out)
      [ -n "$half" ] || fail "no count of cells: $(cat out)"
      differ whole.png half.png
      draw same.png "$data/swirl.1.vtu" "$@" --where 'x >= 0'
      said out "$half"
      cmp -s half.png same.png || fail "a range and an expression leave other cells ($look)"
      draw pressure.png "$data/swirl.1.vtu" "$@" --show p=0: --show x=0: --show-by U --show-range 0 0.05
      differ half.png pressure.png
    done
    # Picked cells are marked as in the window, where they are shown.
    draw none.png "$data/swirl.1.vtu" --cells surface --color-by none
    draw picked.png "$data/swirl.1.vtu" --cells surface --color-by none --picked 8500:8546
    differ none.png picked.png
    draw away.png "$data/swirl.1.vtu" --cells surface --color-by none --picked 8500:8546 --hide-ids 8500:8546
    draw left.png "$data/swirl.1.vtu" --cells surface --color-by none --hide-ids 8500:8546
    cmp -s away.png left.png || fail "hidden cells are marked"
    ;;

  formats) # polygons, grids, images: what they are made of is shown
    cat >cube.ply <<'PLY'
ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
PLY
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >a.obj
    {
      echo solid a
      for corner in '1 0 0' '0 1 0' '0 0 1'; do
        echo "facet normal 0 0 0 outer loop vertex 0 0 0 vertex $corner vertex 1 1 1 endloop endfacet"
      done
      echo endsolid
    } | sed 's/ outer loop/\nouter loop/; s/ vertex/\nvertex/g; s/ endloop/\nendloop/; s/ endfacet/\nendfacet/' >a.stl
    printf '%s\n' '# vtk DataFile Version 3.0' strip ASCII 'DATASET POLYDATA' 'POINTS 4 float' \
      '0 0 0 1 0 0 0 1 0 1 1 0' 'TRIANGLE_STRIPS 1 5' '4 0 1 2 3' >a.vtk
    printf '%s\n' '# vtk DataFile Version 3.0' image ASCII 'DATASET STRUCTURED_POINTS' \
      'DIMENSIONS 3 3 3' 'ORIGIN 0 0 0' 'SPACING 1 1 1' 'POINT_DATA 27' 'SCALARS v float' \
      'LOOKUP_TABLE default' "$(seq -s ' ' 27)" >image.vtk
    # Three corners and an index each, in base64.
    corner='AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA'
    cat >a.gltf <<GLTF
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"uri":"data:application/octet-stream;base64,$corner","byteLength":42}],
"bufferViews":[{"buffer":0,"byteLength":36,"target":34962},{"buffer":0,"byteOffset":36,"byteLength":6,"target":34963}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]}
GLTF
    for case in 'cube.ply 12' 'a.obj 4' 'a.stl 3' 'a.vtk 2' 'a.gltf 1'; do
      # shellcheck disable=SC2086
      set -- $case
      draw a.png "$1" --view iso
      said out " $2 triangle"
    done
    draw a.png image.vtk --view iso # a volume
    said out ' 8 cells'
    draw b.png image.vtk --view iso --cells surface
    said out ' 48 triangles'
    differ a.png b.png
    run 0 "$mote" info cube.ply
    said out '8 points, 6 cells'
    draw swirl.png "$data/swirl.0.vtu" --cells surface
    said out triangles
    ;;

  lines) # as tubes, or their points as particles
    two_lines a.vtk
    run 0 "$mote" info a.vtk
    said out '8 points, 2 lines'
    draw tubes.png a.vtk --color-by speed
    said out '2 lines;'
    draw thick.png a.vtk --color-by speed --radius 0.1
    draw again.png a.vtk --color-by speed --radius 0.05 --radius-scale 2
    cmp -s thick.png again.png || fail "a radius and its factor differ"
    draw width.png a.vtk --color-by speed --radius width
    draw points.png a.vtk --color-by speed --lines particles
    said out '8 particles'
    for other in thick width points; do differ tubes.png $other.png; done
    run 1 "$mote" render a.vtk -o b.png --radius nothing
    one_sentence
    said err "has no array 'nothing'"
    # Lines are hidden by their numbers and values.
    draw one.png a.vtk --radius 0.1 --hide-ids 1 --color-by line
    said out '1 of 2 lines shown'
    draw where.png a.vtk --radius 0.1 --where 'line < 2' --color-by line
    cmp -s one.png where.png || fail "a number and an expression leave other lines"
    ;;

  scene) # with particles and volumes, in one light
    vtp a.vtp '-15 -15 20 15 -15 20 0 15 20 0 0 38' # within the hopper's box
    vtp b.vtp '-0.05 -0.05 0.1 0.05 -0.05 0.1 0 0.05 0.1 0 0 0.16' # and by the swirl
    draw alone.png "$hopper"
    draw both.png "$hopper" a.vtp
    said out '5,518 particles, 4 triangles'
    differ alone.png both.png
    draw shadows.png "$hopper" a.vtp --shadows hard
    draw occluded.png "$hopper" a.vtp --ambient-occlusion 8
    draw outlined.png "$hopper" a.vtp --silhouettes
    draw paths.png "$hopper" a.vtp --path-trace
    for other in shadows occluded outlined paths; do differ both.png $other.png; done
    draw volume.png "$data/swirl.0.vtu" b.vtp
    said out 'cells, 4 triangles'
    draw hidden.png "$hopper" a.vtp --hide-data 2
    said out '0 of 4 triangles shown'
    ;;

  lods) # groups of triangles as planes, where some pixels of error are allowed
    draw exact.png sphere:300000
    said out '298,116 triangles'
    draw near.png sphere:300000 --lod-error 0.001
    cmp -s exact.png near.png || fail "a thousandth of a pixel makes another picture"
    draw rough.png sphere:300000 --lod-error 8
    differ exact.png rough.png
    draw shadows.png sphere:300000 --lod-error 8 --shadows hard
    differ rough.png shadows.png
    # no lines along the steps between planes, however small the steps that are asked for
    for error in 0 8; do
      for pixels in 0 30; do
        draw lines-$error-$pixels.png sphere:300000 --lod-error $error --silhouettes \
          --silhouette-step-pixels $pixels
      done
    done
    differ lines-0-0.png lines-0-30.png
    cmp -s lines-8-0.png lines-8-30.png || fail "lines follow the steps between planes"
    differ lines-8-0.png rough.png
    run 2 "$mote" render sphere:300000 -o b.png --lod-error -1
    one_sentence
    run 1 "$mote" render sphere:12 -o b.png
    one_sentence
    said err 'no number of triangles'
    ;;

  file) # .mote files of triangles
    vtp a.vtp "$corners"
    run 0 "$mote" convert a.vtp a.mote
    said out 'a.mote: 4 triangles'
    run 0 "$mote" info a.mote
    said out '4 triangles'
    said out 'cell   vtkOriginalCellIds'
    said out 'point  Normals'
    for colour in height cell:face none; do
      draw of-vtp.png a.vtp --color-by $colour --caption ''
      draw of-mote.png a.mote --color-by $colour --caption ''
      alike of-vtp.png of-mote.png
    done
    run 0 "$mote" convert sphere:300000 sphere.mote
    said out '298,116 triangles'
    for error in 0 4; do
      draw of-sphere.png sphere:300000 --lod-error $error --shadows hard --caption ''
      draw of-mote.png sphere.mote --lod-error $error --shadows hard --caption ''
      alike of-sphere.png of-mote.png
    done
    # a mesh that moves
    vtp move.0.vtp "$corners"
    vtp move.1.vtp '0 0 0 2 0 0 0 1 0 0 0 1'
    run 0 "$mote" convert move.0.vtp move.1.vtp move.mote --all-steps
    run 0 "$mote" render move.0001.mote move.0002.mote --all-steps -o step.png --size 320x240
    differ step.0001.png step.0002.png
    # what cannot be
    head -c 200000 sphere.mote >short.mote
    run 1 "$mote" render short.mote -o b.png
    one_sentence
    said err 'cut short'
    run 1 "$mote" convert a.mote b.mote
    one_sentence
    said err 'can be copied'
    run 1 "$mote" convert "$data/swirl.0.vtu" b.mote
    one_sentence
    said err '1 volume'
    [ ! -e b.mote ] || fail "a file is left"
    ;;

  steps) # points that move
    vtp move.0.vtp "$corners"
    vtp move.1.vtp '0 0 0 2 0 0 0 1 0 0 0 1'
    run 0 "$mote" render move.0.vtp move.1.vtp --all-steps -o step.png --size 320x240
    differ step.0001.png step.0002.png
    run 0 "$mote" animate move.0.vtp move.1.vtp -o frames-%02d.png --size 160x120
    ;;

  real) # models of people's own
    [ -d "$MOTE_SHARED_DATA/triangles" ] || exit 77
    for case in 'bunny.ply 69,451' 'horse.ply 96,966' 'spot.obj 5,856'; do
      # shellcheck disable=SC2086
      set -- $case
      run 0 "$mote" info "$MOTE_SHARED_DATA/triangles/$1"
      said out "$2 triangles"
      draw real.png "$MOTE_SHARED_DATA/triangles/$1"
      is_picture real.png 320x240
      said out "$2 triangles"
    done
    ;;

  *) fail "no case $3" ;;
esac
