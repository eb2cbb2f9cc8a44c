#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/tools/path.hpp"
#include "run/grace.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/random_list.hpp"
#include "search/repair/repair_cover.hpp"
#include "search/repair/repair_one_change.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t first_moves = 4096;
constexpr int anneals_of_a_length = 3;
constexpr int samples_of_replacements = 200;

std::size_t changes(const Block& from, const Block& to) { return difference(from, to).size(); }

/// Mends the steps of a list.
class Steps {
 public:
  Steps(const Design& list, Random& random) : list_(list), p_(list.parameters()), random_(random) {}

  Design mended() {
    const std::size_t b = list_.block_count();
    for (std::size_t i = 0; i < b; ++i) {
      stop_if_asked();
      Block block = block_of(list_, i);
      if (!blocks_.empty() && !follows(block)) {
        if (auto other = replacement(block, i)) {
          block = *std::move(other);
        } else if (changes(blocks_.back(), block) == 0) {
          continue;
        } else {
          walk_to(block);
        }
      }
      blocks_.push_back(std::move(block));
    }
    if (p_.kind == Kind::circular && blocks_.size() > 1) {
      if (changes(blocks_.back(), blocks_.front()) == 0) {
        blocks_.pop_back();
      }
      if (blocks_.size() > 1 && !follows(blocks_.front())) {
        walk_to(blocks_.front());
      }
    }
    Design design(p_, blocks_);
    design.set_labels(list_.labels());
    return design;
  }

 private:
  [[nodiscard]] bool follows(const Block& block) const {
    return changes(blocks_.back(), block) == p_.change;
  }

  void walk_to(const Block& block) {
    const std::vector<Block> way = connecting_blocks(blocks_.back(), block, p_.change, p_.v);
    blocks_.insert(blocks_.end(), way.begin(), way.end());
  }

  // Block i fits neither neighbour: returns, of some candidates, the nearest block that fits both.
  std::optional<Block> replacement(const Block& block, std::size_t i) {
    const std::size_t b = list_.block_count();
    if (i + 1 == b && p_.kind == Kind::linear) {
      return std::nullopt;
    }
    const Block next = i + 1 < b ? block_of(list_, i + 1) : blocks_.front();
    if (changes(block, next) == p_.change) {
      return std::nullopt;
    }
    std::optional<Block> best;
    for (int sample = 0; sample < samples_of_replacements; ++sample) {
      auto way = random_walk(blocks_.back(), next, 2, p_, random_);
      if (!way) {
        return std::nullopt;
      }
      if (!best || changes(block, way->front()) < changes(block, *best)) {
        best = std::move(way->front());
      }
    }
    return best;
  }

  const Design& list_;
  const Parameters& p_;
  Random& random_;
  std::vector<Block> blocks_;
};

// The number of blocks of the list that are in the design, each counted once.
std::uint64_t kept_blocks(const Design& list, const Design& design) {
  std::multiset<Block> there;
  const auto sorted = [](Block block) {
    std::ranges::sort(block);
    return block;
  };
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    there.insert(sorted(block_of(design, i)));
  }
  std::uint64_t kept = 0;
  for (std::size_t i = 0; i < list.block_count(); ++i) {
    if (const auto at = there.find(sorted(block_of(list, i))); at != there.end()) {
      there.erase(at);
      ++kept;
    }
  }
  return kept;
}

void require_possible(const Design& list) {
  const Parameters& p = list.parameters();
  check(p);
  if (list.block_count() == 0) {
    throw BadInput("the list has no block; give at least one, or search from scratch");
  }
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
}

/// One repair, from the list to the design.
class Repair {
 public:
  Repair(const Design& list, const RepairOptions& options, RunControl& control)
      : list_(list), options_(options), control_(control), random_(control.seed()) {}

  RepairResult run() {
    const RunGrace grace(control_, usual_grace);
    try {
      work();
    } catch (const Stopped&) {
      result_.why_stopped = control_.why_stopped();
    }
    return std::move(result_);
  }

 private:
  void work() {
    const Verdict before = verify(list_);
    result_.given = list_.block_count();
    result_.bad_steps = before.bad_steps;
    result_.uncovered = before.uncovered;
    if (before.valid()) {
      keep(list_);
      return;
    }
    if (list_.v() == list_.k()) {
      keep(Design(list_.parameters(), std::vector<Block>{block_of(list_, 0)}));
      return;
    }
    if (list_.block_count() > 1) {
      if (auto design = repaired_by_one_change(list_, before)) {
        keep(*std::move(design));
        return;
      }
    }
    const Design mended = Steps(list_, random_).mended();
    if (verify(mended).valid()) {
      keep(mended);
      return;
    }
    result_.unsearched = annealing_fault([&] { anneal(mended); });
    if (!result_.design) {
      keep(cover_the_rest(mended, random_));
      result_.why_stopped =
          control_.stop_wanted() ? control_.why_stopped() : WhyStopped::step_limit;
    }
  }

  void anneal(const Design& mended) {
    for (std::uint64_t moves = first_moves;
         mended.block_count() > 1 && result_.moves + moves <= options_.moves && !result_.design &&
         !control_.stop_wanted();
         moves *= 2) {
      for (int run = 0; run < anneals_of_a_length && !control_.stop_wanted(); ++run) {
        Annealed annealed = anneal_blocks(
            mended, 0, {.moves = moves, .hot = 0.3, .cold = 0.15}, random_, control_,
            telling(control_, {.phase = "annealing the list", .steps = result_.moves}));
        result_.moves += annealed.outcome.moves;
        if (annealed.design) {
          keep(*std::move(annealed.design));
        }
      }
    }
  }

  // Keeps the design if it has more blocks of the list than the current one, stopped or not.
  void keep(Design design) {
    const RunGrace to_the_end(control_);
    const std::uint64_t kept = kept_blocks(list_, design);
    if (result_.design && kept <= result_.kept) {
      return;
    }
    design.set_labels(list_.labels());
    result_.design = surely_verified(std::move(design), "a repaired " + name(list_.parameters()));
    result_.kept = kept;
    result_.why_stopped = WhyStopped::found;
  }

  const Design& list_;
  const RepairOptions& options_;
  RunControl& control_;
  Random random_;
  RepairResult result_;
};

}  // namespace

RepairResult repair(const Design& list, const RepairOptions& options, RunControl& control) {
  require_possible(list);
  return Repair(list, options, control).run();
}

}  // namespace changeover
