# Language, build type, instrumentation and the tools that make builds fast.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The rooms are static libraries, and the shared library for C (cmake/c_library.cmake) is linked
# from them. Programs are compiled as they are, so that one precompiled header serves both.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_C_COMPILE_OPTIONS_PIE -fPIC)
set(CMAKE_CXX_COMPILE_OPTIONS_PIE -fPIC)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
endif()
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

find_program(CHANGEOVER_CCACHE ccache)
mark_as_advanced(CHANGEOVER_CCACHE)
set(ccache_fails TRUE)
if(CHANGEOVER_CCACHE)
  execute_process(COMMAND "${CHANGEOVER_CCACHE}" --version RESULT_VARIABLE ccache_fails OUTPUT_QUIET
    ERROR_QUIET)
endif()
if(NOT ccache_fails AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers are cached only by a ccache that may be careless about these two things,
  # which no source of ours makes use of. With DEPEND, what is not in the cache is not preprocessed
  # twice.
  set(launcher env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1 "${CHANGEOVER_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

find_program(CHANGEOVER_MOLD ld.mold)
mark_as_advanced(CHANGEOVER_MOLD)
if(CHANGEOVER_MOLD AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=mold CHANGEOVER_MOLD_WORKS)
  if(CHANGEOVER_MOLD_WORKS)
    add_link_options(-fuse-ld=mold)
  endif()
endif()

if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_compile_definitions($<$<COMPILE_LANGUAGE:CXX>:_GLIBCXX_ASSERTIONS>)
endif()

# A search with a seed has the same answer on every machine: no operation is fused with another,
# which rounds once for two. Plain x86-64 has no such operations.
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" OR CMAKE_CXX_FLAGS MATCHES "-march|-mfma")
  add_compile_options(-ffp-contract=off)
endif()

if(CHANGEOVER_SANITIZE)
  # No recovery: a report ends the process, so a test cannot pass with one.
  add_compile_options(-fsanitize=${CHANGEOVER_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${CHANGEOVER_SANITIZE})
endif()

if(CHANGEOVER_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

if(CHANGEOVER_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "CHANGEOVER_FUZZ needs clang: configure with the preset 'fuzz'")
  endif()
  # Everything counts coverage for the fuzzer; only the fuzz targets get its main().
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()
