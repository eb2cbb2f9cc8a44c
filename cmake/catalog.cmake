# changeover_shipped_catalog(<variable>)
#
# Makes the database of the designs that come with the program from the lines in catalog/, and
# stores the path of a source that holds it in <variable>: the library needs no files where it is
# installed. The program that makes it links the rooms below construct/, which is who has the
# database.
function(changeover_shipped_catalog variable)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/catalog/*.jsonl")
  list(SORT files)
  add_executable(make_catalog "${PROJECT_SOURCE_DIR}/cmake/make_catalog.cpp")
  target_link_libraries(make_catalog PRIVATE changeover_catalog changeover_warnings)

  set(image "${PROJECT_BINARY_DIR}/generated/shipped_catalog.db")
  add_custom_command(OUTPUT "${image}"
    COMMAND make_catalog "${image}" ${files}
    DEPENDS make_catalog ${files}
    COMMENT "Making the catalog's database" VERBATIM)

  # The assembler takes the bytes as they are: a compiler would need minutes for them.
  set(source "${PROJECT_BINARY_DIR}/generated/shipped_catalog.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Generated. Do not edit.
#include "construct/shipped_catalog.hpp"

__asm__(
    ".section .rodata\n"
    ".balign 4096\n"
    ".globl changeover_shipped_catalog\n"
    ".hidden changeover_shipped_catalog\n"
    "changeover_shipped_catalog:\n"
    ".incbin \"@image@\"\n"
    ".globl changeover_shipped_catalog_end\n"
    ".hidden changeover_shipped_catalog_end\n"
    "changeover_shipped_catalog_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const std::byte changeover_shipped_catalog[];
extern const std::byte changeover_shipped_catalog_end[];
}

namespace changeover {

std::span<const std::byte> shipped_catalog() {
  return {changeover_shipped_catalog, changeover_shipped_catalog_end};
}

}  // namespace changeover
]])
  # ccache does not see what the assembler reads.
  set_source_files_properties("${source}" PROPERTIES
    OBJECT_DEPENDS "${image}" SKIP_PRECOMPILE_HEADERS ON)
  add_library(changeover_shipped OBJECT "${source}")
  target_include_directories(changeover_shipped PRIVATE "${PROJECT_SOURCE_DIR}/src")
  set_target_properties(changeover_shipped PROPERTIES CXX_COMPILER_LAUNCHER ""
    INTERPROCEDURAL_OPTIMIZATION OFF)
  set(${variable} "$<TARGET_OBJECTS:changeover_shipped>" PARENT_SCOPE)
endfunction()
