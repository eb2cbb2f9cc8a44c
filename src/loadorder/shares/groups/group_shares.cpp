#include "loadorder/shares/groups/group_shares.hpp"

#include <algorithm>
#include <numeric>

#include "core/checked.hpp"

namespace changeover {
namespace {

/// The number of items that are loaded at a time, and whether those before them stay for one more
/// step.
struct Pace {
  std::uint64_t items = 0;
  bool overlaps = false;
};

// 0 items if the share does not fit.
Pace pace_of(std::uint64_t held, std::uint64_t streamed, std::uint64_t room) {
  if (held + streamed <= room) {
    return {std::max<std::uint64_t>(1, streamed), false};
  }
  const std::uint64_t places = room - std::min(room, held);
  return places < 2 ? Pace{places, false} : Pace{places / 2, true};
}

class ShareSteps final : public StepSource {
 public:
  ShareSteps(const GroupShare& share, const ItemGroups& groups, std::uint64_t room,
             std::uint64_t worker)
      : worker_(worker) {
    groups.put(share.held, held_);
    groups.put(share.streamed, streamed_);
    pace_ = pace_of(held_.size(), streamed_.size(), room);
  }

  bool next(Step& step) override {
    if (number_ > 0 ? next_ == streamed_.size() : held_.empty()) {
      return false;
    }
    step.number = ++number_;
    step.worker = worker_;
    step.load.clear();
    step.evict.clear();
    if (number_ == 1) {
      step.load = held_;
    }
    const std::size_t end = std::min<std::size_t>(next_ + pace_.items, streamed_.size());
    if (number_ > (pace_.overlaps ? 2U : 1U)) {
      const std::size_t gone = next_ - pace_.items * (pace_.overlaps ? 2 : 1);
      step.evict.assign(at(gone), at(gone + pace_.items));
    }
    step.load.insert(step.load.end(), at(next_), at(end));
    next_ = end;
    return true;
  }

  bool jump(std::uint64_t step, std::vector<Element>& held) override {
    const std::uint64_t before = (step - 1) * pace_.items;
    if (step == 0 || (step > 1 && before >= streamed_.size())) {
      return false;
    }
    number_ = step - 1;
    next_ = static_cast<std::size_t>(before);
    held.clear();
    if (step > 1) {
      const std::uint64_t there = pace_.items * (pace_.overlaps && step > 2 ? 2 : 1);
      held = held_;
      held.insert(held.end(), at(next_ - static_cast<std::size_t>(there)), at(next_));
    }
    return true;
  }

 private:
  [[nodiscard]] std::vector<Element>::const_iterator at(std::size_t i) const {
    return streamed_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  std::uint64_t worker_;
  std::vector<Element> held_;
  std::vector<Element> streamed_;
  Pace pace_;
  std::size_t next_ = 0;  // of the streamed items
  std::uint64_t number_ = 0;
};

}  // namespace

void ItemGroups::put(const std::vector<Element>& of, std::vector<Element>& out) const {
  for (const Element group : of) {
    const std::uint64_t first = begin(group);
    out.resize(out.size() + static_cast<std::size_t>(end(group) - first));
    std::iota(out.end() - static_cast<std::ptrdiff_t>(end(group) - first), out.end(),
              static_cast<Element>(first));
  }
}

void refine(GroupShares& shares, std::uint64_t parts) {
  for (GroupShare& share : shares.workers) {
    for (std::vector<Element>* const list : {&share.held, &share.streamed}) {
      std::vector<Element> fine;
      for (const Element group : *list) {
        for (std::uint64_t i = 0; i < parts; ++i) {
          fine.push_back(static_cast<Element>(group * parts + i));
        }
      }
      *list = std::move(fine);
    }
  }
  shares.groups *= parts;
}

ShareCost cost_of(const GroupShare& share, const ItemGroups& groups, std::uint64_t room) {
  const std::uint64_t held = groups.size(share.held);
  const std::uint64_t streamed = groups.size(share.streamed);
  if (held == 0) {
    return {};
  }
  const Pace pace = pace_of(held, streamed, room);
  if (held > room || pace.items == 0) {
    return {held + streamed, 0};
  }
  return {held + streamed, std::max<std::uint64_t>(1, ceil_div(streamed, pace.items))};
}

std::unique_ptr<StepSource> share_steps(const GroupShare& share, const ItemGroups& groups,
                                        std::uint64_t room, std::uint64_t worker) {
  return std::make_unique<ShareSteps>(share, groups, room, worker);
}

}  // namespace changeover
