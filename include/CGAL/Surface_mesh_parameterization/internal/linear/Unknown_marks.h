// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Finds out where the unknowns of systems sit that a parameterizer numbers in a way of its own. A first system is put
// aside, and marks of its unknowns are given for a solution; the map that is made of these tells.
class Unknown_marks
{
public:
  // Without this, marks are never given.
  void allow() { m_state = State::ALLOWED; }
  bool are_allowed() const { return m_state != State::NONE; }
  bool are_given() const { return m_state == State::GIVEN; }

  // Puts aside a system of so many unknowns. Returns whether marks will be given for its solution: until they are read.
  bool put_aside(std::size_t number_of_unknowns)
  {
    if (m_state != State::ALLOWED && m_state != State::GIVEN)
      return false;
    m_state = State::GIVEN;
    m_number_of_unknowns = number_of_unknowns;
    return true;
  }

  // Gives the marks. Returns false if the right side does not fit the system.
  bool give(const std::vector<double>& right_side, std::vector<double>& solution) const
  {
    if (!are_given() || right_side.size() != m_number_of_unknowns)
      return false;
    solution.resize(m_number_of_unknowns);
    for (std::size_t i = 0; i < m_number_of_unknowns; ++i)
      solution[i] = Mesh_unknowns::mark(Index(i));
    return true;
  }

  // Reads them from the map that was made of them.
  void read(const std::vector<Point_2>& map, const Mesh_unknowns& unknowns)
  {
    m_state = State::READ;
    m_unknowns = unknowns.from_marks(m_number_of_unknowns, map);
  }

  // What the unknowns are; empty if that was not read, or if vertices have no marks of their own.
  const std::vector<Mesh_unknown>& unknowns() const { return m_unknowns; }

private:
  enum class State { NONE, ALLOWED, GIVEN, READ };

  State m_state = State::NONE;
  std::size_t m_number_of_unknowns = 0;
  std::vector<Mesh_unknown> m_unknowns;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H
