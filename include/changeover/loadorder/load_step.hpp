// Steps of a load order, and where they come from.
//
// Memory has room for C items. A step evicts some items, then loads some; after it, everything in memory
// can meet. A StepSource hands out steps one at a time, so an order of 10⁹ steps needs no memory for them:
//
//     LoadStep step;
//     while (source.next(step)) {
//       drop(step.evict);
//       fetch(step.load);
//     }
//
// As with blocks, what a source hands out is a claim: loadorder/load_check.hpp decides.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// What happens before one stretch of computation.
struct LoadStep {
  std::uint64_t number = 0;    ///< from 1
  std::vector<Element> evict;  ///< leave memory first
  std::vector<Element> load;   ///< are loaded then

  bool operator==(const LoadStep&) const = default;
};

/// A stream of steps.
class StepSource {
 public:
  virtual ~StepSource() = default;
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  /// Writes the next step into `step`, whose vectors are reused, and returns true; false at the end.
  virtual bool next(LoadStep& step) = 0;

 protected:
  StepSource() = default;
};

}  // namespace changeover
