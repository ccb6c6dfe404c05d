#!/usr/bin/env bash
# Draws the figures of the applications into fig/: make_application_figures.sh BUILD [MESH CAPTION]..., the folder of a
# build that has the examples and the target draw_checker, which needs libpng (Debian: libpng-dev). Needs rsvg-convert,
# too. Only with meshes it draws atlases.png, of them and their atlases.
set -euo pipefail
build=$(cd "${1:?usage: make_application_figures.sh BUILD [MESH CAPTION]...}" && pwd)
shift
meshes=()
for (( ; $# > 1; )); do
  meshes+=("$(realpath "$1")" "$2")
  shift 2
done
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

for bound in 100 4.1; do
  "$examples/cut_open_closed_mesh_example" --distortion-bound $bound >/dev/null
  "$draw_checker" cut_open.obj "bound_$bound.png" --board 32,32 --view 0,0.2,1 --lines 4,0.85,0.05,0.1
done
side_by_side seam.png 360 360 bound_100.png "cut along one path" bound_4.1.png "with branches"

# The map of an OBJ file as a surface in the plane, with the same texture.
lay_flat() {
  awk '$1 == "vt" { print "v", $2, $3, 0; print }
       $1 == "f" { for (i = 2; i <= 4; ++i) { split($i, a, "/"); $i = a[2] "/" a[2] } print }' "$1"
}

pictures=()
for (( i = 0; i < ${#meshes[@]}; i += 2 )); do
  "$examples/texture_mapping_example" "${meshes[i]}" --output atlas.obj >output
  used=$(sed 's/.*, \(.*\) of the texture.*/\1/' output)
  lay_flat atlas.obj >flat.obj
  "$draw_checker" atlas.obj "surface_$i.png" --board 60,60 --view 0,0.2,1
  "$draw_checker" flat.obj "atlas_$i.png" --board 60,60 --view 0,0,1
  pictures+=("surface_$i.png" "${meshes[i + 1]}" "atlas_$i.png" "its atlas, $used of the square")
done
if ((${#meshes[@]} > 0)); then side_by_side atlases.png 270 290 "${pictures[@]}"; fi

pictures=()
for method in uniform symmetric-dirichlet; do
  "$build/examples/hierarchical_parameterization/hierarchical_parameterization" --method $method --picture map.svg --quiet
  rsvg-convert -w 900 --background-color=white map.svg -o "$method.png"
  pictures+=("$method.png" "$method")
done
side_by_side distortion.png 340 340 "${pictures[@]}"
