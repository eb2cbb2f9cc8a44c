#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"
#include "run/grace.hpp"
#include "run/threads.hpp"
#include "search/local/known_as_wanted.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/locked_draft.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t largest_locked_v = 4096;
constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t first_locked_moves = std::uint64_t{1} << 22;
// Few temperatures, where lists that miss one pair are entered most often: (16,5,29) and (20,5,46).
constexpr double hot = 0.28;
constexpr double cold = 0.24;
constexpr std::uint64_t most_doublings = 12;
constexpr int most_drawings = 200;  // of places, before an attempt has failed

bool has_twice(const Block& block) {
  const Block in_order = sorted(block);
  return std::ranges::adjacent_find(in_order) != in_order.end();
}

std::size_t different(const std::vector<Block>& blocks) {
  std::set<Block> all;
  for (const Block& block : blocks) {
    all.insert(sorted(block));
  }
  return all.size();
}

class LockedSearch {
 public:
  LockedSearch(const Parameters& p, const Wanted& wanted, const LockedOptions& options,
               RunControl& control)
      : p_(p),
        wanted_(wanted),
        options_(options),
        control_(control),
        bound_(wanted_bound(p, wanted).blocks),
        goal_(std::max(bound_, options.blocks.value_or(0))),
        aim_(usual_aim()) {}

  LockedResult run() {
    if (options_.from_known) {
      take_known();
    }
    run_together(control_, threads_that_fit(), [this](unsigned) { work(); });
    result_.lower_bound = bound_;
    result_.moves = moves_;
    result_.elapsed = control_.elapsed();
    result_.why_stopped = control_.why_stopped();
    return std::move(result_);
  }

 private:
  // Each thread anneals a list of its own.
  [[nodiscard]] unsigned threads_that_fit() const {
    const auto limit = control_.settings().memory_bytes;
    const std::uint64_t each = std::max<std::uint64_t>(1, annealing_bytes(p_, aim_));
    return static_cast<unsigned>(std::clamp<std::uint64_t>(limit.value_or(unlimited) / each, 1,
                                                           std::max(1U, control_.threads())));
  }

  // Slightly above the bound, and at most the number that is enough.
  [[nodiscard]] std::uint64_t usual_aim() const {
    const std::uint64_t usual = bound_ + std::max<std::uint64_t>(2, bound_ / 8);
    return options_.blocks ? std::min(goal_, usual) : usual;
  }

  void take_known() {
    try {
      const RunScope scope(control_);
      std::optional<AsWanted> known = known_as_wanted(p_, wanted_);
      const std::uint64_t most = options_.blocks.value_or(unlimited);
      if (known && known->design.block_count() <= most) {
        take(std::move(known->design), known->positions);
        result_.known = true;
      }
    } catch (const Stopped&) {
      return;  // The search ends at once.
    }
  }

  void work() {
    while (!control_.stop_wanted()) {
      std::uint64_t aim = 0;
      std::uint64_t moves = 0;
      std::uint64_t number = 0;
      {
        const std::scoped_lock lock(mutex_);
        aim = aim_;
        moves = budget_;
        number = result_.attempts++;
        if (options_.moves) {
          const std::uint64_t left = *options_.moves - std::min(*options_.moves, reserved_);
          if (left == 0) {
            control_.stop(WhyStopped::step_limit);
            return;
          }
          moves = std::min(moves, left);
          reserved_ += moves;
        }
      }
      try_once(aim, moves, number);
    }
  }

  void try_once(std::uint64_t aim, std::uint64_t moves, std::uint64_t number) {
    Random random(control_.seed(), 1 + number);
    control_.require_memory(annealing_bytes(p_, aim), "local search for the " + name(p_));
    std::optional<Draft> draft;
    for (int i = 0; i < most_drawings && !draft && !control_.stop_wanted(); ++i) {
      draft = draw_draft(p_, wanted_, static_cast<std::size_t>(aim), random);
    }
    Annealed annealed;
    if (draft) {
      annealed = anneal_blocks(
          draft->list, 0, {.moves = moves, .hot = hot, .cold = cold}, random, control_,
          telling(control_, {.phase = fmt::format("annealing {} blocks with locked cells", aim),
                             .steps = moves_,
                             .best = best_blocks_ > 0 ? std::optional<std::uint64_t>(best_blocks_)
                                                      : std::nullopt,
                             .lower_bound = bound_}),
          {draft->locked, draft->parts});
      moves_ += annealed.outcome.moves;
    }
    const std::scoped_lock lock(mutex_);
    if (annealed.design) {
      take(*std::move(annealed.design), positions_of(annealed.parts));
    } else if (aim == aim_ && !annealed.outcome.stopped) {
      failed();
    }
  }

  static std::vector<std::size_t> positions_of(const std::vector<LockedPart>& parts) {
    auto positions = each_of<std::size_t>(parts, [](const auto& part) { return part.block + 1; });
    std::ranges::sort(positions);
    return positions;
  }

  void take(Design design, const std::vector<std::size_t>& positions) {
    if (best_blocks_ > 0 && design.block_count() >= best_blocks_) {
      return;
    }
    const RunGrace to_the_end(control_);
    auto parts = parts_as_wanted(design, wanted_, positions);
    if (!parts) {
      throw InternalError("a search with locked cells lost what was wanted");
    }
    best_blocks_ = design.block_count();
    result_.design = surely_verified(std::move(design), fmt::format("a {}", name(p_)));
    result_.parts = *std::move(parts);
    result_.known = false;
    if (best_blocks_ <= goal_) {
      control_.stop(WhyStopped::found);
      return;
    }
    step_ = std::max<std::uint64_t>(1, (best_blocks_ - goal_) / 2);
    aim_ = best_blocks_ - step_;
  }

  // Aims closer to the best design, or else runs longer.
  void failed() {
    if (best_blocks_ > 0 && step_ > 1) {
      step_ /= 2;
      aim_ = best_blocks_ - step_;
      return;
    }
    if (best_blocks_ == 0 && (!options_.blocks || aim_ < goal_)) {
      aim_ += std::max<std::uint64_t>(1, aim_ / 8);
      aim_ = options_.blocks ? std::min(goal_, aim_) : aim_;
      return;
    }
    if (doublings_ < most_doublings && ++fails_ % 4 == 0) {
      budget_ *= 2;
      ++doublings_;
    }
  }

  const Parameters& p_;
  const Wanted& wanted_;
  const LockedOptions& options_;
  RunControl& control_;
  const std::uint64_t bound_, goal_;
  std::uint64_t aim_;
  std::uint64_t step_ = 1;
  std::uint64_t budget_ = first_locked_moves;
  std::uint64_t doublings_ = 0;
  std::uint64_t fails_ = 0;
  std::uint64_t reserved_ = 0;  // moves of attempts that were started
  std::atomic<std::uint64_t> moves_ = 0;
  std::atomic<std::uint64_t> best_blocks_ = 0;  // 0 for none yet
  LockedResult result_;
  std::mutex mutex_;
};

}  // namespace

std::string wanted_defect(const Parameters& p, const Wanted& wanted) {
  if (p.strength != 2) {
    return "cells are locked for strength 2 only";
  }
  if (p.kind == Kind::circular && !(wanted.first.empty() && wanted.last.empty())) {
    return "a circular design has no first and no last block";
  }
  for (const auto& [what, block] : {std::pair("first", &wanted.first), {"last", &wanted.last}}) {
    if (block->size() > p.k) {
      return fmt::format("{} elements are wanted in the {} block of {}", block->size(), what, p.k);
    }
  }
  std::vector<const Block*> all{&wanted.first, &wanted.last};
  for (const Block& block : wanted.contained) {
    all.push_back(&block);
    if (block.size() != p.k) {
      return fmt::format("a block has {} elements, not {}; give whole blocks", p.k, block.size());
    }
  }
  for (const Block* block : all) {
    if (has_twice(*block)) {
      return "an element is named twice";
    }
    if (!block->empty() && *std::ranges::max_element(*block) >= p.v) {
      return fmt::format("element {} is not below {}", *std::ranges::max_element(*block), p.v);
    }
  }
  for (std::size_t i = 1; i < wanted.contained.size(); ++i) {
    if (difference(wanted.contained[i], wanted.contained[i - 1]).size() != p.change) {
      return fmt::format("blocks {} and {} of those wanted do not differ in {}", i, i + 1,
                         count_of(p.change, "element"));
    }
  }
  if (wanted.expansion_set) {
    const std::uint64_t n = p.k - std::min(p.k, p.change);
    const std::size_t rest = in_parts(p, wanted).size();
    if (n == 0 || rest % n != 0) {
      return fmt::format("{} cannot be parted into unchanged subsets of {}",
                         count_of(rest, "element"), n);
    }
  }
  return "";
}

Bound wanted_bound(const Parameters& p, const Wanted& wanted) {
  Bound bound = lower_bound(p);
  const auto at_least = [&bound](std::uint64_t blocks, std::string reason) {
    if (blocks > bound.blocks) {
      bound = {.blocks = blocks, .name = "required", .reason = std::move(reason)};
    }
  };
  // A circular list may come round to the blocks that it began with.
  const std::uint64_t given =
      p.kind == Kind::linear ? wanted.contained.size() : different(wanted.contained);
  at_least(given,
           fmt::format("{} given", given == 1 ? "1 block is" : count_of(given, "block") + " are"));
  if (wanted.expansion_set && p.k > p.change) {
    const std::uint64_t parts = in_parts(p, wanted).size() / (p.k - p.change);
    const std::uint64_t needed = p.kind == Kind::circular ? parts : parts + 1;
    at_least(needed, fmt::format("{} of {} in a partition take as many steps, so {}",
                                 count_of(parts, "unchanged subset"), p.k - p.change,
                                 count_of(needed, "block")));
  }
  return bound;
}

std::optional<std::vector<UnchangedSubset>> parts_as_wanted(
    const Design& design, const Wanted& wanted, const std::vector<std::size_t>& positions) {
  const std::size_t b = design.block_count();
  if (b == 0 || !holds_all(design.block(0), wanted.first) ||
      !holds_all(design.block(b - 1), wanted.last)) {
    return std::nullopt;
  }
  const auto contains_from = [&](std::size_t start) {
    for (std::size_t i = 0; i < wanted.contained.size(); ++i) {
      if (!holds_all(design.block((start + i) % b), wanted.contained[i])) {
        return false;
      }
    }
    return true;
  };
  const bool circular = design.parameters().kind == Kind::circular;
  bool contained = wanted.contained.empty();
  for (std::size_t start = 0; start < b && !contained; ++start) {
    contained = (circular || start + wanted.contained.size() <= b) && contains_from(start);
  }
  if (!contained) {
    return std::nullopt;
  }
  std::vector<UnchangedSubset> parts;
  if (!wanted.expansion_set) {
    return parts;
  }
  Block held;
  for (const std::size_t position : positions) {
    if (position < 1 || position > (circular ? b : b - 1)) {
      return std::nullopt;
    }
    parts.push_back(
        {position, sorted(intersection(design.block(position - 1), design.block(position % b)))});
    held.insert(held.end(), parts.back().elements.begin(), parts.back().elements.end());
  }
  std::ranges::sort(held);
  return held == in_parts(design.parameters(), wanted) ? std::optional(std::move(parts))
                                                       : std::nullopt;
}

LockedResult search_locked(const Parameters& p, const Wanted& wanted, const LockedOptions& options,
                           RunControl& control) {
  check(p);
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
  if (p.v > largest_locked_v || p.v == p.k) {
    throw BadInput(
        fmt::format("the search with locked cells supports v from k+1 = {} to {}, not {}", p.k + 1,
                    largest_locked_v, p.v));
  }
  if (const std::string defect = wanted_defect(p, wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  return LockedSearch(p, wanted, options, control).run();
}

}  // namespace changeover
