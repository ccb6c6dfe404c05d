// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A target for libFuzzer: the program's readers on any bytes, and the whole way to the map for meshes of up to 50
// faces. test/fuzz.sh builds and runs it.
//
// The first byte chooses the file format, the second one what is done; the file follows.

#include "../../examples/hierarchical_parameterization/Polygon_soup.h"
#include "../../examples/hierarchical_parameterization/input.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef std::vector<Kernel::Point_2>   Places;

void require(bool condition)
{
  if (!condition)
    std::abort();
}

// A map that is called good must be: one-to-one around every vertex, and as a whole if that was promised. Where there
// is none the user's map is what it was, to the last bit.
void check(const Input& input, UV_map uvmap, const Places& before, SMP::Error_code status, bool is_globally_injective)
{
  if (status != SMP::OK) {
    for (const auto v : input.mesh.vertices())
      require(std::memcmp(&uvmap[v], &before[v], sizeof(Kernel::Point_2)) == 0);
    return;
  }
  SMP::Mesh_component<Mesh> component(input.mesh, input.border);
  std::vector<SMP::internal::Point_2> uv;
  for (const auto v : component.vertices_of_component())
    uv.emplace_back(uvmap[v].x(), uvmap[v].y());
  require(SMP::internal::has_no_flips(SMP::internal::One_rings(uv.size(), component.surface().triangles), uv));
  require(!is_globally_injective || SMP::parameterization_quality(input.mesh, input.faces, uvmap).overlaps == 0);
}

// Not by CGAL's function parameterize(), which refuses isolated vertices by a precondition.
template <class Parameterizer>
void run(Input& input, UV_map uvmap, Parameterizer parameterizer, bool is_globally_injective)
{
  const auto vimap = get(CGAL::dynamic_vertex_property_t<int>(), input.mesh);
  const auto vpmap = get(CGAL::dynamic_vertex_property_t<bool>(), input.mesh);
  const Places before(uvmap.begin(), uvmap.end());
  const SMP::Error_code status = parameterizer.parameterize(input.mesh, input.border, uvmap, vimap, vpmap);
  check(input, uvmap, before, status, is_globally_injective);
}

template <class Method>
void run(Input& input, UV_map uvmap, bool is_flat, bool is_globally_injective, bool fills_holes, bool has_start)
{
  const Method method(CGAL::parameters::globally_injective(is_globally_injective)
                          .fill_holes(fills_holes)
                          .initial_map(has_start)
                          .number_of_iterations(5));
  if (is_flat)
    run(input, uvmap, method, is_globally_injective);
  else
    run(input, uvmap,
        SMP::Hierarchical_parameterizer_3<Method>(
            method, CGAL::parameters::coarsest_size(6).fill_holes(fills_holes).initial_map(has_start)),
        is_globally_injective);
}

// The map of the file, or the points' first two coordinates, flips or not.
void set_map(const Input& input, const std::vector<std::array<double, 2>>& uv, UV_map uvmap)
{
  for (const auto v : input.mesh.vertices())
    uvmap[v] = uv.empty() ? Kernel::Point_2(input.mesh.point(v).x(), input.mesh.point(v).y())
                          : Kernel::Point_2(uv[v][0], uv[v][1]);
}

void repair(Input& input, UV_map uvmap)
{
  if (SMP::settle_flips(input.mesh, input.border, uvmap, SMP::Flip_policy::REPAIR) == SMP::OK)
    check(input, uvmap, {}, SMP::OK, false);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t most_faces = 50;
  if (size < 2)
    return 0;
  const std::vector<std::string> names = { "x.off", "x.obj", "x.ply", "x.stl" };
  const std::string content(data + 2, data + size);
  const unsigned int choice = data[1];
  Input input;
  std::vector<std::array<double, 2>> uv;
  try {
    Polygon_soup soup = read_soup(names[data[0] % names.size()], content, true);
    uv = soup.uv;
    input.mesh = make_mesh(std::move(soup), { (choice & 1) != 0, (choice & 128) != 0 });
    if (uv.size() != input.mesh.number_of_vertices())
      uv.clear();                                // points were doubled
    choose_component(input);
  } catch (const Input_error&) {
    return 0;
  }
  if (input.mesh.number_of_faces() > most_faces)
    return 0;

  const UV_map uvmap =
      input.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", Kernel::Point_2(-77, 77)).first;
  const bool is_flat = choice & 2, is_globally_injective = choice & 4, fills_holes = choice & 32,
             has_start = choice & 64;
  if (has_start || choice & 8)
    set_map(input, uv, uvmap);
  if (choice & 8)
    repair(input, uvmap);
  else if (choice & 16)
    run<SMP::MIPS_parameterizer_3<Mesh>>(input, uvmap, is_flat, is_globally_injective, fills_holes, has_start);
  else
    run<SMP::Symmetric_Dirichlet_parameterizer_3<Mesh>>(input, uvmap, is_flat, is_globally_injective, fills_holes,
                                                        has_start);
  return 0;
}
