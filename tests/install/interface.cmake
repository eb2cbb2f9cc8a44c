# What the library for C exports, and how its structures lie in memory, is what was published:
# `symbols` lists the soname and the functions with the version that brought them, layout.txt the
# rest. If you remove or change a line of these files, raise CHANGEOVER_C_INTERFACE too
# (CONTRIBUTING.md).
cmake_minimum_required(VERSION 3.25)
set(library "${prefix}/${libdir}/libchangeover_loadorder.so")
find_program(readelf NAMES readelf REQUIRED)
find_program(nm NAMES nm REQUIRED)

execute_process(COMMAND "${readelf}" --dynamic --wide "${library}" OUTPUT_VARIABLE dynamic
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "soname: \\[([^]]*)\\]" matched "${dynamic}")
set(exported "${CMAKE_MATCH_1}")
execute_process(COMMAND "${nm}" --dynamic --defined-only --with-symbol-versions "${library}"
  OUTPUT_VARIABLE listed
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^[0-9a-f]+ ([A-Za-z]) ([^@]+)@+(.*)$" "\\2@\\3" symbol "${line}")
  if(NOT line MATCHES " A ") # a linker's name of the block itself
    list(APPEND exported "${symbol}")
  endif()
endforeach()

file(STRINGS "${symbols}" lines)
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^ ?([^ ]+) .*" "\\1" word "${line}")
  list(APPEND published "${word}")
endforeach()
foreach(word IN LISTS published)
  if(NOT word IN_LIST exported)
    message(SEND_ERROR "${word} was published and is gone: programs that use it would not start")
  endif()
endforeach()
foreach(word IN LISTS exported)
  if(NOT word IN_LIST published)
    message(SEND_ERROR
      "${word} is exported and not in ${symbols}: add it there with the version that brings it")
  endif()
endforeach()

execute_process(COMMAND "${c_compiler}" -std=c11 -Wall -Wextra -Werror "-I${prefix}/include"
  "${here}/layout.c"
  -o "${work}/layout" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/layout" OUTPUT_VARIABLE layout COMMAND_ERROR_IS_FATAL ANY)
file(READ "${here}/layout.txt" published)
if(NOT layout STREQUAL published)
  message(SEND_ERROR
    "the header's layout\n${layout}is not the published one, ${here}/layout.txt\n${published}")
endif()
