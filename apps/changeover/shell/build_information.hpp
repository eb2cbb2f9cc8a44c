// How this program was built, as CMake knew it. Generated: cmake/build_information.cmake.
#pragma once

#include <string_view>

namespace changeover::cli {

struct BuildInformation {
  std::string_view date;  ///< of the build's configuration, or of SOURCE_DATE_EPOCH: "2026-01-31"
  std::string_view compiler;    ///< "GNU 12.2.0"
  std::string_view build_type;  ///< "Release"
  std::string_view sanitizers;  ///< as for -fsanitize; empty: none
  std::string_view cadical;  ///< version of the Debian package that has its library; empty: unknown
  std::string_view nlohmann_json;  ///< version: "3.11.2"
};

[[nodiscard]] const BuildInformation& build_information();

}  // namespace changeover::cli
