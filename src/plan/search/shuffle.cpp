#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/first_plan.hpp"
#include "plan/search/interchangeable.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

// By part: a row of bits for its partners.
class Rows {
 public:
  explicit Rows(const PairSet& pairs)
      : words_((static_cast<std::size_t>(pairs.v()) + 63) / 64),
        bits_(words_ * static_cast<std::size_t>(pairs.v()), 0) {
    pairs.for_each(all_of_them, [&](Element x, Element y) {
      bits_[x * words_ + y / 64] |= std::uint64_t{1} << (y % 64);
      bits_[y * words_ + x / 64] |= std::uint64_t{1} << (x % 64);
    });
  }

  // Whether x and y have the same partners, except for each other.
  [[nodiscard]] bool alike(Element x, Element y) const {
    for (std::size_t w = 0; w < words_; ++w) {
      std::uint64_t others = ~std::uint64_t{0};
      for (const Element z : {x, y}) {
        others &= z / 64 == w ? ~(std::uint64_t{1} << (z % 64)) : ~std::uint64_t{0};
      }
      if (((bits_[x * words_ + w] ^ bits_[y * words_ + w]) & others) != 0) {
        return false;
      }
    }
    return true;
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<std::vector<Element>> interchangeable_parts(const Job& job) {
  const Rows needed(job.needed);
  const Rows never(job.never);
  const auto in = [](const Block& block, Element x) {
    return std::find(block.begin(), block.end(), x) != block.end();
  };
  std::vector<std::vector<Element>> classes;
  for (Element x = 0; x < job.parts(); ++x) {
    const auto fitting = std::find_if(classes.begin(), classes.end(), [&](const auto& members) {
      const Element y = members.front();
      return job.change_costs[x] == job.change_costs[y] &&
             (job.slot_of.empty() || job.slot_of[x] == job.slot_of[y]) &&
             in(job.mounted, x) == in(job.mounted, y) && in(job.start, x) == in(job.start, y) &&
             needed.alike(x, y) && never.alike(x, y);
    });
    if (fitting == classes.end()) {
      classes.push_back({x});
    } else {
      fitting->push_back(x);
    }
  }
  return classes;
}

RunPlan shuffled(const Job& job, RunPlan plan, std::uint64_t seed, std::uint64_t& exchanged) {
  refuse_replacing(job, "exchanging parts");
  if (!job.first.empty()) {
    return shuffled_with_first(job, std::move(plan), seed, exchanged);
  }
  std::vector<Element> now(job.names.size());  // by part: its replacement
  Random random(seed, 3'000'000);
  exchanged = 0;
  for (const std::vector<Element>& members : interchangeable_parts(job)) {
    std::vector<Element> mixed = members;
    for (std::size_t i = mixed.size(); i > 1; --i) {
      std::swap(mixed[i - 1], mixed[random.below(static_cast<std::uint32_t>(i))]);
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      now[members[i]] = mixed[i];
      exchanged += members[i] == mixed[i] ? 0U : 1U;
    }
  }
  if (exchanged == 0) {
    return plan;
  }
  std::vector<Block>& setups = plan.candidates.front().setups;
  for (Block& setup : setups) {
    for (Element& x : setup) {
      x = now[x];
    }
    std::sort(setup.begin(), setup.end());
  }
  const RunSheet before = std::exchange(plan.sheet, run_sheet(job, setups));
  if (!plan.sheet.faults.empty() || plan.sheet.cost != before.cost ||
      plan.sheet.pairs_tested != before.pairs_tested) {
    throw InternalError("exchanging parts that are alike changed the plan");
  }
  return plan;
}

}  // namespace changeover
