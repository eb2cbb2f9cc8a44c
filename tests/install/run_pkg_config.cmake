# Compiles a program in C++ with what pkg-config says and nothing else, as docs/packages.md shows it.
cmake_minimum_required(VERSION 3.25)
find_program(pkg_config NAMES pkg-config)
if(NOT pkg_config)
  message("skipped: it needs pkg-config")
  return()
endif()
set(library_dir "${prefix}/${libdir}")
execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${library_dir}/pkgconfig"
    "${pkg_config}" --cflags --libs changeover
  OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(words UNIX_COMMAND "${words}")
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND "${cxx_compiler}" -std=c++20 ${flags} "${here}/meson_consumer/main.cpp"
    -o "${work}/cpp_by_hand" ${words} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/cpp_by_hand" OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
if(NOT answer STREQUAL "${version}\n")
  message(FATAL_ERROR "the program that pkg-config built printed '${answer}', not ${version}")
endif()

# Compilers take an older standard by default; one line says so, before all that follows from it.
execute_process(COMMAND "${cxx_compiler}" -std=c++17 -fsyntax-only ${flags}
    "${here}/meson_consumer/main.cpp" ${words}
  RESULT_VARIABLE result ERROR_VARIABLE said)
if(result EQUAL 0 OR NOT said MATCHES "^[^\n]*\n?[^\n]*error[^\n]* changeover need C\\+\\+20")
  message(FATAL_ERROR "the first error of a program in C++17 is not about the standard: ${said}")
endif()
