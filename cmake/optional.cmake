# An optional part never breaks the build: what it needs is tried first, in a separate project and
# a separate CMake process. Half of a package makes CMake's own modules and package files end the
# configuration; so it ends there.

# changeover_try_optional(<variable> <name> <project> <source>)
#
# Sets <variable> to whether a project with the lines <project>, which may link the target `tried`
# that is made of <source>, can be configured and built. Where it cannot, the reason is in a log
# that a line names; it is tried again whenever this is configured.
function(changeover_try_optional variable name project source)
  set(${variable} TRUE PARENT_SCOPE)
  if(CHANGEOVER_${name}_WORKS)
    return()
  endif()
  set(folder "${PROJECT_BINARY_DIR}/optional/${name}")
  file(REMOVE_RECURSE "${folder}")
  file(WRITE "${folder}/tried.cpp" "${source}\n")
  file(WRITE "${folder}/CMakeLists.txt"
    "cmake_minimum_required(VERSION 3.25)\nproject(tried LANGUAGES C CXX)\n${project}\n")
  # What a user names for the whole build counts here, too.
  get_cmake_property(variables CACHE_VARIABLES)
  list(FILTER variables INCLUDE REGEX
       "^(CMAKE_(C|CXX)_COMPILER|CMAKE_(C|CXX)_FLAGS|CMAKE_MAKE_PROGRAM|CMAKE_PREFIX_PATH|CMAKE_TOOLCHAIN_FILE|MPI.*|Python.*|pybind11.*)$")
  set(settings)
  foreach(each IN LISTS variables)
    if(NOT "${${each}}" STREQUAL "")
      string(REPLACE ";" "\\;" value "${${each}}")  # a list stays one argument
      list(APPEND settings "-D${each}=${value}")
    endif()
  endforeach()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${folder}" -B "${folder}/build" -G "${CMAKE_GENERATOR}"
    ${settings}
    RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT failed)
    execute_process(COMMAND "${CMAKE_COMMAND}" --build "${folder}/build"
      RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
  endif()
  if(failed)
    file(WRITE "${folder}/log" "${log}")
    message(STATUS "${name} is left out: it is not installed, or not all of it (${folder}/log)")
    set(${variable} FALSE PARENT_SCOPE)
  else()
    set(CHANGEOVER_${name}_WORKS TRUE CACHE INTERNAL "${name} was tried")
  endif()
endfunction()
