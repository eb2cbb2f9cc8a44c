#include "plan/search/benches/fullest_bench.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/bit_number.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_shared_benches = 6;
constexpr std::uint64_t most_sharing_steps = 300'000;

// Gives the parts, one after the other, to sets of benches.
class PartSharing {
 public:
  PartSharing(const SharedParts& shared, std::size_t benches, Amount known)
      : shared_(&shared),
        known_(known),
        benches_(benches),
        given_(shared.costs.size(), 0),
        meeting_(std::size_t{1} << benches, 0),
        of_size_(benches, 0),
        there_(benches, std::vector<std::uint64_t>(shared.limits.size(), 0)),
        costs_(benches) {
    best_ = shared.test * tests_of(std::vector<bool>(shared.costs.size(), true));
    for (const Amount cost : shared.costs) {
      best_ += cost;  // a bench that has all
    }
    for (Set set = 1; set < meeting_.size(); ++set) {
      of_size_[number_of_bits(set) - 1] |= Sets{1} << set;
      for (Set other = 1; other < meeting_.size(); ++other) {
        meeting_[set] |= (set & other) != 0 ? Sets{1} << other : 0;
      }
    }
  }

  std::optional<Amount> run() {
    give(0, 0, std::vector<Sets>(given_.size(), ~Sets{0}));
    return steps_ <= most_sharing_steps && best_ > known_ ? std::optional(best_) : std::nullopt;
  }

 private:
  using Set = std::uint32_t;   // of benches: bit w is bench w
  using Sets = std::uint64_t;  // bit s is the set s

  [[nodiscard]] std::uint64_t tests_of(const std::vector<bool>& parts) const {
    std::uint64_t tests = 0;
    for (const auto& [counted, most] : shared_->limits) {
      std::uint64_t there = 0;
      for (std::size_t x = 0; x < parts.size(); ++x) {
        there += parts[x] && counted[x] ? 1U : 0U;
      }
      tests = std::max(tests, ceil_div(there, most));
    }
    return tests;
  }

  [[nodiscard]] Amount cost_of(std::size_t bench) const {
    std::uint64_t tests = 0;
    for (std::size_t i = 0; i < shared_->limits.size(); ++i) {
      tests = std::max(tests, ceil_div(there_[bench][i], shared_->limits[i].second));
    }
    return costs_[bench] + shared_->test * tests;
  }

  // Whether parts can change places: they cost the same, count the same, and meet the same others.
  [[nodiscard]] bool alike(std::size_t x, std::size_t y) const {
    bool same = shared_->costs[x] == shared_->costs[y];
    for (const auto& [counted, most] : shared_->limits) {
      same = same && counted[x] == counted[y];
    }
    for (std::size_t z = 0; z < given_.size() && same; ++z) {
      same = z == x || z == y || shared_->meet[x][z] == shared_->meet[y][z];
    }
    return same;
  }

  // Whether the benches must cost too much together, with the parts from this one on.
  [[nodiscard]] bool is_too_costly(std::size_t from, const std::vector<Sets>& open) const {
    Amount together;
    for (std::size_t w = 0; w < benches_; ++w) {
      const Amount cost = cost_of(w);
      if (cost >= best_) {
        return true;
      }
      together += cost;
    }
    for (std::size_t x = from; x < open.size(); ++x) {
      std::size_t least = 0;
      while (least < benches_ && (open[x] & of_size_[least]) == 0) {
        ++least;
      }
      together += shared_->costs[x] * (least + 1);
    }
    return together >= best_ * benches_;
  }

  // `open`: by part, the sets that it may be given to.
  void give(std::size_t part, std::size_t used, const std::vector<Sets>& open) {
    if (++steps_ > most_sharing_steps || best_ <= known_) {
      return;
    }
    stop_if_asked();
    if (is_too_costly(part, open)) {
      return;
    }
    if (part == open.size()) {
      best_ = Amount{};
      for (std::size_t w = 0; w < benches_; ++w) {
        best_ = std::max(best_, cost_of(w));
      }
      return;
    }
    const Set first = part > 0 && alike(part, part - 1) ? given_[part - 1] : 1;
    for (Set set = first; set < Set{1} << benches_; ++set) {
      const Set fresh = set >> used;  // benches without parts are alike: the first of them
      if ((fresh & (fresh + 1)) != 0 || (open[part] >> set & 1U) == 0) {
        continue;
      }
      std::vector<Sets> left = open;
      for (std::size_t y = part + 1; y < open.size(); ++y) {
        left[y] &= shared_->meet[part][y] ? meeting_[set] : ~Sets{0};
      }
      take(part, set, true);
      give(part + 1, used + number_of_bits(fresh), left);
      take(part, set, false);
    }
  }

  void take(std::size_t part, Set set, bool on) {
    given_[part] = set;
    for (std::size_t w = 0; w < benches_; ++w) {
      if ((set >> w & 1U) == 0) {
        continue;
      }
      costs_[w] = on ? costs_[w] + shared_->costs[part] : costs_[w] - shared_->costs[part];
      for (std::size_t i = 0; i < shared_->limits.size(); ++i) {
        if (shared_->limits[i].first[part]) {
          there_[w][i] = on ? there_[w][i] + 1 : there_[w][i] - 1;
        }
      }
    }
  }

  const SharedParts* shared_;
  Amount known_;
  std::size_t benches_;
  std::vector<Set> given_;                         // by part
  std::vector<Sets> meeting_;                      // by set: those that have a bench of it
  std::vector<Sets> of_size_;                      // by number of benches less one
  std::vector<std::vector<std::uint64_t>> there_;  // by bench and limit: number of parts
  std::vector<Amount> costs_;                      // by bench, without tests
  Amount best_;
  std::uint64_t steps_ = 0;
};

}  // namespace

SharedParts shared_parts(const Job& job, const JobNumbers& n,
                         const std::function<bool(Element)>& is_there) {
  const std::size_t v = n.parts.size();
  SharedParts shared{.meet = std::vector<std::vector<bool>>(v, std::vector<bool>(v)),
                     .limits = {{std::vector<bool>(v, true), std::max<std::uint64_t>(n.room, 1)}},
                     .test = job.test_cost};
  for (std::size_t x = 0; x < v; ++x) {
    shared.costs.push_back(is_there(n.parts[x]) ? Amount{} : job.change_costs[n.parts[x]]);
    for (std::size_t y = 0; y < v; ++y) {
      shared.meet[x][y] = x != y && job.needed.contains(n.parts[x], n.parts[y]);
    }
  }
  for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
    std::vector<bool> in_slot;
    in_slot.reserve(v);
    for (const Element x : n.parts) {
      in_slot.push_back(n.slot_of[x] == s);
    }
    shared.limits.emplace_back(std::move(in_slot), std::max<std::uint64_t>(n.most[s], 1));
  }
  return shared;
}

std::optional<Amount> cost_of_fullest(const SharedParts& shared, std::size_t benches,
                                      Amount known) {
  if (benches > most_shared_benches || shared.costs.empty()) {
    return std::nullopt;
  }
  return PartSharing(shared, benches, known).run();
}

}  // namespace changeover
