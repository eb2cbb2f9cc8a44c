# changeover_room(<name> [DEPENDS <room>...] [LIBRARIES <target>...] [SOURCES <file>...]
#                 [GENERATED_HEADERS <dir>] [ARCHIVE <name>] [NOT_INSTALLED]
#                 [WARM | COLD [ONLY <regex> | UNLESS <regex>]])
#
# Adds the library changeover_<name>, alias changeover::<name>, from src/<name>/**.cpp and
# include/changeover/<name>/**.hpp and **.h. Sources are globbed, so that adding a file touches
# nothing else. DEPENDS are rooms and public; LIBRARIES are private; SOURCES are generated files to
# add; GENERATED_HEADERS is a directory laid out like include/; ARCHIVE is the name of the library's
# file, without lib and .a, if it is not changeover_<name>. Other headers of a room,
# src/<name>/**.hpp, are private: who is built in this tree may include them, as "<name>/….hpp",
# through the target changeover_internals.
function(changeover_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "NOT_INSTALLED;WARM;COLD"
    "GENERATED_HEADERS;ARCHIVE;ONLY;UNLESS"
    "DEPENDS;LIBRARIES;SOURCES")
  if(room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "changeover_room(${name}): unknown arguments ${room_UNPARSED_ARGUMENTS}")
  endif()

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS
       "${PROJECT_SOURCE_DIR}/include/changeover/${name}/*.hpp"
       "${PROJECT_SOURCE_DIR}/include/changeover/${name}/*.h")

  set(bases "${PROJECT_SOURCE_DIR}/include")
  if(room_GENERATED_HEADERS)
    file(GLOB_RECURSE generated "${room_GENERATED_HEADERS}/*.hpp")
    list(APPEND headers ${generated})
    list(APPEND bases "${room_GENERATED_HEADERS}")
  endif()

  set(target changeover_${name})
  add_library(${target} STATIC ${sources} ${room_SOURCES})
  add_library(changeover::${name} ALIAS ${target})
  if(NOT room_ARCHIVE)
    set(room_ARCHIVE ${target})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME "${room_ARCHIVE}")
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${bases} FILES ${headers})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:changeover_warnings>)
  changeover_precompile(${target} changeover_core <fmt/format.h>)
  changeover_together(${target})
  # nlohmann_json is headers only, so the installed library does not need it: BUILD_INTERFACE.
  foreach(library IN LISTS room_LIBRARIES)
    if(library STREQUAL "nlohmann_json::nlohmann_json")
      set(library "$<BUILD_INTERFACE:${library}>")
    endif()
    target_link_libraries(${target} PRIVATE ${library})
  endforeach()
  foreach(other IN LISTS room_DEPENDS)
    target_link_libraries(${target} PUBLIC changeover_${other})
  endforeach()
  if(room_WARM)
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${CHANGEOVER_WARM_OPTIONS}>")
  endif()
  if(room_COLD)
    changeover_cold(${target} ONLY "${room_ONLY}" UNLESS "${room_UNLESS}")
  endif()

  if(room_NOT_INSTALLED OR NOT CHANGEOVER_INSTALL)
    return()
  endif()
  # A separate export, so that other projects can use this room without what higher ones need:
  # cmake/install.cmake.
  install(TARGETS ${target} EXPORT changeover-${name}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
    FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)
endfunction()
