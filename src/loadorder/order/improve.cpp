#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/search/local_search.hpp"
#include "loadorder/order/searched.hpp"

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

LoadOrderOptions searched(double seconds, std::uint64_t seed, const Searching& searching) {
  constexpr double least_in_all = 10;
  LoadOrderOptions options;
  options.seed = seed;
  options.search_pairs = [searching](const std::function<void()>& search) {
    searching([&](RunControl& control) {
      const RunScope scope(control);
      search();
    });
  };
  if (seconds > 0) {
    options.improve = [searching](const Design& start, std::uint64_t least_blocks) {
      std::optional<Design> found;
      searching(
          [&](RunControl& control) { found = improve_by_search(control)(start, least_blocks); });
      return found;
    };
    options.time_in_all = std::chrono::duration<double>(std::max(seconds, least_in_all));
  }
  return options;
}

LoadOrderOptions searched(double seconds, std::uint64_t seed, RunControl& control) {
  return searched(seconds, seed,
                  [&control, seconds, seed](const std::function<void(RunControl&)>& search) {
                    RunControl part(control, std::chrono::duration<double>(seconds), seed);
                    search(part);
                  });
}

}  // namespace changeover
