// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPRESSED_LISTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPRESSED_LISTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A list of items for each of the keys 0, 1, 2, ..., all in one array.
template <class Item>
class Compressed_lists
{
public:
  Compressed_lists() = default;

  // A counting sort. `for_each_item(add)` calls add(key, item) for every item; it is called twice. The items of a key
  // keep that order.
  template <class For_each_item>
  Compressed_lists(std::size_t number_of_keys, const For_each_item& for_each_item) : m_first(number_of_keys + 2, 0)
  {
    for_each_item([this](Index key, const Item&) { ++m_first[key + 2]; });
    for (std::size_t k = 2; k < m_first.size(); ++k)
      m_first[k] += m_first[k - 1];
    m_items.resize(m_first.back());
    for_each_item([this](Index key, const Item& item) { m_items[m_first[key + 1]++] = item; });
  }

  boost::iterator_range<const Item*> operator[](std::size_t key) const
  {
    return { m_items.data() + m_first[key], m_items.data() + m_first[key + 1] };
  }

  // Those of all keys, one list after the other.
  const std::vector<Item>& items() const { return m_items; }

private:
  std::vector<Index> m_first;       // where each list begins and, at last, twice where all end
  std::vector<Item> m_items;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPRESSED_LISTS_H
