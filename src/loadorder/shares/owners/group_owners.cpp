#include "loadorder/shares/owners/group_owners.hpp"

#include <algorithm>
#include <cmath>

#include "core/checked.hpp"
#include "loadorder/shares/owners/pouring.hpp"

namespace changeover {
namespace {

// The place of a pair of groups, or of a group with itself.
std::uint64_t place_of(std::uint64_t group, std::uint64_t other) {
  const std::uint64_t larger = std::max(group, other);
  return larger * (larger + 1) / 2 + std::min(group, other);
}

class GroupRule final : public PairRule {
 public:
  GroupRule(const GroupOwners& owners, std::uint64_t worker) : owners_(owners), worker_(worker) {}
  [[nodiscard]] bool computes(std::uint64_t step, Element x, Element y) const override {
    return owners_.computes(worker_, step, x, y);
  }

 private:
  const GroupOwners& owners_;
  std::uint64_t worker_;
};

}  // namespace

GroupOwners::GroupOwners(const ItemGroups& groups, std::uint64_t workers)
    : groups_(groups), pairs_(static_cast<std::size_t>(workers), 0) {
  group_of_.resize(static_cast<std::size_t>(groups.items));
  for (std::uint64_t x = 0; x < groups.items; ++x) {
    group_of_[static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(groups.group_of(x));
  }
}

void GroupOwners::add(std::uint64_t worker, Element group, Element other, std::uint64_t step) {
  added_.push_back({place_of(group, other), step, static_cast<std::uint32_t>(worker)});
}

void GroupOwners::balance(double part) {
  std::ranges::stable_sort(added_, {}, &Added::place);
  const std::uint64_t places = place_of(groups_.groups, 0);
  Pouring pouring;
  pouring.begin.assign(static_cast<std::size_t>(places) + 1, 0);
  std::vector<std::uint64_t> cells;
  cells.reserve(static_cast<std::size_t>(places));
  for (std::uint64_t i = 0; i < groups_.groups; ++i) {
    for (std::uint64_t j = 0; j <= i; ++j) {
      cells.push_back(i == j ? binomial(groups_.size(i), 2) : groups_.size(i) * groups_.size(j));
    }
  }
  parts_.clear();
  for (const Added& each : added_) {
    ++pouring.begin[static_cast<std::size_t>(each.place) + 1];
    pouring.worker.push_back(each.worker);
    parts_.push_back({each.step, 0, each.worker});
  }
  added_ = {};
  for (std::size_t at = 0; at < cells.size(); ++at) {
    missing_ += cells[at] > 0 && pouring.begin[at + 1] == 0 ? 1U : 0U;
    pouring.begin[at + 1] += pouring.begin[at];
    pouring.amount.push_back(static_cast<double>(cells[at]));
  }
  pouring.pour(pairs_.size(), part);
  begin_ = std::move(pouring.begin);
  // Portions are rounded where they meet, so that none is lost.
  for (std::size_t at = 0; at < cells.size(); ++at) {
    double sum = 0;
    std::uint64_t before = 0;
    for (std::uint64_t p = begin_[at]; p < begin_[at + 1]; ++p) {
      sum += pouring.portion[p];
      parts_[p].end =
          p + 1 == begin_[at + 1]
              ? cells[at]
              : std::clamp(static_cast<std::uint64_t>(std::llround(sum)), before, cells[at]);
      pairs_[parts_[p].worker] += parts_[p].end - before;
      before = parts_[p].end;
    }
  }
}

std::uint64_t GroupOwners::begin_of(Element group, Element other, std::size_t next) const {
  return begin_[static_cast<std::size_t>(place_of(group, other)) + next];
}

std::unique_ptr<const PairRule> GroupOwners::of(std::uint64_t worker) const {
  return std::make_unique<GroupRule>(*this, worker);
}

bool GroupOwners::computes(std::uint64_t worker, std::uint64_t step, Element x, Element y) const {
  std::uint64_t i = group_of_[x];
  std::uint64_t j = group_of_[y];
  if (i < j) {
    std::swap(i, j);
    std::swap(x, y);
  }
  const auto at = static_cast<std::size_t>(place_of(i, j));
  const auto is_of = [&](const Part& part) {
    return part.worker == worker && (part.step == 0 || part.step == step);
  };
  if (x == y) {  // assigned in turn to the workers that have the group
    const std::uint64_t parts = begin_[at + 1] - begin_[at];
    return parts > 0 && is_of(parts_[begin_[at] + (x - groups_.begin(i)) % parts]);
  }
  std::uint64_t cell = 0;
  if (i == j) {
    const std::uint64_t high = std::max(x, y) - groups_.begin(i);
    cell = high * (high - 1) / 2 + (std::min(x, y) - groups_.begin(i));
  } else {
    cell = (x - groups_.begin(i)) * groups_.size(j) + (y - groups_.begin(j));
  }
  for (std::uint64_t p = begin_[at]; p < begin_[at + 1]; ++p) {
    if (cell < parts_[p].end) {
      return is_of(parts_[p]);
    }
  }
  return false;
}

std::shared_ptr<const GroupOwners> owners_of(const GroupShares& shares, std::uint64_t items,
                                             double part) {
  auto owners =
      std::make_shared<GroupOwners>(ItemGroups{items, shares.groups}, shares.workers.size());
  for (std::uint64_t w = 0; w < shares.workers.size(); ++w) {
    const GroupShare& share = shares.workers[static_cast<std::size_t>(w)];
    for (std::size_t i = 0; i < share.held.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        owners->add(w, share.held[i], share.held[j], 0);
      }
      for (const Element streamed : share.streamed) {
        owners->add(w, share.held[i], streamed, 0);
      }
    }
  }
  owners->balance(part);
  return owners;
}

}  // namespace changeover
