# gcc 13 and later take headers that were compiled at -O2 at -Og only if these flags, which -O2
# switches on, are on there as well. They are those of one kind of processor.
set(CHANGEOVER_COLD_OPTIONS -Og)
# What is as fast with the inlining of -O2 and without its other passes takes 0.7 to 0.9 of the
# compiler's time.
set(CHANGEOVER_WARM_OPTIONS -O2)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CHANGEOVER_WARM_OPTIONS -O1 -finline-small-functions -finline-functions -findirect-inlining
    -fpartial-inlining)
endif()
if(CHANGEOVER_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION
  VERSION_GREATER_EQUAL 13)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag("-munroll-only-small-loops -mvzeroupper" CHANGEOVER_HAS_FLAGS_OF_O2)
  if(CHANGEOVER_HAS_FLAGS_OF_O2)
    list(APPEND CHANGEOVER_WARM_OPTIONS -munroll-only-small-loops -mvzeroupper)
    list(APPEND CHANGEOVER_COLD_OPTIONS -munroll-only-small-loops -mvzeroupper)
  endif()
endif()

# changeover_cold(<target> [ONLY <regex> | UNLESS <regex>])
#
# Code whose speed does not matter at run time is compiled for a fast build: -Og instead of -O2 takes about
# 0.6 of the compiler's time. That is all of the target, those of its sources whose path matches, or
# all others; what computes (designs, searches, plans, streams of blocks and steps) stays at -O2.
# The sources that match become objects of their own, <target>_apart, so that they, too, are
# compiled together. Comes after all else that says how the target is compiled.
function(changeover_cold target)
  cmake_parse_arguments(PARSE_ARGV 1 cold "" "ONLY;UNLESS" "")
  set(apart "${target}_apart")
  if(cold_ONLY OR cold_UNLESS)
    get_target_property(sources ${target} SOURCES)
    set(matching ${sources})
    list(FILTER matching INCLUDE REGEX "${cold_ONLY}${cold_UNLESS}")
    list(REMOVE_ITEM sources ${matching})
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
    add_library(${apart} OBJECT ${matching})
    foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_FEATURES
      COMPILE_OPTIONS)
      set_property(TARGET ${apart} PROPERTY ${property} "$<TARGET_PROPERTY:${target},${property}>")
    endforeach()
    changeover_precompile(${apart} changeover_core)
    changeover_together(${apart})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${apart}>)
  endif()
  if(cold_ONLY)
    target_compile_options(${apart} PRIVATE "$<$<CONFIG:Release>:${CHANGEOVER_COLD_OPTIONS}>")
    return()
  endif()
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${CHANGEOVER_COLD_OPTIONS}>")
  if(cold_UNLESS)
    target_compile_options(${apart} PRIVATE $<$<CONFIG:Release>:-O2>)
  endif()
endfunction()

# changeover_together(<target>)
#
# Where headers are precompiled, sources that stand beside each other are compiled together: what
# they include is read, and templates are made, once. All of a target in one batch take about half
# of what nine at a time take, and up to 1.5 GB of memory. So a target has one batch for every two
# processors, of nine sources at least; of nine where memory is short. Who changes one source often
# sets CHANGEOVER_TOGETHER to a small number. The preset `tidy` sets it, too: clang-tidy then takes
# a tenth of the time.
#
# gcc looks for memory to free whenever what it holds has doubled. Where there is room it does not
# look before it holds 1 GB: this takes 0.89 to 0.95 of the time, and up to 2.3 GB.
#
# The preset `debug` compiles each source alone, so what one leaves to another is found there.
set(CHANGEOVER_TOGETHER "" CACHE STRING
  "How many sources are compiled together; empty: what suits this machine")
cmake_host_system_information(RESULT CHANGEOVER_PROCESSORS QUERY NUMBER_OF_LOGICAL_CORES)
cmake_host_system_information(RESULT CHANGEOVER_MEMORY QUERY TOTAL_PHYSICAL_MEMORY)
math(EXPR CHANGEOVER_MEMORY "${CHANGEOVER_MEMORY} / ${CHANGEOVER_PROCESSORS}")  # MiB for each

function(changeover_together target)
  if(NOT CHANGEOVER_PRECOMPILE AND NOT CHANGEOVER_TOGETHER)
    return()
  endif()
  set(number "${CHANGEOVER_TOGETHER}")
  if(NOT number)
    get_target_property(sources ${target} SOURCES)
    list(LENGTH sources count)
    math(EXPR batches "(${CHANGEOVER_PROCESSORS} + 1) / 2")
    math(EXPR number "(${count} + ${batches} - 1) / ${batches}")
    if(number LESS 9 OR CHANGEOVER_MEMORY LESS 1800)
      set(number 9)
    endif()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${number})
  if(CHANGEOVER_MEMORY GREATER 3500)
    target_compile_options(${target} PRIVATE
      "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>")
  endif()
  # A class of a source may have members of types that only this source knows; the warning is about
  # headers.
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
endfunction()
