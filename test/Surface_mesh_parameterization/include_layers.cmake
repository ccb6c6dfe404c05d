# The layers of the package, and (as a script) the check that no header includes one from a layer above its own or takes
# part in a circle. That X.h includes the X_impl.h that implements it, where the package is header-only, is no circle.

cmake_minimum_required(VERSION 3.18...3.25)

# From the lowest to the highest: a folder of internal/, and the public headers that stand beside it.
set(layers
  "core: parameters Option_defaults Parameterization_summary Parameterization_progress Atlas_progress error_message
         Flip_policy Triangle_weight Refinement_options Triangulated_surface_3 Distortion_derivatives_2 Rebind_solver
         concepts MIPS_energy_2 Symmetric_Dirichlet_energy_2 As_rigid_as_possible_energy_2 Uniform_edge_weights_3
         Chordal_edge_weights_3"
  "star: Harmonic_edge_weights_3 Mean_value_edge_weights_3 Shape_preserving_edge_weights_3"
  "mesh: Mesh_component IO/write_OBJ IO/write_SVG"
  "hierarchy: Collapse_hierarchy_3 Progressive_mesh_3 Level Hierarchy_visitor_3"
  "border: parameterization_quality"
  "linear:"
  "newton:"
  "levels: settle_flips Refinable_parameterizer_base_3 Distortion_parameterizer_3 MIPS_parameterizer_3
           Symmetric_Dirichlet_parameterizer_3 As_rigid_as_possible_parameterizer_3 Nested_iteration_parameterizer_3"
  "edge_energy: Edge_energy_parameterizer_3"
  "wrapped: Multigrid_solver_traits Hierarchical_parameterizer_3 hierarchical_parameterization"
  "cut: cut_to_disk"
  "pack: Atlas_summary pack_charts atlas_parameterization atlas_quality")

set(prefix CGAL/Surface_mesh_parameterization)
get_filename_component(include_dir ${CMAKE_CURRENT_LIST_DIR}/../../include ABSOLUTE)
file(GLOB_RECURSE headers RELATIVE ${include_dir}/${prefix} ${include_dir}/${prefix}/*.h)

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

set(faults "")
set(number 0)
foreach(layer IN LISTS layers)
  string(REGEX MATCHALL "[^: \n]+" names "${layer}")
  list(POP_FRONT names folder)
  foreach(name IN LISTS names)
    set(layer_of_${name}.h ${number})
    if(NOT "${name}.h" IN_LIST headers)
      list(APPEND faults "${name}.h is in the table only")
    endif()
  endforeach()
  foreach(header IN LISTS headers)
    if(header MATCHES "^internal/${folder}/[^/]+$")
      set(layer_of_${header} ${number})
    endif()
  endforeach()
  math(EXPR number "${number} + 1")
endforeach()

foreach(header IN LISTS headers)
  set(below_${header} "")
  if(NOT DEFINED layer_of_${header})
    list(APPEND faults "${header} is in no layer")
    continue()
  endif()
  file(READ ${include_dir}/${prefix}/${header} text)
  string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*[<\"][^>\"\n]+" includes "\n${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE ".*([<\"])" "\\1" include "${include}")
    if(include MATCHES "^\"")
      list(APPEND faults "${header} includes ${include}\" in quotes")
    endif()
    string(REPLACE "<${prefix}/" "" included "${include}")
    if(included IN_LIST headers) # else it is CGAL's, Eigen's or the standard library's
      string(REGEX REPLACE ".*/|_impl\\.h$|\\.h$" "" implemented "${included}")
      string(REGEX REPLACE ".*/|\\.h$" "" name "${header}")
      if(NOT (included MATCHES "_impl\\.h$" AND implemented STREQUAL name))
        list(APPEND below_${header} ${included})
      endif()
      if(layer_of_${included} GREATER layer_of_${header})
        list(APPEND faults
          "${header} (layer ${layer_of_${header}}) includes ${included} (layer ${layer_of_${included}})")
      endif()
    endif()
  endforeach()
endforeach()

# Take away headers that include no other one that is left; a circle is left over.
set(left ${headers})
set(before "")
while(NOT "${left}" STREQUAL "${before}")
  set(before ${left})
  foreach(header IN LISTS before)
    set(free TRUE)
    foreach(included IN LISTS below_${header})
      if(included IN_LIST left)
        set(free FALSE)
      endif()
    endforeach()
    if(free)
      list(REMOVE_ITEM left ${header})
    endif()
  endforeach()
endwhile()
if(left)
  list(JOIN left " " left)
  list(APPEND faults "a circle among these or under them: ${left}")
endif()

if(faults)
  list(JOIN faults "\n  " faults)
  message(FATAL_ERROR "Include layers:\n  ${faults}")
endif()
