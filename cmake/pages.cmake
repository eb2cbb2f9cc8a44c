# changeover_embedded_pages(<variable>)
#
# Stores in <variable> the object of a source that holds every file of web/dist, and docs/theorems.md: the program needs no
# files where it is installed. Without that folder it holds no pages, and the server says so.
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
    string(APPEND symbols "extern const char changeover_page_${number}[];\nextern const char changeover_page_${number}_end[];\n")
    string(APPEND rows "      {\"${file}\", {changeover_page_${number}, changeover_page_${number}_end}},\n")
    list(APPEND paths "${folder}/${file}")
    math(EXPR number "${number} + 1")
  endforeach()
  set(theorems "${PROJECT_SOURCE_DIR}/docs/theorems.md")
  list(APPEND paths "${theorems}")
  set(source "${PROJECT_BINARY_DIR}/generated/embedded_pages.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
// Generated. Do not edit.
#include "serve/api/about.hpp"
#include "serve/pages/pages.hpp"

__asm__(
    ".section .rodata\n"
@assembly@    ".globl changeover_theorems\n.hidden changeover_theorems\nchangeover_theorems:\n"
    ".incbin \"@theorems@\"\n"
    ".globl changeover_theorems_end\n.hidden changeover_theorems_end\nchangeover_theorems_end:\n.byte 0\n"
    ".previous\n");
extern "C" {
extern const char changeover_theorems[];
extern const char changeover_theorems_end[];
@symbols@}

namespace changeover::serve {

std::vector<EmbeddedPage> embedded_pages() {
  return {
@rows@  };
}

std::string_view theorems_text() { return {changeover_theorems, changeover_theorems_end}; }

}  // namespace changeover::serve
]])
  # ccache does not see what the assembler reads.
  set_source_files_properties("${source}" PROPERTIES OBJECT_DEPENDS "${paths}" SKIP_PRECOMPILE_HEADERS ON)
  add_library(changeover_pages OBJECT "${source}")
  target_compile_features(changeover_pages PRIVATE cxx_std_20)
  target_include_directories(changeover_pages PRIVATE "${PROJECT_SOURCE_DIR}/apps/changeover")
  set_target_properties(changeover_pages PROPERTIES CXX_COMPILER_LAUNCHER "" INTERPROCEDURAL_OPTIMIZATION OFF)
  set(${variable} "$<TARGET_OBJECTS:changeover_pages>" PARENT_SCOPE)
endfunction()
