// Internal: a part of the time of a search, where several searches follow one another.
#pragma once

#include <functional>
#include <optional>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// The same options; a search has this share of the time that is left.
[[nodiscard]] inline LoadOrderOptions with_share(const LoadOrderOptions& options, double share) {
  LoadOrderOptions its = options;
  if (!options.search_pairs) {
    return its;
  }
  its.search_pairs = [whole = options.search_pairs, share](const std::function<void()>& search) {
    whole([&] {
      RunControl* const control = RunScope::current();
      const auto left = control != nullptr ? control->time_left() : std::nullopt;
      if (!left) {
        return search();
      }
      RunControl part(*control, share * *left);
      const RunScope scope(part);
      search();
    });
  };
  return its;
}

}  // namespace changeover
