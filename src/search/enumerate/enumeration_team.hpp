// Threads and processes that explore the trees of an enumeration together.
//
// The trees are cut into prefixes, some hundreds per case, whatever the number of threads. A thread
// takes one prefix after another, judges the designs that it finds, and passes them on in the order
// of the prefixes, from left to right. So the result does not depend on the number of threads.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "changeover/search/enumeration.hpp"
#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

struct EnumerationTask {
  Parameters parameters;  ///< as requested
  std::vector<EnumerationCase> cases;
  /// Returns what to pass on for a design, if anything. Called from many threads at once.
  std::function<std::optional<DesignClass>(const Design&)> judge;
  /// Called in order, never from two threads at once.
  std::function<void(DesignClass&)> hand_out;
};

/// Explores all cases. `forms` of the result counts the designs passed on. @throws as judge and
/// hand_out.
EnumerationRun explore_together(const EnumerationTask& task, RunControl& control);

}  // namespace changeover
