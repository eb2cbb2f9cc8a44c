#include "changeover/verify/fans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "verify/met_elements.hpp"
#include "verify/own_count.hpp"

namespace changeover {
namespace {

class FanVerification {
 public:
  explicit FanVerification(const Parameters& p) : met_(p.v) {
    verdict_.parameters = p;
    block_.reserve(static_cast<std::size_t>(p.k));
  }

  void add(const Fan& fan) {
    ++verdict_.fans;
    require_blocks(fan);
    std::swap(before_, block_);
    with(fan.kept, fan.first, block_);
    introduced_.clear();
    std::ranges::set_difference(block_, before_, std::back_inserter(introduced_));
    if (verdict_.b == 0) {
      first_ = block_;
      always_ = block_;
    } else {
      judge_step(introduced_.size(), 1);
    }
    covered(introduced_.size(), 1);
    verdict_.b = checked_add(verdict_.b, 1);
    meet_introduced();
    if (fan.last > fan.first) {
      add_others(fan);
    }
    keep_always(fan);
  }

  FanVerdict finish() {
    const Parameters& p = verdict_.parameters;
    std::uint64_t never_newly = 0;
    if (p.kind == Kind::circular && verdict_.b > 1) {
      introduced_.clear();
      std::ranges::set_difference(first_, block_, std::back_inserter(introduced_));
      judge_step(introduced_.size(), 1);
      // The first block counted as if nothing preceded it.
      covered_ -= newly_covered(p.k) - newly_covered(introduced_.size());
      never_newly = binomial(always_.size(), 2);
    }
    MetElements::Missing missing = met_.missing(FanVerdict::most_examples);
    verdict_.uncovered = missing.pairs;
    verdict_.uncovered_examples = std::move(missing.examples);
    const std::uint64_t occurring = binomial(p.v, 2) - verdict_.uncovered;
    verdict_.excess = covered_ - (occurring - never_newly);
    verdict_.never_newly_covered = never_newly;
    verdict_.counting_bound = economical_blocks(p);
    return std::move(verdict_);
  }

 private:
  // k distinct elements below v in each block.
  void require_blocks(const Fan& fan) {
    const Parameters& p = verdict_.parameters;
    const auto refuse = [&](const std::string& what) {
      throw BadInput(fmt::format("fan {}: {}", verdict_.fans, what));
    };
    if (fan.kept.size() + 1 != p.k || fan.first > fan.last) {
      refuse(fmt::format("it must keep k-1 = {} elements beside an interval", p.k - 1));
    }
    kept_.assign(fan.kept.begin(), fan.kept.end());
    std::ranges::sort(kept_);
    const Element greatest = kept_.empty() ? fan.last : std::max(kept_.back(), fan.last);
    if (greatest >= p.v) {
      refuse(fmt::format("element {} is not below v = {}", greatest, p.v));
    }
    if (const auto twin = std::ranges::adjacent_find(kept_); twin != kept_.end()) {
      refuse(fmt::format("it repeats the element {}", *twin));
    }
    const auto inside = std::ranges::lower_bound(kept_, fan.first);
    if (inside != kept_.end() && *inside <= fan.last) {
      refuse(fmt::format("it repeats the element {}", *inside));
    }
  }

  // The kept elements and another one, sorted.
  void with(std::span<const Element> kept, Element x, Block& block) const {
    block.assign(kept.begin(), kept.end());
    block.push_back(x);
    std::ranges::sort(block);
  }

  void judge_step(std::uint64_t changes, std::uint64_t times) {
    if (changes != verdict_.parameters.change) {
      verdict_.bad_steps += times;
      if (!verdict_.first_bad_step) {
        verdict_.first_bad_step = verdict_.b;
      }
    }
  }

  [[nodiscard]] std::uint64_t newly_covered(std::uint64_t introduced) const {
    return introduced * (verdict_.parameters.k - introduced) + introduced * (introduced - 1) / 2;
  }
  void covered(std::uint64_t introduced, std::uint64_t times) {
    covered_ = checked_add(covered_, checked_multiply(newly_covered(introduced), times));
  }

  // All pairs of the block with an introduced element.
  void meet_introduced() {
    for (const Element x : introduced_) {
      for (const Element y : block_) {
        if (x != y) {
          met_.meet(std::max(x, y), {std::min(x, y), std::min(x, y)});
        }
      }
    }
  }

  // The blocks of the fan after its first one.
  void add_others(const Fan& fan) {
    const std::uint64_t others = fan.block_count() - 1;
    judge_step(1, others);
    covered(1, others);
    verdict_.b = checked_add(verdict_.b, others);
    for (const Element x : fan.kept) {
      met_.meet(x, {fan.first, fan.last});
    }
    with(fan.kept, fan.last, block_);
  }

  // The elements of every block so far: those of a fan of one block, or kept ones.
  void keep_always(const Fan& fan) {
    if (!always_.empty()) {
      const Block& all = fan.first == fan.last ? block_ : kept_;
      std::erase_if(always_, [&](Element x) { return !std::ranges::binary_search(all, x); });
    }
  }

  FanVerdict verdict_;
  MetElements met_;
  std::uint64_t covered_ = 0;
  Block first_;
  Block always_;      // elements of every block, sorted
  Block before_;      // the last block of the fan before, sorted
  Block block_;       // the block that is read, sorted
  Block kept_;        // elements of the fan, sorted
  Block introduced_;  // by its first block
};

}  // namespace

FanVerdict verify_fans(FanSource& source) {
  const Parameters& p = source.parameters();
  check(p);
  if (p.strength != 2) {
    throw BadInput(
        fmt::format("fans are verified for strength 2, not {}; read the blocks", p.strength));
  }
  FanVerification verification(p);
  constexpr std::uint64_t fans_between_looks = 4096;
  for (std::uint64_t fans = 0; const auto fan = source.next(); ++fans) {
    if (fans % fans_between_looks == 0) {
      stop_if_asked();
    }
    verification.add(*fan);
  }
  return verification.finish();
}

}  // namespace changeover
