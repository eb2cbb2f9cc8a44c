# Warnings for our own code. Linked as $<BUILD_INTERFACE:changeover_warnings>, so that code which
# uses the installed libraries never sees them.

add_library(changeover_warnings INTERFACE)
target_compile_options(changeover_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  $<$<BOOL:${CHANGEOVER_WERROR}>:-Werror>)
