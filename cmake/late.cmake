# changeover_late(<target> <definition> <linked> <library>): the target loads a shared library when
# it first uses it (apps/changeover/cli/late_library.hpp); <definition> is the name by which the
# loader knows it. Where that is not known, and with sanitizers, <linked> is linked as any other.
# The libraries are in the global property CHANGEOVER_LATE.
function(changeover_late target definition linked library)
  if(CMAKE_OBJDUMP AND NOT CHANGEOVER_SANITIZE)
    execute_process(COMMAND "${CMAKE_OBJDUMP}" -p "${library}" OUTPUT_VARIABLE headers ERROR_QUIET)
  endif()
  if(headers MATCHES "SONAME +([^ \n]+)")
    target_compile_definitions(${target} PUBLIC "${definition}=\"${CMAKE_MATCH_1}\"")
    target_include_directories(${target} SYSTEM PUBLIC
      "$<TARGET_PROPERTY:${linked},INTERFACE_INCLUDE_DIRECTORIES>")
    target_link_libraries(${target} PUBLIC ${CMAKE_DL_LIBS})
    # Where a room asks for it, too, only what the target calls itself is linked.
    target_link_options(${target} PRIVATE -Wl,--as-needed)
    set_property(GLOBAL APPEND PROPERTY CHANGEOVER_LATE "${library}")
  else()
    target_link_libraries(${target} PUBLIC ${linked})
  endif()
endfunction()
