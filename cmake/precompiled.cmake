# changeover_precompile(<target> <owner> [<header>...])
#
# If CHANGEOVER_PRECOMPILE is on: <target> takes the compiled headers of <owner>, who is compiled
# with the same options; where the two are the same target, these <header>s are compiled. A source
# then costs two thirds of what it did.
#
# A source includes what it needs all the same: the preset `debug` does not precompile and holds it
# to that.
option(CHANGEOVER_PRECOMPILE "Compile the headers that most sources include once" OFF)

set(CHANGEOVER_COMMON_HEADERS
  <algorithm> <array> <charconv> <chrono> <cstddef> <cstdint> <cstring> <functional> <limits> <map>
  <memory>
  <numeric> <optional> <set> <span> <string> <string_view> <tuple> <utility> <vector>
  "${PROJECT_SOURCE_DIR}/src/core/checked.hpp"
  "${PROJECT_SOURCE_DIR}/include/changeover/core/design.hpp"
  "${PROJECT_SOURCE_DIR}/include/changeover/core/error.hpp"
  "${PROJECT_SOURCE_DIR}/include/changeover/run/control.hpp")

function(changeover_precompile target owner)
  if(NOT CHANGEOVER_PRECOMPILE)
    return()
  elseif(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${CHANGEOVER_COMMON_HEADERS} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
