# changeover_cold(<target> [ONLY <regex> | UNLESS <regex>])
#
# What nobody waits for while it runs is compiled for a fast build: -Og instead of -O2 takes about 0.6 of the compiler's time. That is
# all of the target, those of its sources whose path matches, or all others; what computes (designs, searches, plans, streams of
# blocks and steps) stays at -O2. A source with options of its own is compiled alone, so the larger part has those of the target.
function(changeover_cold target)
  cmake_parse_arguments(PARSE_ARGV 1 cold "" "ONLY;UNLESS" "")
  get_target_property(sources ${target} SOURCES)
  set(apart -O2)
  if(cold_ONLY)
    set(apart -Og)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
  endif()
  if(cold_ONLY OR cold_UNLESS)
    list(FILTER sources INCLUDE REGEX "${cold_ONLY}${cold_UNLESS}")
    set_property(SOURCE ${sources} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS "$<$<CONFIG:Release>:${apart}>")
  endif()
endfunction()

# changeover_together(<target> <number>)
#
# Where headers are precompiled, sources that stand beside each other are compiled together, so many at a time: what they include is
# read, and templates are made, once. The preset `debug` compiles each alone, so what one leaves to another is found there.
function(changeover_together target number)
  if(CHANGEOVER_PRECOMPILE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${number})
    # A class of a source may have members of types that only this source knows; the warning is about headers.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()
