// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Finds out where the unknowns of systems sit that a parameterizer numbers in a way of its own. A first system is put
// aside, and marks of its unknowns are given for a solution; the map that is made of these tells.
class Unknown_marks
{
public:
  typedef std::shared_ptr<const Sparse_rows<double>>   Rows;

  // Without this, marks are never given.
  void allow() { m_state = State::ALLOWED; }
  bool are_allowed() const { return m_state != State::NONE; }
  bool are_given() const { return m_state == State::GIVEN; }

  // Puts aside the rows of a system. Returns whether marks will be given for its solution: until they are read.
  bool put_aside(const Rows& rows)
  {
    if (m_state != State::ALLOWED && m_state != State::GIVEN)
      return false;
    m_state = State::GIVEN;
    m_rows = rows;
    return true;
  }

  // Gives the marks, and puts aside the right side. Returns false if it does not fit the rows.
  bool give(const std::vector<double>& right_side, std::vector<double>& solution)
  {
    if (!are_given() || right_side.size() != m_rows->number_of_rows())
      return false;
    m_right_side = right_side;
    solution.resize(right_side.size());
    for (std::size_t i = 0; i < solution.size(); ++i)
      solution[i] = Mesh_unknowns::mark(Index(i));
    return true;
  }

  // Reads them from the map that was made of them. Returns whether each vertex has its own.
  bool read(const std::vector<Point_2>& map, const Mesh_unknowns& unknowns)
  {
    m_state = State::READ;
    m_unknowns = unknowns.from_marks(m_rows->number_of_rows(), map);
    return !m_unknowns.empty();
  }

  // What was put aside.
  const Rows& rows() const { return m_rows; }
  const std::vector<double>& right_side() const { return m_right_side; }

  // What the unknowns are; empty if that was not read.
  const std::vector<Mesh_unknown>& unknowns() const { return m_unknowns; }

private:
  enum class State { NONE, ALLOWED, GIVEN, READ };

  State m_state = State::NONE;
  Rows m_rows;
  std::vector<double> m_right_side;
  std::vector<Mesh_unknown> m_unknowns;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWN_MARKS_H
