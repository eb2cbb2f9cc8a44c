#include "changeover/loadorder/write_back.hpp"

#include <fmt/format.h>

namespace changeover {

void WriteBack::read(StoredStep& step) {
  step.store.clear();
  for (const Element x : step.work.loads.evict) {
    held_[x] = false;
    if (changed_[x]) {
      step.store.push_back(x);
      changed_[x] = false;
    }
  }
  for (const Element x : step.work.loads.load) {
    held_[x] = true;
  }
  for (const auto& [x, y] : step.work.pairs) {
    changed_[x] = true;
    changed_[y] = true;
  }
  number_ = step.work.loads.number;
  stores_ += step.store.size();
}

void WriteBack::finish(StoredStep& step) {
  step = {};
  step.work.loads.number = number_ + 1;
  for (Element x = 0; x < held_.size(); ++x) {
    if (held_[x]) {
      step.work.loads.evict.push_back(x);
    }
  }
  read(step);
}

StoreCheck::StoreCheck(std::uint64_t items)
    : changes_(static_cast<std::size_t>(items), 0),
      on_disk_(changes_),
      in_memory_(changes_.size(), absent) {}

void StoreCheck::fail(const StoredStep& step, const std::string& what) {
  if (fault_.empty()) {
    fault_ = fmt::format("step {} {}", step.work.loads.number, what);
  }
}

void StoreCheck::read(std::span<const StoredStep> steps) {
  if (!fault_.empty()) {
    return;
  }
  const std::size_t items = changes_.size();
  for (const StoredStep& step : steps) {
    for (const Element x : step.store) {
      if (x >= items || in_memory_[x] == absent) {
        return fail(step, fmt::format("stores {}, which is not held", x));
      }
      if (in_memory_[x] == on_disk_[x]) {
        return fail(step, fmt::format("stores {}, which has not changed", x));
      }
      on_disk_[x] = in_memory_[x];
    }
    for (const Element x : step.work.loads.evict) {
      if (x >= items || in_memory_[x] == absent) {
        return fail(step, fmt::format("evicts {}, which is not held", x));
      }
      in_memory_[x] = absent;
      if (on_disk_[x] != changes_[x]) {
        return fail(step, fmt::format("evicts {} and loses what was changed", x));
      }
    }
  }
  for (const StoredStep& step : steps) {
    for (const Element x : step.work.loads.load) {
      if (x >= items || in_memory_[x] != absent) {
        return fail(step, fmt::format("loads {}, which is held or no item", x));
      }
      in_memory_[x] = on_disk_[x];
    }
  }
  for (const StoredStep& step : steps) {
    for (const auto& [x, y] : step.work.pairs) {
      for (const Element z : {x, y}) {
        if (z >= items || in_memory_[z] == absent) {
          return fail(step, fmt::format("changes {}, which is not held", z));
        }
        ++changes_[z];
        ++in_memory_[z];
      }
    }
  }
}

std::string StoreCheck::finish() const {
  if (!fault_.empty()) {
    return fault_;
  }
  for (std::size_t x = 0; x < changes_.size(); ++x) {
    if (in_memory_[x] != absent) {
      return fmt::format("{} is still held at the end", x);
    }
    if (on_disk_[x] != changes_[x]) {
      return fmt::format("{} lost what was changed", x);
    }
  }
  return "";
}

LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted, std::uint64_t items,
                            bool alone) {
  std::uint64_t without_pair = 0;
  if (!alone && wanted.are_all()) {
    without_pair = items == 1 ? 1 : 0;
  } else if (!alone && wanted.graph() != nullptr) {
    for (Element x = 0; x < wanted.items(); ++x) {
      without_pair += wanted.needs(x) && wanted.graph()->partners(x).empty() ? 1U : 0U;
    }
  }
  // A bound on loads counts each of them once.
  const std::uint64_t least = loads.loads > without_pair ? loads.loads - without_pair : 0;
  return {least,
          "a stay in memory in which an item changes has a load and a store, and the other "
          "stays can be left out"};
}

}  // namespace changeover
