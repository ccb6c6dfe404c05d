// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONTACTS_H
#define CONTACTS_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// What the barriers have in common.
namespace test_meshes {

using SMP::Level;
using SMP::internal::Block_vector;
using SMP::internal::Block_vectors;
using SMP::internal::Contact;
using SMP::internal::Contacts;

template <class Barrier>
Contacts contacts_at(Barrier& barrier, const Level::Uv& uv)
{
  Contacts result;
  barrier.add_contacts(uv, result);
  return result;
}

inline Block_vectors random_moves(std::size_t n, Random& random)
{
  Block_vectors moves;
  for (std::size_t v = 0; v < n; ++v)
    moves.emplace_back(random(-1, 1), random(-1, 1));
  return moves;
}

inline Level::Uv moved(Level::Uv uv, double t, const Block_vectors& moves)
{
  for (std::size_t v = 0; v < uv.size(); ++v)
    uv[v] = uv[v] + Vector_2(t * moves[v].x, t * moves[v].y);
  return uv;
}

// How the number that a contact's energy depends on changes, to first order.
inline double change(const Contact& c, const Block_vectors& moves)
{
  double result = 0;
  for (int i = 0; i < 3; ++i)
    result += inner_product(c.gradients[i], moves[c.vertices[i]]);
  return result;
}

// The first derivatives are those of the barrier's energy, the second ones those of the first, by differences.
template <class Barrier>
void expect_derivatives_of_energy(Barrier& barrier, const Level::Uv& uv)
{
  constexpr double h = 1e-8;
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const Block_vectors moves = random_moves(uv.size(), random);
    const Contacts contacts = contacts_at(barrier, uv), ahead = contacts_at(barrier, moved(uv, h, moves)),
                   behind = contacts_at(barrier, moved(uv, -h, moves));
    double slope = 0, size = 0;
    ASSERT_EQ(contacts.size(), ahead.size());
    ASSERT_EQ(contacts.size(), behind.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Contact& c = contacts[i];
      const double part = c.first * change(c, moves);
      slope += part;
      size += std::abs(part);
      EXPECT_NEAR((ahead[i].first - behind[i].first) / (2 * h), c.second * change(c, moves),
                  1e-4 * std::abs(c.second));
    }
    EXPECT_NEAR((barrier(moved(uv, h, moves)) - barrier(moved(uv, -h, moves))) / (2 * h), slope, 1e-4 * size);
  }
}

} // namespace test_meshes

#endif // CONTACTS_H
