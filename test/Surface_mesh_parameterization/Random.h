// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_H
#define RANDOM_H

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test_meshes {

// The same numbers everywhere; std::uniform_real_distribution and std::shuffle do not promise that.
class Random
{
public:
  explicit Random(unsigned int seed) : m_generator(seed) { }
  double operator()(double from, double to) { return from + (to - from) * (double(m_generator()) / 4294967296.); }
  // with evenly spread logarithms
  double power(double from, double to) { return from * std::pow(to / from, (*this)(0, 1)); }
  std::size_t below(std::size_t n) { return std::size_t((*this)(0, double(n))); }
  unsigned int seed() { return unsigned(below(1000000)); }

  template <class T>
  void shuffle(std::vector<T>& list)
  {
    for (std::size_t i = list.size(); i > 1; --i)
      std::swap(list[i - 1], list[below(i)]);
  }

private:
  std::mt19937 m_generator;
};

} // namespace test_meshes

#endif // RANDOM_H
