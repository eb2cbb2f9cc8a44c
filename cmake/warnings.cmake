# Warnings for our own code. Linked as $<BUILD_INTERFACE:changeover_warnings>, so that code which
# uses the installed libraries never sees them.

add_library(changeover_warnings INTERFACE)
target_compile_options(changeover_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  $<$<BOOL:${CHANGEOVER_WERROR}>:-Werror>)
if(CHANGEOVER_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # What the sanitizers put in between hides from GCC 12 that std::function is initialised, in <regex> too.
  target_compile_options(changeover_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
