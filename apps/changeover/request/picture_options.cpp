#include "request/picture_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

namespace changeover::cli {

std::optional<std::string> picture_option_defect(std::string_view option, std::string_view picture,
                                                 std::string_view dashes) {
  static const std::map<std::string_view, std::vector<std::string_view>> only_for{
      {"from", {"array", "stays", "coverage", "circle"}},
      {"to", {"array", "stays", "coverage", "circle"}},
      {"order", {"stays", "coverage"}},
      {"colour", {"stays"}},
      {"leaving", {"array"}},
      {"expansion-sets", {"array"}},
      {"measure", {"heatmap"}},
      {"k", {"heatmap"}},
      {"v", {"heatmap"}}};
  const auto found = only_for.find(option);
  if (found == only_for.end() || std::ranges::find(found->second, picture) != found->second.end()) {
    return std::nullopt;
  }
  return fmt::format("{0}{1} has no meaning with {0}picture {2}; it is for {3}", dashes, option,
                     picture, fmt::join(found->second, ", "));
}

}  // namespace changeover::cli
