# changeover_generate_registry(<variable>)
#
# Writes registry_entries.cpp, which lists every construction, and stores its path in <variable>.
# Each src/construct/entries/**/NAME.cpp defines
# `const Construction& construction()` in namespace changeover::NAME_entry; the list is sorted by
# NAME.
#
# The list is generated rather than collected by objects that register themselves: a linker takes
# from a static library only the object files that something refers to, so a self-registering
# construction would silently be missing from every program. Here each one is referred to by name,
# the order does not depend on initialisation, and adding a construction still touches one file.
function(changeover_generate_registry variable)
  file(GLOB_RECURSE entries CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/construct/entries/*.cpp")

  set(names)
  foreach(entry IN LISTS entries)
    cmake_path(GET entry STEM LAST_ONLY name)
    if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "${entry}: the file's name must be lower-case words joined by '_'")
    endif()
    list(APPEND names ${name})
  endforeach()
  list(SORT names)

  set(declarations "")
  set(values "")
  foreach(name IN LISTS names)
    string(APPEND declarations "namespace ${name}_entry { const Construction& construction(); }\n")
    string(APPEND values "      &${name}_entry::construction(),\n")
  endforeach()

  set(file "${PROJECT_BINARY_DIR}/generated/registry_entries.cpp")
  file(CONFIGURE OUTPUT "${file}" @ONLY CONTENT [[
// Generated from the files in src/construct/entries. Do not edit.
#include <vector>

#include "changeover/construct/registry.hpp"

namespace changeover {

@declarations@
std::vector<const Construction*> registry_entries() {
  return {
@values@  };
}

}  // namespace changeover
]])
  set(${variable} "${file}" PARENT_SCOPE)
endfunction()
