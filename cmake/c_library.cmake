# Load orders for programs in C: libchangeover_loadorder.so, which needs nothing else of ours and
# exports what changeover_loadorder.h declares and no more. Installed with a .pc file, and as the
# component C of the CMake package, which a project without C++ can ask for.
add_library(changeover_c SHARED "${PROJECT_SOURCE_DIR}/src/loadorder/c_interface.cpp")
add_library(changeover::c ALIAS changeover_c)
# The header is in the tree as it is, so its number is compared, not written.
set(header "${PROJECT_SOURCE_DIR}/include/changeover/loadorder/changeover_loadorder.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
file(STRINGS "${header}" line REGEX "#define CHANGEOVER_LOADORDER_VERSION ")
if(NOT line STREQUAL "#define CHANGEOVER_LOADORDER_VERSION ${CHANGEOVER_VERSION_NUMBER}")
  message(FATAL_ERROR "changeover_loadorder.h says '${line}': write ${CHANGEOVER_VERSION_NUMBER}")
endif()
set(exports "${PROJECT_SOURCE_DIR}/cmake/c_library.map")
# The number of the binary interface, in the library's soname. It is not the version of the project:
# it is raised when a program that was linked before would no longer work, and by nothing else
# (CONTRIBUTING.md).
set(CHANGEOVER_C_INTERFACE 0)
# What is exported since when, in the words of Debian's symbols files; tests/install holds the
# library to it.
set(CHANGEOVER_C_SYMBOLS "${PROJECT_SOURCE_DIR}/cmake/packages/libchangeover_loadorder.symbols")
set_target_properties(changeover_c PROPERTIES
  EXPORT_NAME c
  OUTPUT_NAME changeover_loadorder
  VERSION "${CHANGEOVER_C_INTERFACE}.${PROJECT_VERSION}"
  SOVERSION "${CHANGEOVER_C_INTERFACE}"
  LINK_DEPENDS "${exports}")
target_link_options(changeover_c PRIVATE "LINKER:--version-script=${exports}" LINKER:--gc-sections
  LINKER:-z,defs)
target_include_directories(changeover_c PRIVATE "${PROJECT_SOURCE_DIR}/src" INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
target_link_libraries(changeover_c PRIVATE $<BUILD_INTERFACE:changeover_loadorder>
  $<BUILD_INTERFACE:changeover_warnings>)
if(CHANGEOVER_SANITIZE)
  # A sanitizer's own functions are in the program.
  target_link_options(changeover_c PRIVATE LINKER:-z,undefs)
endif()

if(NOT CHANGEOVER_INSTALL)
  set_target_properties(changeover_c PROPERTIES EXCLUDE_FROM_ALL ON)
  return()
endif()
# Relative to where the file is found, so that a tree can be moved.
file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" up "${up}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/changeover_loadorder.pc.in"
               "${PROJECT_BINARY_DIR}/generated/changeover_loadorder.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/generated/changeover_loadorder.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
install(TARGETS changeover_c EXPORT changeover-C
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development)
