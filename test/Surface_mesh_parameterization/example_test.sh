#!/usr/bin/env bash
# Runs an application on its default input and on small ones, and checks laws of what it writes:
# example_test.sh NAME PROGRAM
name=$1
program=$2
source "$(dirname "$0")/run_as_a_user.sh"

# expect_counts FILE V VT F: as many lines of each kind.
expect_counts() {
  local counts
  counts="$(grep -c '^v ' "$1")/$(grep -c '^vt ' "$1")/$(grep -c '^f ' "$1")"
  [ "$counts" = "$2/$3/$4" ] || fail "$1 has $counts lines of v/vt/f instead of $2/$3/$4"
}

holds() { awk "BEGIN { exit !($1) }" || fail "$2: not $1"; }
number_after() { sed "s/.*$1 \([-+.0-9e]*\).*/\1/" stdout; }

# A square of N times N squares, each of two triangles, in a tilted plane.
flat_square() {
  awk -v n="$1" 'BEGIN {
    print "OFF"; print (n + 1)^2, 2 * n^2, 0
    for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i / n, j / n, 0.5 * i / n
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
      a = i * (n + 1) + j; b = a + n + 1
      print 3, a, b, b + 1; print 3, a, b + 1, a + 1
    } }'
}
torus() {
  awk -v n=8 'BEGIN {
    print "OFF"; print n^2, 2 * n^2, 0; turn = 8 * atan2(1, 1) / n
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j)
      print (3 + cos(j * turn)) * cos(i * turn), (3 + cos(j * turn)) * sin(i * turn), sin(j * turn)
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
      k = (i + 1) % n; l = (j + 1) % n
      print 3, i * n + j, k * n + j, k * n + l; print 3, i * n + j, k * n + l, i * n + l
    } }'
}
# The same mesh with a vertex of no face.
with_isolated_vertex() { awk -v p="$2" 'NR == 2 { n = $1++ } NR == n + 3 { print p } { print }' "$1"; }
flat_square 8 >square.off
with_isolated_vertex square.off '0.5 0.5 7' >isolated.off
torus >torus.off
make_tetrahedron >tetrahedron.off

# A square and a triangle, flat, and a tetrahedron; an isolated vertex.
printf 'OFF\n12 7 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 0 0\n5 0.5 0\n5 0 0.5\n9 9 9\n0 0 5\n1 0 5\n0 1 5\n0 0 6\n'\
'3 0 1 2\n3 0 2 3\n3 4 5 6\n3 8 10 9\n3 8 9 11\n3 9 10 11\n3 10 8 11\n' >three.off

test_texture_mapping() {
  expect 0
  expect_counts texture_mapping.obj 1042 1042 1999
  is_in_output '1 charts, 0 seam edges'
  grep -q '^mtllib texture_mapping.mtl' texture_mapping.obj || fail "the OBJ file does not name its material"
  grep -q '^map_Kd texture_mapping.tga' texture_mapping.mtl || fail "the material does not name its image"
  # Forty squares of 25 pixels each way.
  [ "$(wc -c <texture_mapping.tga)" -eq $((18 + 3 * 1000 * 1000)) ] ||
    fail "the image has $(wc -c <texture_mapping.tga) bytes"

  # Three edges that meet in a vertex, or follow each other, lay the tetrahedron flat: two corners more.
  expect 0 three.off --output three.obj
  expect_counts three.obj 12 13 7
  is_in_output '3 charts, 3 seam edges'
  # Triangles lie in the unit square, none is flipped, and flat charts have one scale.
  awk '
    $1 == "vt" {
      x[++n] = $2; y[n] = $3
      if ($2 <= 0 || $2 >= 1 || $3 <= 0 || $3 >= 1) { print "outside of the unit square"; exit 1 }
    }
    $1 == "f" {
      for (i = 2; i <= 4; ++i) { split($i, index_of, "/"); t[i] = index_of[2] }
      area[++f] = ((x[t[3]] - x[t[2]]) * (y[t[4]] - y[t[2]]) - (y[t[3]] - y[t[2]]) * (x[t[4]] - x[t[2]])) / 2
      if (area[f] <= 0) { print "flipped:", $0; exit 1 }
    }
    END {
      if (((area[1] + area[2]) / (8 * area[3]) - 1)^2 > 1e-12) {
        print "the scales differ:", area[1] + area[2], 8 * area[3]
        exit 1
      }
    }
    ' three.obj >message || fail "three.obj: $(cat message)"
  with_isolated_vertex three.off '1e90 0 0' >far.off
  expect 0 far.off --output far.obj
  expect_counts far.obj 13 13 7
  # A torus becomes a disk, whose border is its s seam edges, twice each: it has s + 1 vertices more.
  expect 0 torus.off --output torus.obj
  expect_counts torus.obj 64 $((64 + $(sed 's/.* \([0-9]*\) seam edges.*/\1/' stdout) + 1)) 128
  expect 1 --squares 0
}

test_surface_fitting() {
  # Between the knots of n control points and those of 2 n - 3 there is one more each: a finer surface can be everything
  # that a coarser one can.
  local n before=1
  for n in 7 11 19; do
    expect 0 --columns $n --rows $n
    expect_counts surface_fitting.obj 1042 1042 1999
    holds "$(number_after 'root mean square') < 0.7 * $before" "$n control points"
    before=$(number_after 'root mean square')
  done
  # A plane is in every spline space, and its map is a rigid motion.
  expect 0 square.off --columns 9 --rows 5
  holds "$(number_after 'greatest') < 1e-8" "a plane"
  expect 0 isolated.off --columns 9 --rows 5
  holds "$(number_after 'greatest') < 1e-8" "a plane and an isolated vertex"
  expect 2 tetrahedron.off
  expect 1 --columns 3
}

test_remeshing() {
  expect 0 --subdivisions 0
  local coarse distance
  coarse=$(grep -c '^f ' remeshing.obj)
  distance=$(number_after 'of its box:')
  expect 0 --subdivisions 2
  [ "$(grep -c '^f ' remeshing.obj)" -eq $((16 * coarse)) ] ||
    fail "$(grep -c '^f ' remeshing.obj) triangles instead of 16 times $coarse"
  holds "$(number_after 'of its box:') < 0.5 * $distance" "the distance after two subdivisions"
  # The new vertices lie on the surface, here on a square, those of the border on its sides.
  expect 0 square.off --coarsest 10
  awk '
    $1 == "v" {
      ++n; x[n] = $2; y[n] = $3
      if (($4 - 0.5 * $2)^2 > 1e-20 || $2 < -1e-12 || $2 > 1 + 1e-12 || $3 < -1e-12 || $3 > 1 + 1e-12) exit 1
    }
    $1 == "f" {
      for (i = 2; i <= 4; ++i) { split($i, a, "/"); split($(i % 3 + 2), b, "/"); ++edges[a[1] "," b[1]] }
    }
    END {
      for (e in edges) { split(e, v, ","); if (!((v[2] "," v[1]) in edges)) for (i in v) {
        p = x[v[i]]; q = y[v[i]]
        if (p^2 > 1e-20 && (1 - p)^2 > 1e-20 && q^2 > 1e-20 && (1 - q)^2 > 1e-20) exit 1
      } }
    }' remeshing.obj || fail "a new vertex is not on the square, or one of the border not on its sides"
  distance=$(number_after 'of its box:')
  expect 0 isolated.off --coarsest 10
  holds "$(number_after 'of its box:') == $distance" "a square and an isolated vertex"
  expect 2 tetrahedron.off
  expect 1 --subdivisions 99
}

test_cut_open_closed_mesh() {
  # A surface with g handles and seams of s edges becomes a disk with s + 2 g - 1 vertices more.
  local bound before=0 seam_edges
  for bound in 100 4.4 4.15; do
    expect 0 --distortion-bound $bound
    is_in_output ' 0 flips, 0 overlapping pairs'
    seam_edges=$(sed 's/.* \([0-9]*\) seam edges.*/\1/' stdout)
    expect_counts cut_open.obj 2562 $((2562 + seam_edges - 1)) 5120
    [ "$(grep -c '^l ' cut_open.obj)" -eq "$seam_edges" ] ||
      fail "$(grep -c '^l ' cut_open.obj) lines for $seam_edges seam edges"
    holds "$seam_edges >= $before" "the seam for the bound $bound"
    holds "$(number_after 'symmetric Dirichlet') < 1.02 * $bound" "the bound $bound"
    before=$seam_edges
  done
  expect 0 tetrahedron.off
  expect_counts cut_open.obj 4 6 4
  expect 0 torus.off
  is_in_output '^1 handles, .* 0 flips, 0 overlapping pairs'
  expect_counts cut_open.obj 64 $((64 + $(sed 's/.* \([0-9]*\) seam edges.*/\1/' stdout) + 1)) 128
  expect 0 square.off
  is_in_output ' 0 seam edges'
  expect 1 --distortion-bound 3
}

"test_$name"

# What is no mesh, wrong usage, and what cannot be written. Nothing is left behind.
rm -f ./*.obj ./*.mtl ./*.tga
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >truncated.off
expect 2 missing.off
expect 2 truncated.off
expect 1 --no-such-option 1
expect 1 --output
expect 1 one.off two.off
cp square.off before.off
expect 1 square.off --output ./square.off
cmp -s square.off before.off || fail "the input was changed"
[ -z "$(find . -name '*.obj' -o -name '.part*' -o -name '*.mtl' -o -name '*.tga')" ] || fail "files were left: $(ls)"
expect 3 --output no/such/folder/out.obj

[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
