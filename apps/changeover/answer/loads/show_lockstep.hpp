// Orders of workers in lockstep, as they are written.
#pragma once

#include <optional>
#include <string>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/disjoint.hpp"

namespace changeover::cli {

struct LockstepShown {
  std::string format;
  StepWorkOptions work;
  bool new_pairs = false;   ///< whether it is said what is computed
  bool write_back = false;  ///< whether it is said what is stored
};

/// The head, then the steps: those of all workers with the same number after one another. What the steps compute is checked
/// first, as it will be written. @throws InternalError
void show_lockstep(const DisjointOrder& order, const LockstepShown& how, OutputFile& out);

}  // namespace changeover::cli
