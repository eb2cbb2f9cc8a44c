# changeover_embedded_pages(<variable>)
#
# Stores in <variable> the object of a source that holds every file of web/dist, docs/theorems.md
# and the map of the catalog: the program needs no files where it is installed. Without that folder
# it holds no pages, and the server says so.
function(changeover_embedded_pages variable)
  set(folder "${PROJECT_SOURCE_DIR}/web/dist")
  file(GLOB_RECURSE files RELATIVE "${folder}" CONFIGURE_DEPENDS "${folder}/*")
  list(SORT files)
  set(assembly "")
  set(symbols "")
  set(rows "")
  set(paths "")
  set(number 0)
  foreach(file IN LISTS files)
    if(NOT file MATCHES "^[A-Za-z0-9_./-]+$")
      message(FATAL_ERROR "web/dist/${file}: names of pages have letters, digits, _ . - and / only")
    endif()
    string(APPEND assembly
      "    \".globl changeover_page_${number}\\n.hidden changeover_page_${number}\\nchangeover_page_${number}:\\n\"\n"
      "    \".incbin \\\"${folder}/${file}\\\"\\n\"\n"
      "    \".globl changeover_page_${number}_end\\n.hidden changeover_page_${number}_end\\nchangeover_page_${number}_end:\\n.byte 0\\n\"\n")
    string(APPEND symbols
      "extern const char changeover_page_${number}[];\nextern const char changeover_page_${number}_end[];\n")
    string(APPEND rows
      "      {\"${file}\", {changeover_page_${number}, changeover_page_${number}_end}},\n")
    list(APPEND paths "${folder}/${file}")
    math(EXPR number "${number} + 1")
  endforeach()
  set(theorems "${PROJECT_SOURCE_DIR}/docs/theorems.md")
  list(APPEND paths "${theorems}")
  # To make the map takes seconds, and a minute without optimisation: such builds make it when it is
  # asked for.
  set(atlases "${PROJECT_BINARY_DIR}/generated/atlases.txt")
  list(APPEND paths "${atlases}")
  if(CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo|MinSizeRel)$" AND NOT CHANGEOVER_SANITIZE)
    add_executable(make_atlases "${PROJECT_SOURCE_DIR}/cmake/make_atlases.cpp")
    set_target_properties(make_atlases PROPERTIES RUNTIME_OUTPUT_DIRECTORY
      "${CMAKE_CURRENT_BINARY_DIR}")
    target_link_libraries(make_atlases PRIVATE changeover_construct changeover_internals
      changeover_warnings)
    add_custom_command(OUTPUT "${atlases}" COMMAND make_atlases "${atlases}" DEPENDS make_atlases
      COMMENT "Making the map of the catalog" VERBATIM)
  else()
    file(CONFIGURE OUTPUT "${atlases}" CONTENT "")
  endif()
  set(source "${PROJECT_BINARY_DIR}/generated/embedded_pages.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Generated. Do not edit.
#include "answer/known/theorems.hpp"
#include "serve/api/about.hpp"
#include "serve/pages/pages.hpp"

__asm__(
    ".section .rodata\n"
@assembly@    ".globl changeover_theorems\n.hidden changeover_theorems\nchangeover_theorems:\n"
    ".incbin \"@theorems@\"\n"
    ".globl changeover_theorems_end\n.hidden changeover_theorems_end\nchangeover_theorems_end:\n.byte 0\n"
    ".globl changeover_atlases\n.hidden changeover_atlases\nchangeover_atlases:\n"
    ".incbin \"@atlases@\"\n"
    ".globl changeover_atlases_end\n.hidden changeover_atlases_end\nchangeover_atlases_end:\n.byte 0\n"
    ".previous\n");
extern "C" {
extern const char changeover_theorems[];
extern const char changeover_theorems_end[];
extern const char changeover_atlases[];
extern const char changeover_atlases_end[];
@symbols@}

namespace changeover::serve {

std::vector<EmbeddedPage> embedded_pages() {
  return {
@rows@  };
}

std::string_view stored_atlases() { return {changeover_atlases, changeover_atlases_end}; }

}  // namespace changeover::serve

namespace changeover::cli {

std::string_view theorems_text() { return {changeover_theorems, changeover_theorems_end}; }

}  // namespace changeover::cli
]])
  # ccache does not see what the assembler reads.
  set_source_files_properties("${source}" PROPERTIES OBJECT_DEPENDS "${paths}"
    SKIP_PRECOMPILE_HEADERS ON)
  add_library(changeover_pages OBJECT "${source}")
  target_compile_features(changeover_pages PRIVATE cxx_std_20)
  target_include_directories(changeover_pages PRIVATE "${PROJECT_SOURCE_DIR}/apps/changeover")
  set_target_properties(changeover_pages PROPERTIES CXX_COMPILER_LAUNCHER ""
    INTERPROCEDURAL_OPTIMIZATION OFF)
  set(${variable} "$<TARGET_OBJECTS:changeover_pages>" PARENT_SCOPE)
endfunction()
