// Which columns of a sheet hold the parts of its set-ups: one for each, and with slots the parts of a slot in columns of
// their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/run_sheet.hpp"

namespace changeover {

class SlotColumns {
 public:
  /// As many as the set-ups of the sheet need; the job must outlive this.
  SlotColumns(const Job& job, const RunSheet& sheet);

  /// "slot_1", "slot_2", …; with slots "slot_1 CPU".
  [[nodiscard]] const std::vector<std::string>& heads() const { return heads_; }

  /// By column: the part in it, or nothing.
  [[nodiscard]] std::vector<std::optional<Element>> row(const Block& setup) const;

 private:
  [[nodiscard]] std::vector<Block> by_slot(const Block& setup) const;

  const Job* job_;
  std::vector<std::size_t> widths_;  // by slot, the last for none: how many columns its parts need
  std::vector<std::string> heads_;
};

}  // namespace changeover
