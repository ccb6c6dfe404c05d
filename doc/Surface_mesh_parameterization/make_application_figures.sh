#!/usr/bin/env bash
# Draws the figures of the applications into fig/: make_application_figures.sh BUILD, the folder of a build that has the
# examples and the target draw_checker, which needs libpng (Debian: libpng-dev). Needs rsvg-convert, too.
set -euo pipefail
build=$(cd "${1:?usage: make_application_figures.sh BUILD}" && pwd)
examples=$build/examples/Surface_mesh_parameterization
draw_checker=$build/doc/Surface_mesh_parameterization/draw_checker
figures=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/fig
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# side_by_side FIGURE WIDTH HEIGHT [PICTURE CAPTION]...: pictures of the same size with texts below.
side_by_side() {
  local figure=$1 width=$2 height=$3 x=0 step=$(($2 + 20))
  shift 3
  {
    echo "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='$(($# / 2 * step - 20))' height='$((height + 34))'>"
    echo "<rect width='100%' height='100%' fill='white'/><g font-family='sans-serif' font-size='15' fill='#222' text-anchor='middle'>"
    for (( ; $# > 0; x += step)); do
      echo "<image x='$x' y='0' width='$width' height='$height' xlink:href='$1'/>"
      echo "<text x='$((x + width / 2))' y='$((height + 22))'>$2</text>"
      shift 2
    done
    echo "</g></svg>"
  } >side_by_side.svg
  rsvg-convert side_by_side.svg -o "$figures/$figure"
}

"$examples/texture_mapping_example" >/dev/null
"$draw_checker" texture_mapping.obj front.png --board 30,30
"$draw_checker" texture_mapping.obj side.png --board 30,30 --view 1,0.15,0.9
side_by_side checker.png 300 400 front.png "the checker board on the face" side.png "from the side"

pictures=()
for n in 8 16 32; do
  "$examples/surface_fitting_example" --columns $n --rows $((4 * n / 3)) >output
  # A square of the board is a polynomial piece of the surface.
  "$draw_checker" surface_fitting.obj "fit_$n.png" --board $((n - 3)),$((4 * n / 3 - 3)) --view 0.5,0.1,1
  pictures+=("fit_$n.png" "$n × $((4 * n / 3)) control points, $(awk '{ printf "%.2f", 100 * $NF }' output) %")
done
side_by_side fitting.png 260 360 "${pictures[@]}"

pictures=()
for k in 0 1 2; do
  "$examples/remeshing_example" --coarsest 50 --subdivisions $k >/dev/null
  "$draw_checker" remeshing.obj "subdivided_$k.png" --view 0.5,0.1,1 --edges 1 --lines 3
  pictures+=("subdivided_$k.png" "$(grep -c '^f ' remeshing.obj) triangles")
done
side_by_side remeshing.png 240 332 "${pictures[@]}"

for paths in 1 3; do
  "$examples/cut_open_closed_mesh_example" --paths $paths >/dev/null
  "$draw_checker" cut_open.obj "paths_$paths.png" --board 32,32 --view 0,0.2,1 --lines 4,0.85,0.05,0.1
done
side_by_side seam.png 360 360 paths_1.png "cut along one path" paths_3.png "along three"

pictures=()
for method in uniform symmetric-dirichlet; do
  "$build/examples/hierarchical_parameterization/hierarchical_parameterization" --method $method --picture map.svg --quiet
  rsvg-convert -w 900 --background-color=white map.svg -o "$method.png"
  pictures+=("$method.png" "$method")
done
side_by_side distortion.png 340 340 "${pictures[@]}"
