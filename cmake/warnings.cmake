# Warnings for our own code. Linked as $<BUILD_INTERFACE:changeover_warnings>, so that code which
# uses the installed libraries never sees them.

add_library(changeover_warnings INTERFACE)
target_compile_options(changeover_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion)
if(CHANGEOVER_WERROR)
  target_compile_options(changeover_warnings INTERFACE -Werror)
  if(CHANGEOVER_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What sanitizers put in between makes GCC warn of values that are initialised and of bounds
    # that are kept, in the standard library too. What it guesses from the flow of values is then
    # no error; all other warnings are.
    foreach(guess array-bounds dangling-pointer free-nonheap-object maybe-uninitialized nonnull
        null-dereference restrict stringop-overflow stringop-overread stringop-truncation
        uninitialized use-after-free)
      target_compile_options(changeover_warnings INTERFACE -Wno-error=${guess})
    endforeach()
  endif()
endif()
