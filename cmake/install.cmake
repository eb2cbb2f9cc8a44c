# Installation as a CMake package: find_package(changeover) then link changeover::changeover or one
# room, as changeover::core. Each room is a component, so that who asks for one needs only what that
# one links: docs/packages.md. `cmake --install DIR --component NAME` has the names library,
# development, tools, python.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/changeover")
set(installed_rooms ${CHANGEOVER_ROOMS})
list(REMOVE_ITEM installed_rooms ${CHANGEOVER_ROOMS_OF_THE_HOUSE})

foreach(name IN LISTS installed_rooms ITEMS changeover C)
  install(EXPORT changeover-${name} NAMESPACE changeover:: FILE changeover-${name}.cmake
    DESTINATION "${package_dir}" COMPONENT development)
endforeach()

# What each room needs, for the package file: rooms below it, and packages by the name that
# find_package() knows. The headers of nlohmann_json are compiled in.
set(needs_of_rooms "")
foreach(room IN LISTS installed_rooms)
  set(packages "")
  foreach(library IN LISTS CHANGEOVER_LIBRARIES_${room})
    if(NOT library STREQUAL "nlohmann_json::nlohmann_json")
      string(REGEX REPLACE "::.*" "" package "${library}")
      string(REGEX REPLACE "^SQLite$" "SQLite3" package "${package}")
      list(APPEND packages ${package})
    endif()
  endforeach()
  list(JOIN CHANGEOVER_KNOWS_${room} " " rooms)
  list(JOIN packages " " packages)
  string(APPEND needs_of_rooms
    "set(changeover_rooms_below_${room} ${rooms})\nset(changeover_packages_of_${room} ${packages})\n")
endforeach()
list(JOIN installed_rooms " " rooms)
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/changeoverConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/generated/changeoverConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/generated/changeoverConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/generated/changeoverConfig.cmake"
  "${PROJECT_BINARY_DIR}/generated/changeoverConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/find/FindCaDiCaL.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/find/FindBliss.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/find/FindLibZip.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/find/FindXlsxWriter.cmake"
  DESTINATION "${package_dir}" COMPONENT development)

# For those who ask pkg-config: all rooms, highest first, as a linker wants static libraries.
set(static_libraries "")
foreach(room IN LISTS installed_rooms)
  get_target_property(archive changeover_${room} OUTPUT_NAME)
  string(PREPEND static_libraries " -l${archive}")
endforeach()
file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" up "${up}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/changeover.pc.in"
  "${PROJECT_BINARY_DIR}/generated/changeover.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/generated/changeover.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)

# What the tutorials and the help texts use, and programs to begin with. Files of the tools are for
# those who have the program only.
set(examples "${PROJECT_SOURCE_DIR}/examples")
install(DIRECTORY "${examples}/lab" DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" COMPONENT tools
  PATTERN "__pycache__" EXCLUDE)
install(FILES "${examples}/bench_parts.csv" "${examples}/server.csv"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" COMPONENT tools)
install(DIRECTORY "${examples}/all_pairs" DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples"
  COMPONENT development)
install(FILES "${examples}/all_pairs.cpp" "${examples}/train_embeddings.cpp"
  "${examples}/load_order.c"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" COMPONENT development)

# Not in a Debian package, which has a copyright file.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT
  license)
