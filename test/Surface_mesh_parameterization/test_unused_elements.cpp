// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Elements of a mesh that belong to no surface: removed ones that are still stored, and vertices without faces.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace test_unused_elements {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using wrapped_maps::Wrapped_map;
namespace parameters = CGAL::parameters;

typedef std::vector<Kernel::Point_2>   Places;

template <class Parameterizer>
class Unused_elements : public testing::Test
{
protected:
  // Of all vertices, in their order. Not by CGAL's function, which has a precondition that no vertex is isolated.
  static Places map_of(Surface_mesh& mesh)
  {
    Wrapped_map<Surface_mesh> mapped(mesh);
    EXPECT_EQ(mapped.parameterize(Parameterizer(), longest_border(mesh)), OK);
    Places uv;
    for (const auto v : vertices(mesh))
      uv.push_back(get(mapped.uvmap, v));
    return uv;
  }
};

typedef testing::Types<MIPS_parameterizer_3<Surface_mesh>,
                       Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>,
                       Hierarchical_parameterizer_3<Mean_value_coordinates_parameterizer_3<Surface_mesh>>,
                       Hierarchical_parameterizer_3<Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3>>,
                       Hierarchical_parameterizer_3<LSCM_parameterizer_3<Surface_mesh>>>
    Parameterizers;
TYPED_TEST_SUITE(Unused_elements, Parameterizers, );

Flat_mesh patch() { return grid(16, 12, wavy); }

// The patch, before and behind which others were removed.
Surface_mesh patch_with_garbage(bool is_before, bool is_behind)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Face_index> unwanted;
  const auto append_unwanted = [&] {
    const std::size_t before = mesh.number_of_faces();
    append(grid(5, 4, wavy), mesh);
    for (std::size_t f = before; f < mesh.number_of_faces(); ++f)
      unwanted.emplace_back(Surface_mesh::size_type(f));
  };
  if (is_before)
    append_unwanted();
  append(patch(), mesh);
  if (is_behind)
    append_unwanted();
  for (const auto f : unwanted)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  EXPECT_TRUE(mesh.has_garbage());
  return mesh;
}

TYPED_TEST(Unused_elements, that_were_removed_do_not_change_the_map)
{
  Surface_mesh whole = make<Surface_mesh>(patch()), behind = patch_with_garbage(false, true),
               everywhere = patch_with_garbage(true, true);
  const Places expected = this->map_of(whole);
  EXPECT_EQ(this->map_of(everywhere), expected);
  EXPECT_EQ(this->map_of(behind), expected);
  behind.collect_garbage();       // which changes no order here
  EXPECT_EQ(this->map_of(behind), expected);
}

// The user finds the vertex by its position in vertices(mesh).
TYPED_TEST(Unused_elements, that_were_removed_are_not_counted_by_errors)
{
  Surface_mesh mesh = patch_with_garbage(true, true);
  const std::size_t position = 40;
  mesh.point(*std::next(mesh.vertices_begin(), position)) =
      Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  Wrapped_map<Surface_mesh> mapped(mesh);
  Parameterization_summary summary;
  EXPECT_EQ(mapped.parameterize(TypeParam(parameters::summary(std::ref(summary))), longest_border(mesh)),
            ERROR_WRONG_PARAMETER);
  EXPECT_EQ(summary.error.place, Parameterization_error::VERTEX);
  EXPECT_EQ(summary.error.index, position);
  EXPECT_TRUE(mapped.is_untouched());
}

TYPED_TEST(Unused_elements, that_are_isolated_vertices_have_no_place)
{
  Surface_mesh alone = make<Surface_mesh>(patch()), mesh;
  mesh.add_vertex(Kernel::Point_3(100, 0, 0));
  append(patch(), mesh);
  mesh.add_vertex(Kernel::Point_3(0, 100, 0));
  Places expected = this->map_of(alone);
  expected.insert(expected.begin(), untouched());
  expected.push_back(untouched());
  EXPECT_EQ(this->map_of(mesh), expected);
}

} // namespace test_unused_elements
