#!/usr/bin/env bash
# Runs the program as a user would: program_test.sh PROGRAM
program=$1
source "$(dirname "$0")/run_as_a_user.sh"

# field NAME: the first value of that name in the report.
field() { grep -o "\"$1\":[^,}]*" report.json | head -1 | cut -d: -f2; }
# same_map FILE FILE: two OBJ files have the same place for each vertex, but for the last digits.
same_map() {
  paste <(grep '^vt ' "$1") <(grep '^vt ' "$2") |
    awk -v n="$(grep -c '^v ' "$1")" '!(NF == 6 && ($2 - $5)^2 + ($3 - $6)^2 <= 1e-12) { bad = 1 }
                                      END { exit bad || NR != n || NR == 0 }'
}
is_field() { [ "$(field "$1")" = "$2" ] || fail "$1 is $(field "$1") instead of $2 after '$3'"; }

# The built-in face.
expect 0 --output face.obj --picture face.svg --report report.json --levels levels
is_field vertices 1042 face
is_field flips 0 face
[ "$(tail -c +1 report.json | wc -l)" -eq 1 ] || fail "the report is not one line"
[ "$(grep -c '^v ' face.obj)/$(grep -c '^vt ' face.obj)/$(grep -c '^f ' face.obj)" = 1042/1042/1999 ] ||
  fail "face.obj has not 1042 v, 1042 vt, 1999 f"
grep -q '</svg>' face.svg || fail "face.svg is not whole"
[ "$(ls levels | wc -l)" -eq "$(grep -o '"energy_end"' report.json | wc -l)" ] || fail "not every level was written"
grep -o '"iterations":[1-9][0-9]*,"cycles":[0-9]*' report.json | tr -c '0-9\n' ' ' |
  awk '$2 < $1 { bad = 1 } END { exit bad || NR == 0 }' || fail "a Newton step took no V-cycle"
finest=$(ls levels | tail -1)
[ "$(grep -c '^f ' "levels/$finest")" -eq 1999 ] || fail "the finest level is not the input"
cmp -s <(grep '^vt ' face.obj | sort) <(grep '^vt ' "levels/$finest" | sort) || fail "the finest level has another map"
[ -z "$(ls -A . levels | grep -F .part)" ] || fail "a temporary file was left"

# What it writes can be read again, with the same vertices and faces in the same order.
expect 0 face.obj --output again.obj
cmp -s <(grep '^v ' face.obj) <(grep '^v ' again.obj) || fail "the vertices have changed"
cmp -s <(grep '^f ' face.obj) <(grep '^f ' again.obj) || fail "the faces have changed"

# With --orient, faces keep their points, whose first places stay as they are; it may turn faces and double points.
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 0 -1 0' 'v 0 0 1' 'v 2 0 1' \
  'f 1 2 3' 'f 2 1 4' 'f 1 2 5' 'f 2 5 6' >leaves.obj
# points_of_faces FILE: a line for each face, with its points in the order of their coordinates.
points_of_faces() {
  awk '$1 == "v" { point[++n] = $2 " " $3 " " $4 }
       $1 == "f" { for (i = 2; i <= 4; ++i) { split($i, v, "/"); print f, point[v[1]] }; ++f }' "$1" | sort -n
}
expect 2 leaves.obj
grep -q -e '--orient' stderr || fail "nobody is told of --orient: $(cat stderr)"
expect 0 leaves.obj --orient --output oriented.obj --report report.json
is_field flips 0 --orient
cmp -s <(points_of_faces leaves.obj) <(points_of_faces oriented.obj) || fail "--orient changes points of faces"
cmp -s <(grep '^v ' leaves.obj) <(grep '^v ' oriented.obj | head -6) || fail "--orient changes the first points"

# The same seed gives the same bytes, another one another hierarchy.
expect 0 --output twice.obj
cmp -s face.obj twice.obj || fail "two runs differ"
expect 0 --seed 1 --output other.obj
cmp -s face.obj other.obj && fail "the seed has no effect"

# From the standard input, whatever the format; PLY holds the map as u and v.
expect 0 face.obj --output face.ply
[ "$(grep -c -e '^property double [uv]$' face.ply)" -eq 2 ] || fail "face.ply has no u and v"
for format in obj ply; do
  "$program" - --output piped.obj <face.$format >/dev/null || fail "the standard input was not read as $format"
  cmp -s face.obj piped.obj || fail "$format from the standard input gives another map"
done
printf '# a comment\n\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' | "$program" - --quiet ||
  fail "a file that begins with a comment was not read from the standard input"
printf 'SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n' |
  "$program" - --quiet || fail "an STL file in capitals was not read from the standard input"
printf nonsense | "$program" - 2>stderr && fail "nonsense from the standard input was taken for a mesh"
grep -q 'is not OFF, OBJ, PLY or STL' stderr || fail "nonsense is called something else: $(cat stderr)"
"$program" - <. 2>stderr && fail "a folder was read as standard input"
grep -q 'cannot be read' stderr || fail "a folder as standard input is called something else: $(cat stderr)"
"$program" --version | grep -q '^hierarchical_parameterization [0-9.]* with CGAL [0-9]' ||
  fail "--version tells no version"

expect 0 --flat --report report.json
grep -q ' 1 level, ' stdout || fail "one level is told as: $(cat stdout)"
is_field flips 0 flat
[ "$(grep -o '"energy_end"' report.json | wc -l)" -eq 1 ] || fail "a flat run has one level"
expect 0 --method symmetric-dirichlet --report report.json
is_field flips 0 symmetric-dirichlet
is_field status '"ok"' symmetric-dirichlet
for method in uniform chordal harmonic shape-preserving; do
  expect 0 --method $method --output nested.obj --picture $method.svg --report report.json
  is_field method "\"$method\"" $method
  is_field status '"ok"' $method
  [ $method = harmonic ] || is_field flips 0 $method
  [ "$(grep -o '"energy_end"' report.json | wc -l)" -gt 5 ] || fail "$method did not run level by level"
  expect 0 --method $method --flat --output flat.obj --report report.json
  is_field status '"ok"' "$method --flat"
  same_map nested.obj flat.obj || fail "$method: flat and hierarchical maps differ"
done
# CGAL's parameterizers: the same map by multigrid, or by their own solver, and as they are shipped.
for method in barycentric mean-value conformal authalic iterative-authalic lscm; do
  expect 0 --method $method --output multigrid.obj --report report.json
  is_field method "\"$method\"" $method
  is_field status '"ok"' $method
  case $method in barycentric | mean-value | conformal) is_field direct_solutions 0 $method ;; esac
  [ "$(wc -l <stdout)" -eq 1 ] || fail "$method printed $(wc -l <stdout) lines instead of one"
  expect 0 --method $method --flat --output shipped.obj --report report.json
  is_field status '"ok"' "$method --flat"
  is_field linear_solver null "$method --flat"
  [ "$(wc -l <stdout)" -eq 1 ] || fail "$method --flat printed $(wc -l <stdout) lines instead of one"
  same_map multigrid.obj shipped.obj || fail "$method: the map is not CGAL's"
done
[ ! -e last_solve.off ] || fail "a file of CGAL's was left"
expect 0 --method arap --report report.json
is_field status '"ok"' arap
[ "$(grep -o '"energy_end"' report.json | wc -l)" -gt 5 ] || fail "arap did not run level by level"
arap_energy=$(field symmetric_dirichlet)
awk '$1 == "v" { printf "v %.17g %.17g %.17g\n", $2 * 1048576, $3 * 1048576, $4 * 1048576; next } { print }' face.obj \
  >large_face.obj
expect 0 large_face.obj --method arap --report report.json
is_field symmetric_dirichlet "$arap_energy" "arap in another unit"
expect 0 --method arap --flat --report report.json
is_field status '"ok"' "arap --flat"
expect 0 --method mean-value --iterations 0 --report report.json
is_field direct_solutions 2 "mean-value --iterations 0"

make_tube 5 >tube.obj
expect 3 tube.obj --method lscm --flips fail --report report.json
grep -q -e 'the map has [0-9]* triangles flipped; --flips' stderr || fail "flips are not counted: $(cat stderr)"
is_field status '"ERROR_NO_1_TO_1_MAPPING"' "lscm --flips fail"
expect 0 tube.obj --method lscm --flips keep --report report.json
[ "$(field flips)" -gt 0 ] || fail "lscm --flips keep has kept no flips"
expect 0 tube.obj --method lscm --report report.json
is_field flips 0 "lscm"
make_tube 60 >long_tube.obj
expect 0 long_tube.obj --method mean-value
grep -q ' flips repaired by moving [0-9]* vertices, ' stdout || fail "the repair is not told: $(cat stdout)"
grep -q 'the map is hardly its own' stderr || fail "nobody is told that most of the map was moved"
expect 0 long_tube.obj --method mean-value --quiet
[ ! -s stderr ] || fail "--quiet tells of a repair: $(cat stderr)"
expect 0 --method mips --iterations 1 --report report.json
is_field status '"not_converged"' "mips --iterations 1"
expect 0 --method uniform --iterations 0 --report report.json
is_field status '"ok"' "uniform --iterations 0"
expect 0 --weights area --tolerance 1e-3 --iterations 5 --quiet
[ ! -s stdout ] && [ ! -s stderr ] || fail "--quiet printed something"

# One chart in the unit square.
expect 0 --atlas --output atlas.obj --report report.json
[ "$(field charts)" -eq 1 ] || fail "--atlas made $(field charts) charts of the face"
awk '$1 == "vt" { ++n; bad = bad || !($2 >= 0 && $2 <= 1 && $3 >= 0 && $3 <= 1) } END { exit bad || n != 1042 }' \
  atlas.obj || fail "--atlas leaves the unit square"

# On a terminal a bar shows how far a run has come; elsewhere there is none.
on_terminal() { script -qec "$program $*" /dev/null; }
if command -v script >/dev/null; then
  for method in mips uniform mean-value; do
    on_terminal --method $method | tr '\r' '\n' | grep -q '^\[=*\] 100% level' || fail "no bar on a terminal: $method"
    [ -z "$(on_terminal --method $method --quiet)" ] || fail "--quiet shows something on a terminal: $method"
  done
  make_tetrahedron >closed.off
  on_terminal closed.off | tr '\r' '\n' | grep -q '^\[=*\] 100%' || fail "no bar on a terminal: an atlas"
  [ -z "$(on_terminal closed.off --quiet)" ] || fail "--quiet shows something on a terminal: an atlas"
fi
expect 0
[ ! -s stderr ] || fail "a run in a pipe printed $(cat stderr) on stderr"
expect 0 --help
grep -q 'xargs .* --report -$' stdout || fail "the example of many meshes in --help has no output"

# A square of two triangles, with a triangle apart and an isolated vertex.
cat >components.off <<END
OFF
8 3 0
5 5 5
0 0 0
1 0 0
1 1 0
0 1 0
0 0 9
1 0 9
0 1 9
3 5 6 7
3 1 2 3
3 1 3 4
END
expect 0 components.off --components largest --output components.obj --report report.json
[ "$(grep -c '^v ' components.obj)/$(grep -c '^vt ' components.obj)/$(grep -c '^f ' components.obj)" = 8/4/3 ] ||
  fail "components.obj is wrong"

# A run may start from a map that another one wrote, if it is one of the same vertices.
for map in map.obj map.ply; do
  for method in mips symmetric-dirichlet; do
    expect 0 --method $method --output $map
    expect 0 --method $method --start $map --report report.json
    is_field status '"ok"' "$method --start $map"
    [ "$(grep -o '"iterations":[0-9]*' report.json)" = '"iterations":1' ] || fail "$method --start $map did not go on"
  done
  expect 0 --method arap --start $map
done
# In whatever order the lines of the file are: faces, vertices, texture coordinates.
LC_ALL=C sort -s -k 1,1 map.obj >sorted.obj
expect 0 --start map.obj --output from_map.obj
expect 0 --start sorted.obj --output from_sorted.obj
cmp from_map.obj from_sorted.obj || fail "--start takes another map from sorted.obj"
expect 0 tube.obj --method lscm --flips keep --output folded.obj
expect 0 tube.obj --start folded.obj --report report.json
is_field flips 0 "--start folded.obj"
is_field status '"ok"' "--start folded.obj"
expect 1 --method lscm --start map.obj
expect 1 --flat --start map.obj
expect 1 --levels levels --start map.obj
for option in output picture report levels start hold; do expect 1 --$option --quiet; done
for option in output picture report; do
  expect 3 nowhere.obj --$option levels
  grep -q folder stderr || fail "--$option levels: $(cat stderr)"
done
expect 3 nowhere.obj --levels face.svg
grep -q folder stderr || fail "--levels face.svg: $(cat stderr)"

# Mirrored, too: the result is positive.
sed 's/^vt -/vt ~/; s/^vt \([0-9]\)/vt -\1/; s/^vt ~/vt /' map.obj >mirrored.obj
expect 0 --start mirrored.obj --report report.json
is_field flips 0 "--start mirrored.obj"
is_field status '"ok"' "--start mirrored.obj"
expect 1 --start map.obj --output map.obj
expect 1 face.obj tube.obj --start map.obj
expect 2 --start missing.obj
expect 2 --start components.obj
expect 2 tube.obj --start tube.obj
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 2\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n' \
  >seam.obj
expect 0 seam.obj
expect 2 seam.obj --start seam.obj
grep -q 'line 11: vertex 0 has two places' stderr || fail "the seam is told as: $(cat stderr)"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1\nf 1/1 2/2 3/9\n' >half.obj
expect 0 half.obj
expect 2 half.obj --start half.obj

# Vertices keep the places that a file gives them: those of another map, turned by a right angle.
expect 0 --output map.obj
grep '^vt ' map.obj | awk 'BEGIN { print "# vertex u v\n" } NR % 100 == 1 { print NR - 1, -$3, $2 }' >held.txt
for method in mips symmetric-dirichlet arap; do
  expect 0 --method $method --hold held.txt --output held.ply --report report.json
  is_field status '"ok"' "$method --hold"
  is_field flips 0 "$method --hold"
  [ "$(grep -c '^[0-9]' held.txt)" -eq 11 ] || fail "held.txt is wrong"
  expect 0 --method $method --hold held.txt --output held.obj
  awk 'BEGIN { k = 0 } NR == FNR { if ($1 ~ /^[0-9]/) { u[$1] = $2; v[$1] = $3; ++n } next }
       $1 == "vt" { if (k in u) { if ($2 != u[k] || $3 != v[k]) exit 1; --n } ++k }
       END { exit n != 0 }' held.txt held.obj || fail "$method --hold: a vertex is elsewhere"
done
expect 1 --method lscm --hold held.txt
expect 1 --flat --hold held.txt
expect 1 --cut auto --hold held.txt
expect 1 face.obj tube.obj --hold held.txt
expect 1 --hold held.txt --picture held.txt
expect 2 --hold missing.txt
for line in '1 2' '1 2 3 4' '1 2 inf' '-1 2 3' '1.5 2 3' '1 2 nan' '1 x 3' '1042 0 0' '0 1 1'; do
  (cat held.txt; echo "$line") >bad.txt
  expect 2 --hold bad.txt --output bad.obj
  grep -q -e "--hold: 'bad.txt' line 14: " stderr || fail "'$line' is told as: $(cat stderr)"
  [ ! -e bad.obj ] || fail "'$line' wrote a file"
done
printf '0 0 0\n1 1 0\n2 1 1\n3 2 0.2\n' >turned.txt
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n' >square.obj
expect 3 square.obj --hold turned.txt
make_tetrahedron >closed.off
expect 2 closed.off --hold turned.txt
: >none.txt
expect 0 --hold none.txt
sed 's/^0 .*/0 1e9 1e9 # far/' held.txt >far.txt
expect 0 --hold far.txt

# Wrong usage.
expect 1 --no-such-option
expect 1 --method no-such-method
expect 1 --weights no-such-weights
expect 1 --method lscm --levels levels
expect 1 --flat --levels levels_of_a_flat_run
[ ! -e levels_of_a_flat_run ] || fail "a folder was made for levels that there are not"
expect 1 --start -
expect 1 --hold -
expect 1 --flat --atlas
expect 1 --tolerance nonsense
expect 1 --seed -1
expect 0 --threads 2147483647 --quiet
expect 1 --seed 4294967296
expect 0 --seed 4294967295
expect 1 --iterations -1
for option in method weights flips components cut output picture report levels start hold; do
  expect 1 --$option ''
done
for value in -5 2 nan; do
  expect 1 --cut none --least-used-part $value
done

# Options without an effect.
expect 1 --flat --seed 1
for method in uniform mean-value lscm arap; do
  expect 1 --method $method --weights area
  expect 1 --method $method --flat --tolerance 1e-3
  expect 1 --method $method --flat --iterations 5
done
for method in mips symmetric-dirichlet; do
  expect 0 --method $method --flat --tolerance 1e-3 --iterations 5 --weights area --flips repair
  expect 1 --method $method --flips keep
  expect 1 --method $method --flips fail
done
expect 1 a.off b.off --output one.obj

# No surface to parameterize.
bad() {
  expect 2 "$@" --output bad.obj --picture bad.svg
  [ ! -e bad.obj ] && [ ! -e bad.svg ] || fail "'$1' wrote a file"
}
bad missing.off
: >empty.off; bad empty.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >range.off; bad range.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >truncated.off; bad truncated.off
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >quad.off; bad quad.off
make_tetrahedron >closed.off
bad closed.off --cut none
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' >edge.off; bad edge.off
printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n' >umbrellas.off; bad umbrellas.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n3 0 2 3\n' >orientation.off; bad orientation.off
printf 'OBJ\n' >text.txt; bad text.txt

# Several inputs: a line each, the worst status.
"$program" components.off quad.off face.obj --report report.json >/dev/null 2>&1
[ $? -eq 2 ] || fail "the worst status of several inputs is not reported"

# What cannot be written is an error, and leaves nothing behind.
expect 3 --output no/such/folder/face.obj
expect 3 --output /dev/full

[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
