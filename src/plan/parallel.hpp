// Tasks over the threads that a control allows.
#pragma once

#include <functional>

#include "changeover/search/control.hpp"

namespace changeover::plan_detail {

/// Runs tasks 0 … count−1, each on one of the threads; rethrows a fault of one of them when all have ended.
void in_parallel(const SearchControl& control, unsigned count,
                 const std::function<void(unsigned)>& task);

/// Settings of a control of one thread that stops when this one does by time or by interruption, and
/// tells nobody.
[[nodiscard]] SearchControl::Settings settings_for_one_thread(const SearchControl& control);

}  // namespace changeover::plan_detail
