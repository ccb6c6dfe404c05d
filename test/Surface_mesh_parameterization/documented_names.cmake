# Checks that the manual has every named parameter and every option of the program: cmake -P documented_names.cmake

cmake_minimum_required(VERSION 3.18...3.25)

set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
set(manual ${root}/doc/Surface_mesh_parameterization)

# check(PAGE PREFIX NAMES...): the page has each name in quotes.
function(check page prefix)
  file(READ ${manual}/${page} text)
  if(NOT ARGN)
    message(SEND_ERROR "no names were found for ${page}")
  endif()
  foreach(name IN LISTS ARGN)
    string(FIND "${text}" "`${prefix}${name}`" position)
    if(position EQUAL -1)
      message(SEND_ERROR "${page} does not have `${prefix}${name}`")
    endif()
  endforeach()
endfunction()

file(READ ${root}/include/CGAL/Surface_mesh_parameterization/parameters.h parameters)
string(REGEX MATCHALL "X\\([a-z_]+, [a-z_]+_t\\)" names "${parameters}")
list(TRANSFORM names REPLACE "X\\(([a-z_]+), .*" "\\1")
check(Named_parameters.txt "" ${names})

file(READ ${root}/examples/hierarchical_parameterization/describe_options.cpp options)
string(REGEX MATCHALL "add\\(\"[a-z-]+\"" names "${options}")
list(TRANSFORM names REPLACE "add\\(\"([a-z-]+)\"" "\\1")
list(REMOVE_ITEM names version)
check(Program.txt "--" ${names})
