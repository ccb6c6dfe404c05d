// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FUNCTION_REF_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FUNCTION_REF_H

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// A reference to a function object of any type. Unlike std::function it owns nothing and costs next to nothing to
// compile; the object has to outlive it.
template <class Signature>
class Function_ref;

template <class Result, class... Arguments>
class Function_ref<Result(Arguments...)>
{
public:
  template <class Function, class = std::enable_if_t<!std::is_same<Function, Function_ref>::value>>
  Function_ref(const Function& f)
    : m_object(&f), m_call([](const void* object, Arguments... arguments) -> Result {
        return (*static_cast<const Function*>(object))(arguments...);
      })
  { }

  Result operator()(Arguments... arguments) const { return m_call(m_object, arguments...); }

private:
  const void* m_object;
  Result (*m_call)(const void*, Arguments...);
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FUNCTION_REF_H
