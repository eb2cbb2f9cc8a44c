# Installation as a CMake package: find_package(changeover) then link changeover::changeover or
# one room, as changeover::core.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/changeover")

install(EXPORT changeoverTargets NAMESPACE changeover:: DESTINATION "${package_dir}")
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/changeoverConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/generated/changeoverConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/generated/changeoverConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/generated/changeoverConfig.cmake"
  "${PROJECT_BINARY_DIR}/generated/changeoverConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindCaDiCaL.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindBliss.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindLibZip.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindXlsxWriter.cmake"
  DESTINATION "${package_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
