# Components of the installed package: each is there with what it links and needs no more, and what
# is wrong is said.
cmake_minimum_required(VERSION 3.25)
set(others CaDiCaL Bliss SQLite3 EXPAT LibZip XlsxWriter)
string(REPLACE "," ";" all_rooms "${rooms}")

# configure(<languages> [<definition>...]): leaves `result` and `said`. What CMake found out about
# the compilers stays, what it found of packages does not.
file(REMOVE_RECURSE "${work}/components")
function(configure languages)
  file(REMOVE "${work}/components/CMakeCache.txt")
  execute_process(RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error
    COMMAND "${CMAKE_COMMAND}" -S "${here}/components" -B "${work}/components" -G "${generator}"
      "-DCMAKE_PREFIX_PATH=${prefix}" "-Dwanted=${version}" "-DCMAKE_C_COMPILER=${c_compiler}"
      "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
      "-DCMAKE_CXX_FLAGS=${flags}" "-Dlanguages=${languages}" ${ARGN})
  set(result "${result}" PARENT_SCOPE)
  # CMake breaks the lines of its messages.
  string(REGEX REPLACE "[ \n]+" " " said "${output} ${error}")
  set(said "${said}" PARENT_SCOPE)
endfunction()

function(build_and_run)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${said}")
  endif()
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/components" OUTPUT_VARIABLE output
    ERROR_VARIABLE output
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
  foreach(room IN LISTS ARGN)
    execute_process(COMMAND "${work}/components/all_of_${room}" OUTPUT_VARIABLE answer
      COMMAND_ERROR_IS_FATAL ANY)
    if(NOT answer STREQUAL "${version}\n")
      message(FATAL_ERROR "all_of_${room} printed '${answer}'")
    endif()
  endforeach()
endfunction()

function(refused text)
  if(result EQUAL 0)
    message(FATAL_ERROR "'${text}' was not said: it was found")
  elseif(NOT said MATCHES "${text}")
    message(FATAL_ERROR "'${text}' was not said, but ${said}")
  endif()
endfunction()

set(without "")
foreach(other IN LISTS others)
  list(APPEND without "-DCMAKE_DISABLE_FIND_PACKAGE_${other}=TRUE")
endforeach()
configure(CXX -Dcomponents=verify -Drooms=core,run,verify -Dabsent=search,catalog,changeover,c
  ${without})
build_and_run(core run verify)
configure(CXX -Dcomponents=bounds,proof -Dabsent=verify -Drooms=proof ${without})
build_and_run(proof)

configure(CXX -Dcomponents=${rooms} -Drooms=${rooms} -Dabsent=c)
build_and_run(${all_rooms})

configure(CXX -Dcomponents=verify -Doptional=search,no_such_room,plan -Dabsent=search
  -DCMAKE_DISABLE_FIND_PACKAGE_CaDiCaL=TRUE)
if(NOT result EQUAL 0 OR NOT said MATCHES
  "verify found: TRUE.*search found: FALSE.*no_such_room found: FALSE.*plan found: FALSE")
  message(FATAL_ERROR "components that may be missing: ${said}")
endif()

configure(CXX -Dcomponents=search -DCMAKE_DISABLE_FIND_PACKAGE_CaDiCaL=TRUE)
refused("the component 'search' of changeover needs CaDiCaL, which is not found")
configure(CXX -Dcomponents=plan -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=TRUE)
refused("the component 'catalog' of changeover needs SQLite3, which is not found")
configure(CXX -Dcomponents=verify,no_such_room)
refused("changeover has no component 'no_such_room'; it has: C changeover core run")
configure(C -Dcomponents=verify)
refused("the component 'verify' of changeover is C\\+\\+: add CXX to the LANGUAGES.* COMPONENTS C, ")
configure(CXX -Dcomponents=paper)
refused("changeover has no component 'paper'")

# Another major version may break source, so it does not answer.
string(REGEX REPLACE "^([0-9]+)\\.([0-9]+).*" "\\1" major "${version}")
math(EXPR major "${major} + 1")
configure(CXX -Dcomponents=verify -Dwanted=${major}.0)
refused("compatible with requested version \"${major}.0\"")
