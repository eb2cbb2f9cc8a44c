# Builds `consumer` against the installed tree, and runs what came out.
cmake_minimum_required(VERSION 3.25)
set(consumer_build "${work}/consumer")
file(REMOVE_RECURSE "${consumer_build}")

execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND "${CMAKE_COMMAND}" -S "${here}/consumer" -B "${consumer_build}" -G "${generator}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-Dwanted=${version}" "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}" "-DCMAKE_CXX_FLAGS=${flags}"
    -DCMAKE_BUILD_TYPE=Debug)
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND "${CMAKE_COMMAND}" --build "${consumer_build}")

execute_process(COMMAND "${consumer_build}/consumer" OUTPUT_VARIABLE answer
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT answer STREQUAL "${version}\n")
  message(FATAL_ERROR "the consumer printed '${answer}', not the version ${version}")
endif()

if(EXISTS "${prefix}/bin/changeover")
  execute_process(COMMAND "${prefix}/bin/changeover" --help OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
endif()

# What man and the shells look for.
foreach(file IN ITEMS man/man1/changeover.1 man/man1/changeover-catalog-show.1
  man/man1/checkdesign.1
    bash-completion/completions/changeover zsh/site-functions/_changeover
    fish/vendor_completions.d/changeover.fish)
  if(NOT EXISTS "${prefix}/share/${file}")
    message(FATAL_ERROR "share/${file} was not installed")
  endif()
endforeach()
