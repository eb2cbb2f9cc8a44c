# What ctest runs of a test program: each suite in one process, each case whose name contains "Slow"
# in its own. CTest includes this (PROGRAM, FOLDER, PATIENCE are set) and adds the tests that the
# program lists.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests TIMEOUT 60
  OUTPUT_VARIABLE listed RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests ended with ${code}:\n${listed}")
endif()

# The suite whose cases were just read.
macro(changeover_add_suite)
  if(quick)
    add_test("${FOLDER}.${suite}" "${PROGRAM}" "--gtest_filter=${suite}.*-*Slow*")
    set_tests_properties("${FOLDER}.${suite}" PROPERTIES LABELS quick TIMEOUT "${PATIENCE}")
    list(APPEND added "${FOLDER}.${suite}")
  endif()
  set(quick FALSE)
endmacro()

set(added)
set(quick FALSE)
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " +#.*" "" line "${line}")
  if(line MATCHES "^([^ ]+)\\.$")
    set(next "${CMAKE_MATCH_1}")
    changeover_add_suite()
    set(suite "${next}")
  elseif(line MATCHES "^  ([^ ]+)$")
    set(case "${suite}.${CMAKE_MATCH_1}")
    if(case MATCHES "Slow")
      add_test("${FOLDER}.${case}" "${PROGRAM}" "--gtest_filter=${case}")
      set_tests_properties("${FOLDER}.${case}" PROPERTIES LABELS slow TIMEOUT 3600)
      list(APPEND added "${FOLDER}.${case}")
    else()
      set(quick TRUE)
    endif()
  endif()
endforeach()
changeover_add_suite()
# Skipped is what had no case that ran, and none that failed.
set_tests_properties(${added} PROPERTIES ENVIRONMENT CHANGEOVER_CATALOG=
  SKIP_REGULAR_EXPRESSION
  "PASSED  . 0 tests\\.\n.  SKIPPED  . [0-9]+ tests?, listed below:\n(.  SKIPPED  . [^\n]*\n)*\n*$")
