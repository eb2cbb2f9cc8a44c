# Installs `build`, and moves the tree to `prefix`: its users must still find everything. Nothing in it
# names the folders it was made in.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${work}/installed" "${prefix}")
execute_process(COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
  COMMAND "${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/installed")
file(RENAME "${work}/installed" "${prefix}")
# Other builds name their sources, for debuggers and reports.
if(build_type STREQUAL "Release" AND NOT flags)
  find_program(grep NAMES grep REQUIRED)
  foreach(folder IN ITEMS "${source}" "${build}" "${work}")
    execute_process(COMMAND "${grep}" -rlF -- "${folder}" "${prefix}" OUTPUT_VARIABLE found)
    if(found)
      message(FATAL_ERROR "${folder}, where this was built, is named in\n${found}")
    endif()
  endforeach()
endif()
