// Which columns of a sheet hold the parts of its set-ups: one for each, and with slots the parts of
// a slot in columns of
// their own.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

class SlotColumns {
 public:
  /// As many as the set-ups of the sheets need; the job must outlive this.
  SlotColumns(const Job& job, const std::vector<const RunSheet*>& sheets);

  /// "slot_1", "slot_2", …; with slots "slot_1 CPU".
  [[nodiscard]] const std::vector<std::string>& heads() const { return heads_; }

  /// The part in a column, or nothing.
  [[nodiscard]] std::optional<Element> part(const Block& setup, std::size_t column) const;

 private:
  [[nodiscard]] std::size_t slot_of(Element x) const;

  const Job* job_;
  std::vector<std::pair<std::size_t, std::size_t>>
      places_;  // by column: the slot, the last for none, and which of its parts
  std::vector<std::string> heads_;
};

}  // namespace changeover
