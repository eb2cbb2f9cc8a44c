#include "changeover/loadorder/load_order.hpp"

#include "changeover/search/local_search.hpp"

namespace changeover {

std::function<std::optional<Design>(const Design&, std::uint64_t)> improve_by_search(
    RunControl& control) {
  return [&control](const Design& start, std::uint64_t least_blocks) -> std::optional<Design> {
    if (control.stop_wanted()) {
      return std::nullopt;
    }
    ImproveOptions options;
    options.target = least_blocks;
    options.start = start;
    return improve(start.parameters(), options, control).design;
  };
}

}  // namespace changeover
