# bliss, canonical forms of graphs: the target Bliss::Bliss. Its library was built with
# BLISS_USE_GMP, which changes the layout of its classes, so those who include it must say so too.
find_path(Bliss_INCLUDE_DIR bliss/graph.hh)
find_library(Bliss_LIBRARY bliss)
find_library(Bliss_GMP_LIBRARY gmp)
mark_as_advanced(Bliss_INCLUDE_DIR Bliss_LIBRARY Bliss_GMP_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Bliss
  REQUIRED_VARS Bliss_LIBRARY Bliss_GMP_LIBRARY Bliss_INCLUDE_DIR)
if(Bliss_FOUND AND NOT TARGET Bliss::Bliss)
  add_library(Bliss::Bliss UNKNOWN IMPORTED)
  set_target_properties(Bliss::Bliss PROPERTIES
    IMPORTED_LOCATION "${Bliss_LIBRARY}"
    INTERFACE_COMPILE_DEFINITIONS BLISS_USE_GMP
    INTERFACE_LINK_LIBRARIES "${Bliss_GMP_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Bliss_INCLUDE_DIR}")
endif()
