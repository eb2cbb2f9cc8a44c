# changeover_build_information(<variable>)
#
# Makes the source of what the program says about its build
# (apps/changeover/shell/build_information.hpp) and stores its path in
# <variable>.

# changeover_debian_version(<variable> <file>): the version of the Debian package that brought
# <file>, or nothing.
function(changeover_debian_version variable file)
  set(${variable} "" PARENT_SCOPE)
  find_program(CHANGEOVER_DPKG_QUERY dpkg-query)
  mark_as_advanced(CHANGEOVER_DPKG_QUERY)
  if(NOT CHANGEOVER_DPKG_QUERY)
    return()
  endif()
  execute_process(COMMAND "${CHANGEOVER_DPKG_QUERY}" -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET)
  if(NOT owner MATCHES "^([^,\n]+): ")
    return()
  endif()
  execute_process(COMMAND "${CHANGEOVER_DPKG_QUERY}" -W -f "\${Version}" "${CMAKE_MATCH_1}"
    OUTPUT_VARIABLE found ERROR_QUIET)
  set(${variable} "${found}" PARENT_SCOPE)
endfunction()

function(changeover_build_information variable)
  changeover_debian_version(cadical "${CaDiCaL_LIBRARY}")
  set(sanitizers "")
  if(CHANGEOVER_SANITIZE)
    set(sanitizers "${CHANGEOVER_SANITIZE}")
  endif()
  string(TIMESTAMP date "%Y-%m-%d" UTC)
  set(source "${PROJECT_BINARY_DIR}/generated/build_information.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Generated. Do not edit.
#include "shell/build_information.hpp"

namespace changeover::cli {

const BuildInformation& build_information() {
  static const BuildInformation information{
      .date = "@date@",
      .compiler = "@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@",
      .build_type = "@CMAKE_BUILD_TYPE@",
      .sanitizers = "@sanitizers@",
      .cadical = "@cadical@",
      .nlohmann_json = "@nlohmann_json_VERSION@"};
  return information;
}

}  // namespace changeover::cli
]])
  set(${variable} "${source}" PARENT_SCOPE)
endfunction()
