#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/two_levels.hpp"

namespace changeover {
namespace {

std::uint64_t followed(std::uint64_t items, std::uint64_t room, std::uint64_t fast_room) {
  if (items == 0 || room == 0 || fast_room == 0) {
    throw BadInput(fmt::format("{} items, room for {} and {}: give at least 1 of each", items, room,
                               fast_room));
  }
  if (items > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to be followed one by one; {} is the most", items,
                    max_elements_in_memory));
  }
  return items;
}

}  // namespace

TwoLevelCheck::TwoLevelCheck(std::uint64_t items, std::uint64_t room, std::uint64_t fast_room)
    : room_(room),
      fast_room_(fast_room),
      place_(static_cast<std::size_t>(followed(items, room, fast_room)), Place::disk),
      computed_(items) {}

void TwoLevelCheck::move(const std::vector<Element>& items, Place from, Place to,
                         const char* what) {
  for (const Element x : items) {
    if (!verdict_.fault.empty()) {
      return;
    }
    if (x >= place_.size() || place_[x] != from) {
      verdict_.fault =
          fmt::format("step {} {} {}, which is not there to be moved", verdict_.steps, what, x);
      return;
    }
    place_[x] = to;
    in_memory_ += from == Place::disk ? 1U : 0U;
    in_memory_ -= to == Place::disk ? 1U : 0U;
    on_accelerator_ += to == Place::accelerator ? 1U : 0U;
    on_accelerator_ -= from == Place::accelerator ? 1U : 0U;
    if (in_memory_ > room_ || on_accelerator_ > fast_room_) {
      verdict_.fault = fmt::format("step {} {} {} when {} is full", verdict_.steps, what, x,
                                   in_memory_ > room_ ? "memory" : "the accelerator");
    }
  }
}

void TwoLevelCheck::read(const TwoLevelStep& step) {
  if (!verdict_.fault.empty()) {
    return;
  }
  ++verdict_.steps;
  if (step.number != verdict_.steps) {
    verdict_.fault = fmt::format("step {} is numbered {}", verdict_.steps, step.number);
    return;
  }
  move(step.fast_evict, Place::accelerator, Place::memory, "takes from the accelerator");
  move(step.evict, Place::memory, Place::disk, "evicts");
  move(step.load, Place::disk, Place::memory, "loads");
  move(step.fast_load, Place::memory, Place::accelerator, "transfers");
  verdict_.loads += step.load.size();
  verdict_.transfers += step.fast_load.size();
  for (const auto& [x, y] : step.pairs) {
    if (verdict_.fault.empty() &&
        (x >= y || y >= place_.size() || place_[x] != Place::accelerator ||
         place_[y] != Place::accelerator)) {
      verdict_.fault = fmt::format("step {} computes ({},{}) without both on the accelerator",
                                   step.number, x, y);
    }
    if (!verdict_.fault.empty()) {
      return;
    }
    ++verdict_.computed;
    verdict_.repeated += computed_.contains(x, y) ? 1U : 0U;
    computed_.insert(x, y);
  }
}

TwoLevelVerdict TwoLevelCheck::finish() const {
  TwoLevelVerdict verdict = verdict_;
  verdict.missing = computed_.missing();
  return verdict;
}

}  // namespace changeover
