#include "plan/sheet/slot_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover {

std::size_t SlotColumns::slot_of(Element x) const {
  const bool is_free = job_->slot_of.empty() || job_->slot_of[x] == no_slot;
  return is_free ? job_->slots.size() : job_->slot_of[x];
}

SlotColumns::SlotColumns(const Job& job, const std::vector<const RunSheet*>& sheets) : job_(&job) {
  std::vector<std::size_t> widths(job.slots.size() + 1, 0);
  for (const RunSheet* sheet : sheets) {
    for (const RunStep& step : sheet->steps) {
      std::vector<std::size_t> parts(widths.size(), 0);
      for (const Element x : step.setup) {
        const std::size_t slot = slot_of(x);
        widths[slot] = std::max(widths[slot], ++parts[slot]);
      }
    }
  }
  for (std::size_t slot = 0; slot < widths.size(); ++slot) {
    for (std::size_t i = 0; i < widths[slot]; ++i) {
      places_.emplace_back(slot, i);
      heads_.push_back(fmt::format("slot_{}{}", places_.size(),
                                   slot < job.slots.size() ? " " + job.slots[slot].name : ""));
    }
  }
}

std::optional<Element> SlotColumns::part(const Block& setup, std::size_t column) const {
  auto [slot, before] = places_[column];
  if (job_->slots.empty()) {
    return before < setup.size() ? std::optional(setup[before]) : std::nullopt;
  }
  for (const Element x : setup) {
    if (slot_of(x) == slot && before-- == 0) {
      return x;
    }
  }
  return std::nullopt;
}

}  // namespace changeover
