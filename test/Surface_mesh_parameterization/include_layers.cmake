# The floors of the package, and (as a script) the check that no header includes one from a floor above its own or
# takes part in a circle, and that the table and the include folder hold the same headers.

cmake_minimum_required(VERSION 3.18...3.25)

set(table "
0 As_rigid_as_possible_energy_2.h
0 Distortion_derivatives_2.h
0 MIPS_energy_2.h
0 Symmetric_Dirichlet_energy_2.h
0 internal/Scale_bounded_energy_2.h
0 Flip_policy.h
0 Triangle_weight.h
0 parameters.h
0 Refinement_options.h
0 Parameterization_summary.h
0 error_message.h
0 internal/flat_types.h
0 internal/Loops.h
0 internal/prefetch.h
0 internal/Sparse_rows.h
0 internal/Sparse_matrix.h
0 internal/Constraint_elimination.h
0 internal/Incomplete_LU.h
0 internal/Krylov_methods.h
0 internal/Direct_solver.h
0 internal/Component_map.h
0 internal/Block_matrix.h
0 internal/conjugate_gradients.h
0 internal/corner_hessian.h
0 internal/Polygon_kernel_2.h
0 internal/Rest_triangle.h
0 internal/Mapped_triangle.h
0 internal/Relaxation_factor.h
0 Uniform_edge_weights_3.h
0 Chordal_edge_weights_3.h
0 Harmonic_edge_weights_3.h
0 Mean_value_edge_weights_3.h
1 internal/One_rings.h
1 internal/Ring_mesh.h
1 internal/Unit_edge_metric.h
1 internal/Star.h
1 internal/star_validity.h
1 internal/border_crossings.h
1 internal/overlapping_pairs.h
1 internal/discrete_exponential_map.h
1 Shape_preserving_edge_weights_3.h
1 internal/Halfedge_collapse.h
1 internal/Vertex_inserter.h
1 internal/relax_vertex.h
2 Triangulated_surface_3.h
2 Mesh_component.h
2 internal/Vertex_hierarchy.h
2 internal/Face_hierarchy.h
2 Collapse_hierarchy_3.h
2 Progressive_mesh_3.h
2 Level.h
2 parameterization_quality.h
2 internal/Collapse_group.h
2 internal/Hierarchy_builder.h
2 Hierarchy_visitor_3.h
2 internal/longest_border.h
2 internal/Filled_mesh.h
2 internal/pinned_vertices.h
2 internal/place_border.h
2 internal/write_map.h
2 internal/Hierarchy_interpolation.h
2 internal/Pruned_prolongation.h
2 internal/Galerkin_product.h
2 internal/Grid_transfer.h
2 internal/Mesh_system.h
2 internal/Mesh_unknowns.h
2 IO/write_SVG.h
2 IO/write_OBJ.h
3 internal/Level_energy.h
3 internal/Vertex_relaxation.h
3 internal/Border_guard.h
3 internal/Border_barrier.h
3 internal/separate_borders.h
3 internal/V_cycle.h
3 internal/Multigrid_preconditioner.h
3 internal/Multigrid_linear_solver.h
3 internal/Multigrid_session.h
3 internal/Constrained_session.h
3 internal/Newton_multigrid.h
3 internal/Newton_system.h
3 internal/Level_refiner.h
3 internal/Edge_system.h
3 internal/solve_directly.h
3 internal/Conformal_refiner.h
3 internal/insert_new_vertices.h
3 internal/scale_to_area.h
3 internal/Tutte_embedding.h
3 internal/Map_repair.h
3 internal/settle_flips.h
4 settle_flips.h
4 internal/Nested_iteration.h
4 Refinable_parameterizer_base_3.h
4 Distortion_parameterizer_3.h
4 As_rigid_as_possible_parameterizer_3.h
4 MIPS_parameterizer_3.h
4 Symmetric_Dirichlet_parameterizer_3.h
4 Edge_energy_parameterizer_3.h
5 Nested_iteration_parameterizer_3.h
5 Multigrid_solver_traits.h
5 Rebind_solver.h
5 internal/Solver_use.h
5 internal/Rebound_run.h
5 internal/Rebound_parameterizer_base_3.h
5 internal/Rebound_parameterizer_3.h
5 internal/Rebound_as_rigid_as_possible_3.h
5 internal/Rebound_orbifold_parameterizer_3.h
6 Hierarchical_parameterizer_3.h
6 hierarchical_parameterization.h
")

string(REGEX MATCHALL "[0-9] [^\n]+" rows "${table}")
set(headers "")
foreach(row IN LISTS rows)
  string(REGEX MATCH "^([0-9]) (.*)$" row "${row}")
  list(APPEND headers ${CMAKE_MATCH_2})
  set(floor_of_${CMAKE_MATCH_2} ${CMAKE_MATCH_1})
endforeach()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

set(faults "")
set(prefix CGAL/Surface_mesh_parameterization)
get_filename_component(include_dir ${CMAKE_CURRENT_LIST_DIR}/../../include ABSOLUTE)
file(GLOB_RECURSE found RELATIVE ${include_dir} ${include_dir}/*)
list(TRANSFORM headers PREPEND ${prefix}/ OUTPUT_VARIABLE expected)
foreach(file IN LISTS found)
  if(NOT file IN_LIST expected)
    list(APPEND faults "${file} is not in the table")
  endif()
endforeach()

foreach(header IN LISTS headers)
  set(below_${header} "")
  if(NOT "${prefix}/${header}" IN_LIST found)
    list(APPEND faults "${header} is in the table only")
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
      list(APPEND below_${header} ${included})
      if(floor_of_${included} GREATER floor_of_${header})
        list(APPEND faults "${header} (${floor_of_${header}}) includes ${included} (${floor_of_${included}})")
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
