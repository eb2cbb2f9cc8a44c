// Threads and processes that explore the trees of an enumeration together.
//
// The trees are cut into prefixes, some hundreds a case however many threads there are. A thread
// takes one prefix after another, judges what it finds, and hands it out when its turn comes:
// prefix by prefix from left to right, so that the outcome does not depend on the number of
// threads.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "changeover/search/enumeration.hpp"
#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

struct EnumerationTask {
  Parameters parameters;  ///< as they were asked for
  std::vector<EnumerationCase> cases;
  /// What to hand out for a design, if anything. Called by many threads at once.
  std::function<std::optional<DesignClass>(const Design&)> judge;
  /// Called in order, never by two threads at once.
  std::function<void(DesignClass&)> hand_out;
};

/// Explores all cases. `forms` of the answer counts what was handed out. @throws what judge and
/// hand_out do.
EnumerationRun explore_together(const EnumerationTask& task, RunControl& control);

}  // namespace changeover
