# changeover_generate_found_designs(<variable>)
#
# Writes found_designs_files.cpp, which holds the text of every src/construct/found/*.txt, and stores
# its path in <variable>: the library needs no files where it is installed.
function(changeover_generate_found_designs variable)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/construct/found/*.txt")
  list(SORT files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  list(LENGTH files count)
  set(values "")
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    cmake_path(GET file FILENAME name)
    string(APPEND values "    {\"${name}\",\n     R\"found(${text})found\"},\n")
  endforeach()
  set(output "${PROJECT_BINARY_DIR}/generated/found_designs_files.cpp")
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT [[
// Generated from the files in src/construct/found. Do not edit.
#include <array>

#include "construct/found/found_designs.hpp"

namespace changeover {

std::span<const FoundFile> found_design_files() {
  static const std::array<FoundFile, @count@> files{{
@values@  }};
  return files;
}

}  // namespace changeover
]])
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()
