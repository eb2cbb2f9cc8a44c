# Warnings for our own code. Linked as $<BUILD_INTERFACE:changeover_warnings>, so that code which
# uses the installed libraries never sees them. What sanitizers put in between makes GCC warn of values
# that are initialised and of bounds that are kept, in the standard library too: with them no warning is an error.

add_library(changeover_warnings INTERFACE)
target_compile_options(changeover_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion)
if(CHANGEOVER_WERROR AND NOT CHANGEOVER_SANITIZE)
  target_compile_options(changeover_warnings INTERFACE -Werror)
endif()
