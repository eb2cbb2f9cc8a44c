# Uses the installed library for C as strangers do: a CMake project without C++, pkg-config and the
# C compiler, and Python's ctypes.
cmake_minimum_required(VERSION 3.25)
set(consumer_build "${work}/c_consumer")
file(REMOVE_RECURSE "${consumer_build}")

set(library_dir "${prefix}/${libdir}")
set(library "${library_dir}/libchangeover_loadorder.so")

function(expect_same_loads how answer)
  if(NOT answer MATCHES "^[1-9][0-9]*\n$")
    message(FATAL_ERROR "${how} printed '${answer}', not a number of loads")
  endif()
  get_property(before GLOBAL PROPERTY loads)
  if(before AND NOT answer STREQUAL before)
    message(FATAL_ERROR "${how} printed '${answer}', not '${before}' as before")
  endif()
  set_property(GLOBAL PROPERTY loads "${answer}")
endfunction()

execute_process(COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
  COMMAND "${CMAKE_COMMAND}" -S "${here}/c_consumer" -B "${consumer_build}" -G "${generator}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-Dwanted=${version}" "-DCMAKE_C_COMPILER=${c_compiler}"
    "-DCMAKE_C_FLAGS=${flags}")
execute_process(COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
  COMMAND "${CMAKE_COMMAND}" --build "${consumer_build}")
execute_process(COMMAND "${consumer_build}/c_consumer" OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL
  ANY)
expect_same_loads("the CMake project in C" "${answer}")

find_program(pkg_config pkg-config REQUIRED)
execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${library_dir}/pkgconfig"
    "${pkg_config}" --cflags --libs changeover_loadorder
  OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(words UNIX_COMMAND "${words}")
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND "${c_compiler}" -std=c11 -Wall -Wextra -Werror ${flags}
  "${here}/c_consumer/main.c"
    -o "${work}/c_by_hand" ${words} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${library_dir}"
  "${work}/c_by_hand"
  OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
expect_same_loads("the program that pkg-config built" "${answer}")

# A library with a sanitizer needs a program with it, which Python is not.
if(NOT flags)
  find_program(python NAMES python3)
  if(python)
    execute_process(COMMAND "${python}" "${here}/ctypes_consumer.py" "${library}" OUTPUT_VARIABLE
      answer
      COMMAND_ERROR_IS_FATAL ANY)
    expect_same_loads("Python's ctypes" "${answer}")
  else()
    message(STATUS "no python3: ctypes is not tried")
  endif()
endif()
