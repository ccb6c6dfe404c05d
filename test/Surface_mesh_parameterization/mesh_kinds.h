// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_KINDS_H
#define MESH_KINDS_H

#include "generated_meshes.h"
#include "hostile_meshes.h"
#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

// The kinds of surfaces that are hard to lay out, by size and seed: disks, and some with holes, of about
// `triangles` triangles. What a size leaves open, how steep or how narrow, is chosen at random.
namespace test_meshes {

struct Mesh_kind
{
  const char* name;
  Flat_mesh (*make_at_random)(Index triangles, Random&);

  Flat_mesh make(Index triangles, unsigned int seed) const
  {
    Random random(seed);
    return make_at_random(triangles, random);
  }

  friend std::ostream& operator<<(std::ostream& out, const Mesh_kind& kind) { return out << kind.name; }
};

// The squares along the side of a grid of `triangles` triangles.
inline Index side(Index triangles) { return (std::max)(Index(2), Index(std::sqrt(0.5 * triangles))); }

// The rings that make a disk with `valence` triangles around every vertex most nearly as large as `triangles`.
inline Index rings_of_hyperbolic_disk(Index valence, Index triangles)
{
  double ring = valence, ring_inside = 0, sum = valence;
  Index rings = 1;
  for (; sum * std::sqrt(valence - 4.) < triangles; ++rings) {
    const double next = (valence - 4) * ring - ring_inside;
    sum += ring + next;
    ring_inside = ring;
    ring = next;
  }
  return rings;
}

inline const std::vector<Mesh_kind>& mesh_kinds()
{
  static const std::vector<Mesh_kind> kinds = {
    { "spike", [](Index n, Random& random) { return spike(n / 3 + 3, random.power(1e-4, 0.3)); } },
    { "fan", [](Index n, Random& random) { return ruffled_fan(n + 3, random.power(0.01, 1)); } },
    { "apollonian_disk", [](Index n, Random& random) { return apollonian_disk(n, random.seed()); } },
    { "hyperbolic_disk_7", [](Index n, Random&) { return hyperbolic_disk(7, rings_of_hyperbolic_disk(7, n)); } },
    { "hyperbolic_disk_20", [](Index n, Random&) { return hyperbolic_disk(20, rings_of_hyperbolic_disk(20, n)); } },
    { "hyperbolic_disk",
      [](Index n, Random& random) {
        const Index valence = 8 + Index(random.below(30));
        return hyperbolic_disk(valence, rings_of_hyperbolic_disk(valence, n));
      } },
    { "comb_of_long_teeth",
      [](Index n, Random& random) {
        const Index teeth = 2 + Index(random.below(4));
        return flat_comb(teeth, random.power(10, 1e4), n / (2 * teeth) + 1);
      } },
    { "comb_of_many_teeth", [](Index n, Random& random) { return flat_comb(n / 24 + 2, random.power(2, 1e3), 10); } },
    { "ribbon", [](Index n, Random& random) { return ribbon(n / 2 + 1, random.power(1, 1e4), 1); } },
    { "helix", [](Index n, Random& random) { return helix(n / 2 + 1, random.power(1, 100)); } },
    { "ramp", [](Index n, Random& random) { return ramp(n / 8 + 4, random.power(0.5, 10)); } },
    { "twisted_strip",
      [](Index n, Random& random) { return twisted_strip(n / 4 + 2, random.power(1, 0.02 * n + 2)); } },
    { "spiral",
      [](Index n, Random& random) { return flat_mesh(hostile_meshes::spiral(n / 4 + 2, random.power(1, 20))); } },
    { "meander",
      [](Index n, Random& random) {
        const Index columns = 4 + Index(random.below(side(n)));
        return meander(columns, 1 + 2 * (n / (2 * columns)));
      } },
    { "necklace", [](Index n, Random& random) { return necklace(n / 8 + 2, n / 160 + 1, random.power(1e-4, 0.1)); } },
    { "tree_of_triangles",
      [](Index n, Random& random) { return tree_of_triangles(n, 0.9 * double(random.below(2)), random); } },
    { "tree_of_strips", [](Index n, Random& random) { return tree_of_strips(n, random.power(0.5, 1), random); } },
    { "fractal_tree",
      [](Index n, Random& random) {
        const double taper = random(0.5, 0.9);
        return fractal_tree(n, 1 + Index(random.below(12)), taper);
      } },
    { "octopus",
      [](Index n, Random& random) {
        const long legs = 2 + long(random.below(5));
        return flat_mesh(hostile_meshes::octopus(legs, n / (8 * legs) + 1));
      } },
    { "tube",
      [](Index n, Random& random) {
        const Index around = 6 + Index(random.below(60)), rings = n / (2 * around) + 2;
        return tube(rings, around, rings * random.power(0.2, 1) * 6 / around);
      } },
    { "open_tube",
      [](Index n, Random& random) {
        const Index around = 6 + Index(random.below(60));
        return open_tube(around, n / (2 * around) + 1, random.power(0.2, 1) * 6 / around);
      } },
    { "narrow_ring", [](Index n, Random& random) { return open_tube(n / 2 + 3, 1, random.power(1e-4, 1)); } },
    { "pearls",
      [](Index n, Random& random) {
        const Index around = 8 + Index(random.below(24));
        const double neck = random.power(0.01, 0.5);
        return pearls(around, n / (2 * around) + 2, 1 + Index(random.below(4)), neck);
      } },
    { "nearly_closed_sphere",
      [](Index n, Random& random) {
        return cap(side(n) / 2 + 2, 2 * side(n) + 3, CGAL_PI * (1 - random.power(1e-3, 0.1)));
      } },
    { "steep_cone",
      [](Index n, Random& random) {
        const Index around = 8 + Index(random.below(40));
        return steep_cone(around, n / (2 * around) + 2, random.power(1, 1e6));
      } },
    { "cut_cone",
      [](Index n, Random& random) { return cut_cone(side(n) + 2, side(n), random.power(1e-3, 0.5) * CGAL_PI); } },
    { "staircase",
      [](Index n, Random& random) {
        return flat_mesh(hostile_meshes::spiral_staircase(2 * side(n) + 8, side(n) / 2 + 1, random(0.9, 3)));
      } },
    { "ruffled_disk",
      [](Index n, Random& random) {
        const Index waves = 2 + Index(random.below(8));
        return ruffled_disk(side(n) / 2 + 2, 2 * side(n) + 8 * waves, waves, random.power(0.1, 3));
      } },
    { "star",
      [](Index n, Random& random) {
        const Index rays = 3 + Index(random.below(8)), sectors = 8 * rays;
        return star(n / (2 * sectors) + 1, sectors, rays);
      } },
    { "lattice_of_holes",
      [](Index n, Random& random) { return lattice_with_holes(Index(side(n) * 0.57) * 2 + 3, 1, random); } },
    { "random_holes",
      [](Index n, Random& random) {
        return lattice_with_holes(Index(side(n) * 0.53) * 2 + 3, random(0.1, 0.9), random);
      } },
    { "delaunay_terrain",
      [](Index n, Random& random) { return delaunay_patch(n / 2 + 5, random.seed(), wavy); } },
    { "stretched_terrain",
      [](Index n, Random& random) {
        const double stretch = random.power(10, 1e5);
        return moved(delaunay_patch(n / 2 + 5, random.seed(), wavy), [&](const Point_3& p) {
          return Point_3(stretch * p.x(), p.y(), p.z());
        });
      } },
    { "caps",
      [](Index n, Random& random) {
        return flat_mesh(hostile_meshes::caps(long(0.7 * side(n)) + 1, random.power(1e-8, 0.1)));
      } },
    { "graded_grid",
      [](Index n, Random& random) { return flat_mesh(hostile_meshes::graded(side(n), random.power(10, 1e6))); } },
    { "graded_rings",
      [](Index n, Random& random) {
        const Index around = 6 + Index(random.below(20));
        return flat_mesh(hostile_meshes::graded_rings(around, n / (2 * around) + 2, random.power(10, 1e6)));
      } },
    { "random_terrain",
      [](Index n, Random& random) { return random_terrain(side(n), random.power(0.1, 100), random); } },
    { "tents", [](Index n, Random& random) { return tents(side(n), 3, random.power(0.3, 30), random); } },
    { "accordion",
      [](Index n, Random& random) {
        const double width = random.power(1e-3, 0.5);
        return accordion(side(n), 1 + Index(random.below(5)), width);
      } },
    { "extreme_coordinates",
      [](Index n, Random& random) {
        const double scale = random.below(2) == 0 ? 1e-150 : 1e150;
        return moved(random_terrain(side(n), random.power(0.1, 3), random), [&](const Point_3& p) {
          return Point_3(scale * p.x(), scale * p.y(), scale * p.z());
        });
      } },
    { "distant_terrain",
      [](Index n, Random& random) {
        const double offset = random.power(1e2, 1e8);
        return moved(random_terrain(side(n), 1, random), [&](const Point_3& p) {
          return Point_3(p.x() + offset, p.y() + offset, p.z() - offset);
        });
      } },
  };
  return kinds;
}

} // namespace test_meshes

#endif // MESH_KINDS_H
