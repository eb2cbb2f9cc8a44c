# A Meson project that finds the installed library by pkg-config.
cmake_minimum_required(VERSION 3.25)
find_program(meson NAMES meson)
find_program(ninja NAMES ninja)
find_program(pkg_config NAMES pkg-config)
if(NOT meson OR NOT ninja OR NOT pkg_config)
  message("skipped: it needs meson, ninja and pkg-config")
  return()
endif()
set(meson_build "${work}/meson_consumer")
file(REMOVE_RECURSE "${meson_build}")
foreach(arguments IN ITEMS
    "setup;${meson_build};${here}/meson_consumer;-Dwanted=>=${version};-Dc_args=${flags};-Dcpp_args=${flags};-Dc_link_args=${flags};-Dcpp_link_args=${flags}"
    "compile;-C;${meson_build}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${prefix}/${libdir}/pkgconfig"
      "CC=${c_compiler}" "CXX=${cxx_compiler}" "${meson}" ${arguments}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "meson ${arguments}\n${said}")
  endif()
endforeach()
execute_process(COMMAND "${meson_build}/in_cpp" OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
if(NOT answer STREQUAL "${version}\n")
  message(FATAL_ERROR "in_cpp printed '${answer}', not the version ${version}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${prefix}/${libdir}"
  "${meson_build}/in_c"
  OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
if(NOT answer MATCHES "^[1-9][0-9]*\n$")
  message(FATAL_ERROR "in_c printed '${answer}', not a number of loads")
endif()
