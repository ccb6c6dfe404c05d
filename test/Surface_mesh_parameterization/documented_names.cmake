# Checks that the manual has every named parameter and every option of the program, and no others:
# cmake -P documented_names.cmake

cmake_minimum_required(VERSION 3.18...3.25)

set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
set(manual ${root}/doc/Surface_mesh_parameterization)

# read_names(VARIABLE FILE REGULAR_EXPRESSION): what its part in parentheses matches in the file, each once.
function(read_names variable file regular_expression)
  file(READ ${file} text)
  string(REGEX MATCHALL "${regular_expression}" names "${text}")
  list(TRANSFORM names REPLACE "${regular_expression}" "\\1")
  list(REMOVE_DUPLICATES names)
  if(NOT names)
    message(SEND_ERROR "no names were found in ${file}")
  endif()
  set(${variable} ${names} PARENT_SCOPE)
endfunction()

# expect_each(NAMES KNOWN TEXT): each of the names is one of the known ones; else an error says so.
function(expect_each names known text)
  foreach(name IN LISTS ${names})
    if(NOT name IN_LIST ${known})
      message(SEND_ERROR "${text}: ${name}")
    endif()
  endforeach()
endfunction()

read_names(parameters ${root}/include/CGAL/Surface_mesh_parameterization/parameters.h "X\\(([a-z_]+), [a-z_]+_t\\)")
read_names(documented_parameters ${manual}/Named_parameters.txt "\n\\| `([a-z_]+)` \\|")
expect_each(parameters documented_parameters "a named parameter that Named_parameters.txt does not have")
expect_each(documented_parameters parameters "a named parameter that only Named_parameters.txt has")

read_names(options ${root}/examples/hierarchical_parameterization/describe_options.cpp "add\\(\"([a-z-]+)[,\"]")
read_names(table_of_options ${manual}/Program.txt "\n\\| `--([a-z-]+)` \\|")
set(options_in_table ${options})
list(REMOVE_ITEM options_in_table help version)
expect_each(options_in_table table_of_options "an option that Program.txt does not have")
foreach(page Program Named_parameters)
  read_names(mentioned_options ${manual}/${page}.txt "`--([a-z-]+)")
  expect_each(mentioned_options options "an option that only ${page}.txt has")
endforeach()
