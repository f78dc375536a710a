#!/usr/bin/env bash
# bench.sh MOTE-BENCH DATA CASE: one test of the benchmarks, on inputs so small that only what is
# said is tested and not how fast it is.
source "$(dirname "$0")/../app/common.sh"
bench=$mote

# last_is_sentence: what went wrong stands at the end of err, after what was being done.
last_is_sentence() {
  tail -n 1 err | grep -q '^mote-bench: [A-Z"-].*\.$' || { cat err; fail "no sentence at the end"; }
}

# What every record has.
keys="suite method mode input particles view width height threads repeat mrays_per_s mrays_per_s_min
  mrays_per_s_max build_s bytes_per_particle checked_pixels wrong_pixels max_depth_error
  max_depth_error_of_right"

# records FILE CONDITION: the file is a JSON array and the condition holds for `r`, its records.
records() {
  command -v python3 >/dev/null || return 0
  python3 - "$1" "$2" "$keys" <<'END' || fail "records: $2"
import json, sys
r = json.load(open(sys.argv[1]))
missing = {k for record in r for k in sys.argv[3].split() if k not in record}
if missing or not r or not eval("(" + sys.argv[2] + ")", {"r": r, "json": json}):
    print("missing keys:", missing, file=sys.stderr)
    json.dump(r, sys.stderr, indent=1)
    sys.exit(1)
END
}

# Four bytes a particle are not enough to be right to a 10,000th of the depth.
right="all(x['checked_pixels'] == 96 * 80 and (x['wrong_pixels'] <= 1 or x['method'] == 'pkd4') for x in r)"
small=(--size 96x80 --repeat 1)

case $3 in
  help)
    run 0 "$bench" --help
    said out particles
    run 0 "$bench" particles --help
    for word in cgt cgt-reference grid-single embree lattice:N random:N:R varied:N 'cross sections' \
      --tables --lambda --packet shadows; do
      said out "$word"
    done
    run 0 "$bench" occlusion --help
    for word in cgt embree near --rays --size; do
      said out "$word"
    done
    ! grep -q grid-single out || fail "a method that cannot"
    run 0 "$bench" file --help
    ! grep -q -e --methods out || fail "methods that there are not"
    run 0 "$bench" growth --input lattice:3000 --methods pkd --size 96x80 --repeat 1 --json a.json
    records a.json "len(r) == 2 and all(x['seconds'] > 0 and x['making_s'] > 0 for x in r)"
    run 1 "$bench" growth --input random:10:0.1
    last_is_sentence
    run 0 "$bench" build --help
    for word in cgt grid-single embree --threads --lambda; do
      said out "$word"
    done
    ;;

  methods) # every method casts the right picture, on one thread and on two
    for threads in 1 2; do
      run 0 "$bench" particles --input random:4000:0.02 "${small[@]}" --threads $threads \
        --json a.json
      records a.json "$right"
      records a.json "len(r) == 2 * len({x['method'] for x in r}) >= 16"
      records a.json "all(x['threads'] == $threads and x['mrays_per_s'] > 0 for x in r)"
      records a.json "all(x['bytes_per_particle'] > 4 and x['build_s'] > 0 for x in r)"
    done
    run 0 "$bench" particles --input lattice:1000 "${small[@]}" --methods cgt --view near \
      --packet 4 --lambda 2 --json a.json
    records a.json "len(r) == 1 and r[0]['mode'] == 'packet 4x4' and r[0]['view'] == 'near'"
    records a.json "$right"
    ;;

  inputs) # radii over four decades, one particle, a file, and a file with the name of an input
    run 0 "$bench" particles --input varied:3000 "${small[@]}" --json a.json
    records a.json "$right"
    run 0 "$bench" particles --input lattice:1 "${small[@]}" --json a.json
    records a.json "$right"
    run 0 "$bench" particles --input "$data/hopper.dump.gz" "${small[@]}" --json a.json
    records a.json "$right and r[0]['particles'] == 5518"
    zcat "$data/hopper.dump.gz" >varied:5
    run 0 "$bench" particles --input varied:5 "${small[@]}" --methods cgt --json a.json
    records a.json "r[0]['particles'] == 5518"
    ;;

  tables)
    run 0 "$bench" particles --input lattice:700 "${small[@]}" --json a.json \
      --tables packet,reference-grid,culling,culling-speed,range,shadows,methods,radii,build,lambda
    said out 'Size of the bundles of rays: lattice:700, 729 particles'
    said out 'Soft shadows'
    records a.json "{x['table'] for x in r} == {'packet', 'reference-grid', 'culling', 'culling-speed',
      'range', 'shadows', 'methods', 'radii', 'build', 'lambda'}"
    records a.json "all(x['wrong_pixels'] <= 1 or x['method'] == 'pkd4' for x in r)"
    records a.json "all(x['particles_in_cells'] > x['particles_in_frustum'] > x['nearest_hits'] > 0
      for x in r if x['table'] == 'culling')"
    records a.json "all(x['build_again_s'] > 0 for x in r if x['table'] == 'build')"
    records a.json "[x['kept'] for x in r if x['table'] == 'range'][:6:2] == [729, 72, 7]"
    records a.json "all(x['rms_error'] < 0.02 for x in r if x['mode'] == '8x8')"
    run 0 "$bench" particles --input lattice:700 "${small[@]}" --view far --tables lambda
    said out 'Cells a particle'
    ;;

  occlusion) # the same rays whoever casts them, and the reference's answers
    asking() { run 0 "$bench" occlusion "${small[@]}" --json a.json "$@"; }
    answered="all(x['suite'] == 'occlusion' and x['checked_pixels'] == x['rays'] > 3000 and
      (x['wrong_pixels'] <= 1 or x['method'] == 'pkd4') and 0.2 < x['occluded_share'] < 0.8 and x['mrays_per_s'] > 0 for x in r)"
    for threads in 1 2; do
      asking --input random:4000:0.02 --threads $threads
      records a.json "$answered and all(x['threads'] == $threads for x in r)"
      records a.json "{x['method'] + ' ' + x['view'] for x in r} >=
        {'cgt far', 'embree far', 'cgt near', 'embree near'}"
      records a.json "len({(x['rays'], x['occluded_share']) for x in r}) == 2"
      mv a.json $threads.json
    done
    records 1.json "[x['occluded_share'] for x in r] ==
      [x['occluded_share'] for x in json.load(open('2.json'))]"
    asking --input random:4000:0.02 --rays 3 --methods cgt --view far
    records a.json "$answered and len(r) == 1"
    records a.json "r[0]['rays'] == 3 * json.load(open('1.json'))[0]['rays']"
    asking --input varied:20000 # spheres so small that float has few numbers across them
    records a.json "$answered"
    asking --input lattice:1 # rays that leave their own particle alone
    records a.json "all(x['wrong_pixels'] == 0 and x['occluded_share'] == 0 for x in r)"
    ;;

  build) # time and memory, on one thread and on two
    run 0 "$bench" build --input random:200000:0.005 --threads 2 --repeat 1 --json a.json
    said out 'at most'
    records a.json "{(x['method'], x['threads']) for x in r} >= {('cgt', 1), ('embree', 1), ('cgt', 2),
      ('embree', 2), ('cgt-reference', 2), ('grid-single', 1)}"
    records a.json "all(x['suite'] == 'build' and x['particles'] == 200000 for x in r)"
    records a.json "all(x['build_again_s'] > 0 and
      0 < x['build_s_min'] <= x['build_s'] <= x['build_s_max'] for x in r)"
    records a.json "all(x['mrays_per_s'] is None and x['checked_pixels'] == 0 for x in r)"
    records a.json "all(x['bytes_per_particle'] > 4 for x in r)"
    # What is built is held at the end, so the peak is no less; pages and counters are coarse.
    if [ -w /proc/self/clear_refs ]; then
      records a.json "all(0.9 * x['bytes_per_particle'] < x['peak_build_bytes_per_particle'] < 500
        for x in r)"
    fi
    run 0 "$bench" build --input lattice:1000 --threads 1 --repeat 2 --methods cgt --lambda 5 \
      --json a.json
    records a.json "len(r) == 1 and r[0]['method'] == 'cgt' and r[0]['threads'] == 1"
    ;;

  preview) # a preview covers about what the whole does
    run 0 "$bench" preview --input random:300000:0.02 --repeat 1 --json a.json
    said out 'picture after'
    python3 - <<'END' || fail "records"
import json
r = {x['method']: x for x in json.load(open('a.json'))}
assert set(r) == {'preview-250k', 'preview-500k', 'preview-1m', 'preview-2m', 'cgt', 'pkd'}
assert all(x['build_s'] > 0 and x['frame_s'] > 0 and x['before_s'] > 0 for x in r.values())
assert r['cgt']['wrongly_covered_share'] == r['preview-1m']['wrongly_covered_share'] == 0
assert r['pkd']['wrongly_covered_share'] < 1e-4
assert 0 < r['preview-250k']['wrongly_covered_share'] < 0.1
END
    ;;

  silhouettes) # the outline of a lone sphere is as long as it should be
    keys="suite method input particles view size threads repeat step filter_ms frame_ms
      frame_with_silhouettes_ms frame_share covered_share"
    silhouettes() { run 0 "$bench" silhouettes --repeat 1 --json a.json "$@"; }
    silhouettes --input lattice:20000 --sizes 40,96 --threads 2
    said out 'share of it'
    records a.json "{(x['method'], x['view'], x['size']) for x in r} == {(m, v, s) for m in
      ('published', 'default', 'graded') for v in ('far', 'near') for s in (40, 96)}"
    records a.json "all(x['filter_ms'] > 0 and x['frame_ms'] > 0 and x['frame_share'] < 1 and
      0.0005 < x['covered_share'] < 0.7 for x in r)"
    # The sphere's outline is 2.59 sides of the picture long, and 1.5 pixels wide.
    silhouettes --input lattice:1 --sizes 96,200 --view far --methods default
    records a.json "len(r) == 2 and all(abs(x['covered_share'] * x['size'] - 1.5 * 2.59) < 0.2 for x in r)"
    ;;

  ambient) # more rays, more texels and more samples are nearer to the reference
    keys="suite table method input particles view width height threads repeat reach baked
      mode"
    errors="samples mrays_per_s seconds bytes_per_particle bytes_per_baked_particle baked_particles"
    errors+=" rays frame_s frame_without_s rms_error max_error checked_pixels reference_error"
    ambient() {
      run 0 "$bench" ambient --size 64x64 --frame-size 48x32 --reference-rays 256 --repeat 1 \
        --structure pkd-tree --json a.json "$@"
    }
    of="{m: [x for x in r if x['method'] == m and x['table'] == 'errors']
      for m in {x['method'] for x in r}}"
    error() { echo "(lambda e: e('$1', '$2'))(lambda m, v: next(x for x in r if x['table'] == 'errors'
      and x['method'] == m and x['view'] == v)['rms_error'])"; }
    ambient --input lattice:20000 --samples 9 --threads 2 --methods "live-1,live-4,live-16,baked-1x1,$(
      )baked-8x8,baked-8x8-undilated,baked-16x16,baked-adaptive,baked-embree,baked-adaptive-embree"
    said out 'Error against time'
    said out 'Looking up'
    records a.json "all(set('$errors'.split()) <= set(x) and x['width'] == 64 for x in r
      if x['table'] == 'errors')"
    records a.json "(lambda of: len(of) == 10 and all(len({x['view'] for x in v}) == len(v) == 2
      for v in of.values()))($of)"
    records a.json "all(x['particles'] == 19683 and x['baked'] == 'seen' and x['reach'] > 0.1 for x in r)"
    records a.json "all(3000 < x['checked_pixels'] <= 4096 and 0 < x['reference_error'] < 0.02 and
      0 < x['rms_error'] < x['max_error'] <= 1 and x['seconds'] > 0 and x['rays'] > 3000 for x in r
      if x['table'] == 'errors')"
    for view in far near; do
      records a.json "$(error live-1 $view) > 2 * $(error live-4 $view) > 4 * $(error live-16 $view)"
      # The same rays, whoever answers them.
      for kind in 16x16 adaptive; do
        embree=baked-embree
        [ $kind = adaptive ] && embree=baked-adaptive-embree
        records a.json "abs($(error baked-$kind $view) - $(error $embree $view)) < 0.005"
      done
    done
    records a.json "all(x['bytes_per_baked_particle'] == (1 + 64 if '8x8' in x['method'] else 257)
      for x in r if x['table'] == 'errors' and x['method'] in ('baked-8x8', 'baked-16x16', 'baked-embree'))"
    records a.json "{x['method'] for x in r if x['table'] == 'embree'} ==
      {'baked-embree', 'baked-adaptive-embree'}"
    records a.json "all(x['times_embree'] > 0 and x['race_threads'] == 2 for x in r
      if x['table'] == 'embree')"
    records a.json "all(x['frame_cost'] > -1 and (x['width'], x['height']) == (48, 32) for x in r
      if x['table'] == 'look-up') and len([x for x in r if x['table'] == 'look-up']) == 8"
    mv a.json few.json
    ambient --input lattice:20000 --samples 49 --methods baked-16x16 --view far
    records a.json "r[0]['rms_error'] < 0.6 * next(x for x in json.load(open('few.json'))
      if x['method'] == 'baked-16x16')['rms_error']"
    ambient --input lattice:500 --tables tolerance --samples 49 --bake all --view near
    records a.json "len(r) == 7 and all(x['baked_particles'] == x['particles'] for x in r)"
    # The looser, the fewer bytes, and the larger the error.
    records a.json "(lambda b: b == sorted(b, reverse=True) and b[0] == b[1] > 2 * b[-1])(
      [x['bytes_per_particle'] for x in r])"
    records a.json "r[-1]['rms_error'] > 1.5 * r[0]['rms_error']"
    ambient --input lattice:1 --samples 16 # nothing is in the way
    records a.json "all(x['rms_error'] < 1e-6 and x['baked'] == 'all' for x in r if x['table'] == 'errors')"
    records a.json "all(x['baked_particles'] == 1 for x in r if 'baked-' in x['method'] and
      x['table'] == 'errors')"
    ;;

  hexahedra) # the same picture through every structure, and VTK's mappers where there is a display
    keys="suite method integrator input view cells threads width height repeat fps build_s memory_mb
      references max_cells_per_leaf cells_visited nodes_visited step tolerance lambda2 rms_error
      max_error checked_pixels frame_change_s cells_passed us_per_ray nodes levels area leaf_area
      degrees"
    hexahedra() { run 0 "$bench" hexahedra "${small[@]}" --json a.json "$@"; }
    # Of what goes through a structure; the walk goes through none, and has a picture of its own.
    ours="[x for x in r if not x['method'].startswith('vtk') and x['method'] != 'walk']"
    walk="[x for x in r if x['method'] == 'walk']"
    agreeing="(lambda e: max(e) - min(e) < 1e-6)([x['rms_error'] for x in $ours])"
    hexahedra --input pump:0.002:rotor --threads 2
    records a.json "{x['method'] for x in $ours} >= {'cylgrid', 'cartgrid', 'cylbvh', 'cartbvh'}"
    records a.json "all(x['cells'] == 4284 and x['checked_pixels'] >= 20 and x['fps'] > 0 and
      x['build_s'] > 0 and x['memory_mb'] > 0 for x in r)"
    records a.json "all(x['cells_visited'] > 5 and x['nodes_visited'] > 5 and
      x['references'] >= 4284 and x['max_cells_per_leaf'] >= 1 and x['step'] > 0 for x in $ours)"
    records a.json "all(x['cells_visited'] > 5 and x['nodes_visited'] is None and x['fallbacks'] >= 0 and
      0 < x['rms_error'] < 1e-3 and x['rms_error'] <= x['max_error'] for x in $walk)"
    records a.json "$agreeing and all(0 < x['rms_error'] < 0.02 and
      x['rms_error'] <= x['max_error'] for x in $ours)"
    if [ -n "$DISPLAY" ]; then
      records a.json "len(r) == len($ours) + 3 and all(x['rms_error'] < 0.05 and x['references'] is None
        for x in r if x['method'].startswith('vtk'))"
    fi
    mv a.json even.json
    DISPLAY= hexahedra --input pump:0.002:rotor --integrator cell-by-cell --lambda2 1
    said out 'left out'
    records a.json "len(r) == len($ours) + len($walk) == 5 and $agreeing and all(x['rms_error'] < 1e-3 and x['step'] is None for x in r)"
    records a.json "r[0]['lambda2'] == 1 and
      r[0]['references'] < json.load(open('even.json'))[0]['references']"
    hexahedra --input pump:0.001:inlet --methods cylbvh --integrator inverse-distance --step 0.003
    records a.json "len(r) == 1 and r[0]['step'] == 0.003 and 0 < r[0]['rms_error'] < 0.1"
    # Rays alone see what they see in bundles, to the last bit.
    hexahedra --input pump:0.002:rotor --methods cylgrid,cartgrid,cylbvh,cartbvh --single-rays
    records a.json "len(r) == 4 and [(x['rms_error'], x['max_error'], x['checked_pixels']) for x in r] ==
      [(x['rms_error'], x['max_error'], x['checked_pixels'])
        for x in json.load(open('even.json')) if x['method'] in ('cylgrid', 'cartgrid', 'cylbvh', 'cartbvh')]"
    hexahedra --input pump:0.002 --tables sizes,directions
    said out "0.002:rotor: the axis, the input's"
    ! grep -q 'Errors are' out || fail "errors of what is not drawn"
    # Every ray passes the same cells, whatever it goes through.
    records a.json "(lambda of: all(len({x['cells_passed'] for x in r if of(x) == key}) == 1
      for key in {of(x) for x in r}))(lambda x: (x['table'], x['input'], x['degrees']))"
    records a.json "all(x['cells_visited'] >= x['cells_passed'] > 1 and x['nodes_visited'] > 1 and
      x['us_per_ray'] > 0 for x in r)"
    records a.json "len([x for x in r if x['table'] == 'directions']) == 3 * 7 * 4"
    records a.json "len([x for x in r if x['table'] == 'sizes']) == 3 * 2 * 4"
    hexahedra --input pump:0.001 --tables
    for words in 'Two-level grids' Hierarchies 'Leaves per reference' 'distance of samples' \
      'Error against time'; do
      said out "$words"
    done
    records a.json "{x['table'] for x in r} >= {'grids', 'hierarchies', 'sizes', 'directions', 'lambda2', 'step',
      'integrators'}"
    records a.json "len({x['input'] for x in r if x['table'] == 'grids'}) == 3"
    records a.json "all((x['levels'] == 2) == ('grid' in x['method']) and
      x['nodes'] > x['levels'] and (x['area'] is None) == ('grid' in x['method']) and
      x['cells_visited'] >= x['cells_passed'] > 1 for x in r if x['table'] in ('grids', 'hierarchies'))"
    # Finer is better, to where what is drawn is as good as it can be.
    for name in trilinear cell-by-cell; do
      records a.json "(lambda e: e[-1] < 0.1 * e[0])([x['rms_error'] for x in r
        if x['table'] == 'integrators' and x['integrator'] == '$name'])"
    done
    if [ -n "$DISPLAY" ]; then
      said out 'x vtk-raycast'
      records a.json "len({x['input'] for x in r if x['method'] == 'vtk-raycast'}) == 3"
    fi
    for input in pump:0.002 missing.vtu "$data/hopper.dump.gz"; do
      run 1 "$bench" hexahedra --input "$input"
      last_is_sentence
    done
    ;;

  drawn | triangles)
    keys="suite task method mode input poe triangles view width height threads repeat rays fps mrays_per_s
      times_embree times_exact nodes_per_ray clusters_per_ray working_set_mb bytes_per_triangle build_s lod_build_s
      rms_error displacement_999_pixels max_displacement_pixels holes extra differing"
    triangles() { run 0 "$bench" triangles "${small[@]}" --json a.json "$@"; }
    ;;&

  drawn) # as VTK's mapper draws them: the same depths, but for outlines
    triangles --input sphere:20000 --methods rlod,vtk-opengl
    records a.json "len(r) == 10 and {(x['method'], x['task']) for x in r} ==
      {('rlod', t) for t in ('primary', 'occlusion', 'shadow', 'reflection')} | {('vtk-opengl', 'primary')}"
    records a.json "all(x['differing'] <= 0.03 * x['rays'] and x['fps'] > 0 for x in r)"
    ;;

  triangles) # the same picture by every method
    if [ -n "${DISPLAY:-}" ]; then unset DISPLAY; fi # which would add one
    run 1 "$bench" triangles "${small[@]}" --input sphere:20000 --methods vtk-opengl
    last_is_sentence
    triangles --input sphere:20000 --threads 2
    records a.json "len(r) == 52 and {x['method'] for x in r} == {'rlod', 'rlod-plain', 'rlod-sparing', 'rlod-paper', 'rlod-paper-clamped',
      'embree', 'embree-medium'} and
      {(x['task'], x['view']) for x in r} == {(t, v)
      for t in ('primary', 'occlusion', 'shadow', 'reflection') for v in ('far', 'near')}"
    records a.json "all(x['differing'] <= (0.003 if x['task'] == 'reflection' else 0.001) * x['rays'] and x['fps'] > 0 and
      x['build_s'] > 0 and x['rays'] > 500 and abs(x['triangles'] - 20000) < 500 for x in r)"
    records a.json "all((x['nodes_per_ray'] is None) == (not x['method'].startswith('rlod') or
      x['task'] != 'primary') for x in r)"
    records a.json "all((x['bytes_per_triangle'] <= 26) == (x['method'] in ('rlod', 'rlod-plain', 'rlod-sparing')) for x in r)"
    triangles --input sphere:200000 --methods rlod,embree --poe 0,4,16 --view far
    records a.json "len(r) == 16 and {x['poe'] for x in r if x['method'] == 'rlod'} == {0, 4, 16} and
      {x['poe'] for x in r if x['method'] == 'embree'} == {0}"
    records a.json "all(x['holes'] == 0 and x['rms_error'] <= x['displacement_999_pixels'] + 1e-9 and
      x['displacement_999_pixels'] <= x['poe'] and (x['rms_error'] > 0) == (x['poe'] > 0) for x in r if x['task'] == 'primary')"
    for task in occlusion shadow reflection; do # what stands for triangles is a little larger, and not all of it
      records a.json "all(0 < x['differing'] < 0.2 * x['rays'] for x in r if x['task'] == '$task' and x['poe'] == 16)"
    done
    records a.json "all(x['bytes_per_triangle'] <= 30 and x['lod_build_s'] > 0 for x in r if x['method'] == 'rlod')"
    triangles --input sphere:200000 --methods rlod-paper,rlod-paper-clamped --poe 4,16 --view far
    records a.json "all(x['holes'] == 0 for x in r if x['method'] == 'rlod-paper-clamped') and
      sum(x['holes'] for x in r) > 0 and all(x['rms_error'] > 0 for x in r if x['poe'] > 0 and x['task'] == 'primary')"
    records a.json "all(x['differing'] == 0 for x in r if x['task'] == 'occlusion')"
    printf 'v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >four.obj
    triangles --input subdivide:four.obj:1000 --methods rlod --view near
    records a.json "len(r) in (3, 4) and all(x['triangles'] == 1024 and x['times_embree'] is None for x in r)"
    triangles --input four.obj --methods embree,rlod --view far
    records a.json "all(x['triangles'] == 4 and x['differing'] <= 8 for x in r if x['task'] != 'reflection')"
    for input in sphere:5 sphere:many subdivide:four.obj missing.ply "$data/hopper.dump.gz"; do
      run 1 "$bench" triangles --input "$input"
      last_is_sentence
    done
    ;;

  errors)
    failing() {
      run 1 "$bench" particles --repeat 1 "$@"
      last_is_sentence
    }
    failing --input missing.dump
    said err missing.dump
    failing --input lattice:0
    said err 'above zero'
    failing --input lattice:many
    failing --input varied:-5
    failing --input varied:1e3
    failing --input random:10
    failing --input random:10:0
    failing --input random:10:nan
    failing --input lattice:99999999999999
    failing --input lattice:10 --size 0x10
    failing --input lattice:10 --size 10
    run 1 "$bench" ambient --input lattice:10 --frame-size 10
    said err '--frame-size wants'
    failing --input lattice:10 --json nowhere/a.json
    said err nowhere
    for suite in occlusion build preview silhouettes ambient; do
      run 1 "$bench" $suite --input missing.dump
      last_is_sentence
      said err missing.dump
    done
    run 1 "$bench" occlusion --input random:2:1e-9 --size 4x4
    last_is_sentence
    said err 'shows no particle'
    ;;

  usage)
    misused() {
      "$bench" "$@" >out 2>err
      local code=$?
      [ $code -gt 1 ] && [ $code -lt 126 ] || { cat out err; fail "exit code $code: $*"; }
    }
    misused
    misused particles
    said err --input
    misused particles --input lattice:10 --methods none
    misused particles --input lattice:10 --view sideways
    misused particles --input lattice:10 --lambda 9
    misused particles --input lattice:10 --packet 3
    misused particles --tables nothing
    misused particles --input lattice:10 --repeat 0
    misused particles --input lattice:10 --rays 2
    misused occlusion
    said err --input
    misused occlusion --input lattice:10 --methods grid-single
    misused occlusion --input lattice:10 --rays 0
    misused occlusion --input lattice:10 --packet 8
    misused occlusion --input lattice:10 --tables build
    misused build
    said err --input
    misused build --input lattice:10 --methods none
    misused build --input lattice:10 --view far
    misused build --input lattice:10 --size 10x10
    misused silhouettes
    said err --input
    misused silhouettes --input lattice:10 --sizes 0
    misused silhouettes --input lattice:10 --size 10x10
    misused silhouettes --input lattice:10 --methods none
    misused ambient
    said err --input
    misused ambient --input lattice:10 --methods baked-3x3
    misused ambient --input lattice:10 --structure heap
    misused ambient --input lattice:10 --bake some
    misused ambient --tables bytes
    misused ambient --input lattice:10 --reference-rays 0
    misused ambient --input lattice:10 --reach -1
    misused hexahedra
    said err --input
    misused hexahedra --input pump:0.001:inlet --integrator none
    misused hexahedra --input pump:0.001:inlet --lambda 1
    misused hexahedra --input pump:0.001:inlet --step -1
    misused particles --input lattice:10 --step 1
    misused triangles
    said err --input
    misused triangles --input sphere:1000 --lambda 1
    misused triangles --input sphere:1000 --methods cgt
    ;;

  *) fail "no such case: $3" ;;
esac
echo "$3: passed"
