#include "plan/sheet/slot_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover {

std::vector<Block> SlotColumns::by_slot(const Block& setup) const {
  std::vector<Block> parts(widths_.size());
  for (const Element x : setup) {
    const bool is_free = job_->slot_of.empty() || job_->slot_of[x] == no_slot;
    parts[is_free ? job_->slots.size() : job_->slot_of[x]].push_back(x);
  }
  return parts;
}

SlotColumns::SlotColumns(const Job& job, const RunSheet& sheet)
    : job_(&job), widths_(job.slots.size() + 1, 0) {
  for (const RunStep& step : sheet.steps) {
    const std::vector<Block> parts = by_slot(step.setup);
    for (std::size_t slot = 0; slot < widths_.size(); ++slot) {
      widths_[slot] = std::max(widths_[slot], parts[slot].size());
    }
  }
  for (std::size_t slot = 0; slot < widths_.size(); ++slot) {
    for (std::size_t i = 0; i < widths_[slot]; ++i) {
      heads_.push_back(fmt::format("slot_{}", heads_.size() + 1));
      heads_.back() += slot < job.slots.size() ? " " + job.slots[slot].name : "";
    }
  }
}

std::vector<std::optional<Element>> SlotColumns::row(const Block& setup) const {
  std::vector<std::optional<Element>> cells;
  const std::vector<Block> parts = by_slot(setup);
  for (std::size_t slot = 0; slot < widths_.size(); ++slot) {
    for (std::size_t i = 0; i < widths_[slot]; ++i) {
      cells.push_back(i < parts[slot].size() ? std::optional(parts[slot][i]) : std::nullopt);
    }
  }
  return cells;
}

}  // namespace changeover
