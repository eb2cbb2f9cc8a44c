#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "core/each.hpp"
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
  // Each thread anneals its own list; its draft and what is locked take half as much again.
  [[nodiscard]] unsigned threads_that_fit() const {
    const auto limit = control_.settings().memory_bytes;
    const std::uint64_t bytes = std::max<std::uint64_t>(1, annealing_bytes(p_, aim_));
    const std::uint64_t each = bytes + std::min(bytes / 2, unlimited - bytes);
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

LockedResult search_locked(const Parameters& p, const Wanted& wanted, const LockedOptions& options,
                           RunControl& control) {
  check(p);
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
  if (p.v > largest_locked_v || p.v == p.k) {
    throw BadInput(fmt::format(
        "first, last, expansion_set and contains support v from k+1 = {} to {}, not {}; "
        "leave them out, or give such a v",
        p.k + 1, largest_locked_v, p.v));
  }
  if (p.strength != 2) {
    throw BadInput(
        "first, last, expansion_set and contains need strength 2; use an exact search "
        "for other strengths");
  }
  if (const std::string defect = wanted_defect(p, wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  return LockedSearch(p, wanted, options, control).run();
}

}  // namespace changeover
