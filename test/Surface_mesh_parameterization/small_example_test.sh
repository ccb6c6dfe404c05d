#!/usr/bin/env bash
# Runs an example of the manual on the built-in face, on small inputs and on bad ones:
# small_example_test.sh NAME PROGRAM
name=$1
program=$2
source "$(dirname "$0")/run_as_a_user.sh"

# The component with the longest border is a square of four triangles with its middle. There is a triangle, too, a
# tetrahedron, which is the highest, and an isolated vertex.
printf 'OFF\n13 9 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n2 2 1\n9 0 0\n9 1 0\n8 0 0\n0 0 5\n1 0 5\n0 1 5\n0 0 6\n9 9 9\n'\
'3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 5 6 7\n3 8 10 9\n3 8 9 11\n3 9 10 11\n3 10 8 11\n' >several.off
make_tetrahedron >closed.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >truncated.off

# What a program that writes takes after its input, and the most arguments that a program takes.
output=()
most=1
case $name in
  atlas | mips | sharp_edges) output=(out.obj) most=2 ;;
  held_vertices | level_visitor | fair_with_multigrid) most=2 ;;
esac

[ ${#output[@]} -gt 0 ] || expect 0
if [ "$name" = fair_with_multigrid ]; then
  # Inside the borders and not next to them there is no vertex to fair.
  expect 0 several.off
  is_in_output '^0 vertices'
else
  expect 0 several.off "${output[@]}"
fi
case $name in
  mips | custom_energy) is_in_output ' 0 flips\|^0 flips' ;;
  hierarchy) is_in_output '^5 vertices, 4 faces: mean square error 0$' ;;
esac
grep -qiw 'nan\|inf' stdout && fail "no number: $(cat stdout)"

if [ "$name" = atlas ]; then
  is_in_output '^charts: 3, '
  expect 0 closed.off "${output[@]}"
  is_in_output '^charts: 1, edges of seams: [1-9]'
elif [ "$name" = sharp_edges ]; then
  expect 0 closed.off "${output[@]}"
  is_in_output '^charts: 4, symmetric Dirichlet energy: 4,'
else
  expect 1 closed.off "${output[@]}"
  told '^closed.off: the surface has no border'
fi
expect 1 missing.off "${output[@]}"
told '^missing.off: cannot be read'
expect 1 truncated.off "${output[@]}"
told '^truncated.off: cannot be read'
arguments=()
for ((i = 0; i <= most; ++i)); do arguments+=(several.off); done
expect 1 "${arguments[@]}"
told '^usage: '

if [ "$name" = mips ] || [ "$name" = held_vertices ]; then
  expect 0 several.off out.obj
  [ "$(grep -c '^v ' out.obj)/$(grep -c '^vt ' out.obj)/$(grep -c '^f ' out.obj)" = 5/5/4 ] ||
    fail "not the square alone: $(cat out.obj)"
fi
if [ "$name" = atlas ] || [ "$name" = sharp_edges ]; then
  expect 0 several.off out.obj
  [ "$(grep -c '^v ' out.obj)/$(grep -c '^f .*/.*/' out.obj)" = 13/9 ] || fail "not all faces: $(cat out.obj)"
fi
if [ "$name" = atlas ] || [ "$name" = sharp_edges ] || [ "$name" = mips ] || [ "$name" = held_vertices ]; then
  expect 1 several.off no/such/folder/out.obj
  told 'cannot be written'
  [ ! -w /dev/full ] || { expect 1 several.off /dev/full && told 'cannot be written'; }
fi
if [ "$name" = held_vertices ]; then
  grep -q '^vt 0.5 0.5$' out.obj || fail "the middle is not held: $(cat out.obj)"
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >triangle.off
  expect 1 triangle.off
  told 'all vertices are on borders'
fi
if [ "$name" = hierarchy ]; then
  # The coarser a level is, the less it knows of the function.
  expect 0
  is_in_output '^1042 vertices, 1999 faces: mean square error 0$'
  sed 's/.* //' stdout | sort -gr | cmp -s - <(sed 's/.* //' stdout) || fail "errors do not fall: $(cat stdout)"
fi
if [ "$name" = square_border ]; then
  # Closer to an isometry, whose energy is 4.
  expect 0
  awk '/^symmetric/ { sub(",", "", $5); exit !(4 < $5 && $5 < $3) }' stdout || fail "no better map: $(cat stdout)"
fi

[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
