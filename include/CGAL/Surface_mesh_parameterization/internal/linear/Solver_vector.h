// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_VECTOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_VECTOR_H

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Finds the numbers of vectors that were put off.
class Deferring_solver
{
public:
  virtual ~Deferring_solver() = default;
  virtual void solve_now() = 0;
};

// A vector of doubles, a model of `SparseLinearAlgebraTraits_d::Vector`. A solver may put off to find its numbers: they
// are found when one of them is read.
class Solver_vector
{
public:
  typedef double   NT;

  struct Numbers
  {
    std::vector<double> values;
    Deferring_solver* solver = nullptr;       // who has still to find the values; it lives at least until it has
  };

  explicit Solver_vector(std::size_t dimension = 0) : m_numbers(std::make_shared<Numbers>())
  {
    m_numbers->values.resize(dimension, 0.);
  }

  Solver_vector(const Solver_vector& other) : m_numbers(std::make_shared<Numbers>())
  {
    m_numbers->values = other.values();
  }

  Solver_vector& operator=(const Solver_vector& other)
  {
    if (this != &other)
      *this = Solver_vector(other);
    return *this;
  }

  Solver_vector(Solver_vector&&) = default;
  Solver_vector& operator=(Solver_vector&&) = default;

  int dimension() const { return int(size()); }
  std::size_t size() const { return m_numbers->values.size(); }

  double operator[](std::size_t i) const { return values()[i]; }
  double& operator[](std::size_t i) { return values()[i]; }
  double operator()(std::size_t i) const { return values()[i]; }      // as Orbifold_Tutte_parameterizer_3 reads it
  void set(std::size_t i, double value) { values()[i] = value; }

  const std::vector<double>& values() const { return found()->values; }
  std::vector<double>& values() { return found()->values; }

  // For the solver that puts them off.
  const std::shared_ptr<Numbers>& numbers() { return m_numbers; }

private:
  const std::shared_ptr<Numbers>& found() const
  {
    if (m_numbers->solver)
      m_numbers->solver->solve_now();
    return m_numbers;
  }

  std::shared_ptr<Numbers> m_numbers;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_VECTOR_H
