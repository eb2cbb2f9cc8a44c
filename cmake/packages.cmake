# Debian packages, one a component, made by `./dev package` out of a build as it is
# (docs/packages.md).
#
#     libchangeover-loadorder0   library       the library for C
#     libchangeover-dev          development   headers, static libraries, what CMake and pkg-config
#                                              ask
#     changeover                 tools         programs, and all that is installed without a
#                                              component's name
#     python3-changeover         python
if(NOT CHANGEOVER_INSTALL OR NOT CHANGEOVER_PROGRAM OR NOT EXISTS "/etc/debian_version")
  return()
endif()

set(CHANGEOVER_MAINTAINER "The Changeover developers <developers@changeover.invalid>" CACHE STRING
  "Who answers for Debian packages made here")
set(library_package "libchangeover-loadorder${CHANGEOVER_C_INTERFACE}")
set(packages_dir "${PROJECT_BINARY_DIR}/generated/packages")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME changeover)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
# The first line of each description below is its summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_VENDOR "The Changeover developers")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_THREADS 0)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL library development tools)
if(TARGET changeover_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CHANGEOVER_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SOURCE changeover)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(debian_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")

set(about "A change covering design is an order of set-ups of equal size, in which
every pair of items is together at some time and consecutive set-ups
differ in few items.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME "${library_package}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "orders in which every pair of items is loaded together, for C
${about}
.
This library gives such orders to programs that can hold some of their
items in memory at once and need every pair there together: which item
to evict and which to load, with few loads.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libchangeover-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} (= ${debian_version}), libfmt-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
  "libcadical-dev, libbliss-dev, libgmp-dev, libsqlite3-dev, libexpat1-dev, libzip-dev, libxlsxwriter-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "change covering designs - headers and static libraries
${about}
.
Headers of the C++ library, its modules as static libraries, the header
of the library for C, and the files by which CMake and pkg-config find
both. A program that links only some modules needs only some of the
recommended packages.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME changeover)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION math)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
# What is loaded late, which dpkg-shlibdeps does not see.
get_property(late GLOBAL PROPERTY CHANGEOVER_LATE)
set(needed)
foreach(library IN LISTS late)
  file(REAL_PATH "${library}" library)
  execute_process(COMMAND dpkg-query --search "${library}" OUTPUT_VARIABLE owner ERROR_QUIET)
  if(owner MATCHES "^([^:]+):")
    list(APPEND needed "${CMAKE_MATCH_1}")
  endif()
endforeach()
list(JOIN needed ", " CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "python3-changeover")
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "finds, proves, draws and runs change covering designs
${about}
.
The program changeover constructs such designs, searches for them,
verifies them, bounds them from below, plans experiments by them and
shows them in a browser. The program checkdesign verifies designs too
and shares no code with it.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-changeover)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-numpy, python3-distributed, python3-mpi4py")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "change covering designs - Python 3 package
${about}
.
This package constructs, verifies and bounds such designs, searches for
them and plans experiments by them.")
if(TARGET changeover_python)
  get_directory_property(major DIRECTORY python DEFINITION Python_VERSION_MAJOR)
  get_directory_property(minor DIRECTORY python DEFINITION Python_VERSION_MINOR)
  math(EXPR next_minor "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${major}.${minor}~), python3 (<< ${major}.${next_minor})")
endif()

# What goes beside a package's files: of the library which programs may start with it, of Python its
# compiled files.
configure_file("${CHANGEOVER_C_SYMBOLS}" "${packages_dir}/library/symbols" COPYONLY)
file(CONFIGURE OUTPUT "${packages_dir}/library/shlibs"
  CONTENT
  "libchangeover_loadorder ${CHANGEOVER_C_INTERFACE} ${library_package} (>= ${PROJECT_VERSION})\n")
file(CONFIGURE OUTPUT "${packages_dir}/library/triggers" CONTENT "activate-noawait ldconfig\n")
set(scripts OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
foreach(script IN ITEMS library.postinst library.postrm python.postinst python.prerm)
  string(REPLACE "." "/" to "${script}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/packages/${script}" "${packages_dir}/${to}"
    FILE_PERMISSIONS ${scripts} COPYONLY)
endforeach()
foreach(file IN ITEMS symbols shlibs triggers postinst postrm)
  list(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${packages_dir}/library/${file}")
endforeach()
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${packages_dir}/python/postinst;${packages_dir}/python/prerm")

set(folders "")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" upper)
  list(APPEND folders "${component}:${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
endforeach()
configure_file("${PROJECT_SOURCE_DIR}/cmake/packages/prepare.cmake.in"
  "${packages_dir}/prepare.cmake" @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS "${packages_dir}/prepare.cmake")
include(CPack)
