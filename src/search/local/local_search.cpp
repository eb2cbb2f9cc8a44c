#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <new>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/tools/path.hpp"
#include "core/words.hpp"
#include "run/grace.hpp"
#include "run/threads.hpp"
#include "search/local/anneal.hpp"
#include "search/local/checkpoint.hpp"
#include "search/local/fewer_blocks.hpp"
#include "search/local/imposed.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/random_list.hpp"
#include "search/repair/repair_cover.hpp"

namespace changeover {
namespace {

using Method = SearchArm::Method;

constexpr std::uint64_t largest_v = 4096;
// Temperatures of Method::cold. Where blocks are small, m is close to k and nearly every pair is
// covered once, designs are found some ten times as fast as at those of AnnealSchedule; others are
// not (bench/README.md).
constexpr double cold_from = 0.21;
constexpr double cold_to = 0.13;
constexpr double imposed_from = 0.28;
constexpr double imposed_to = 0.17;
// Used in turn. The coldest one changes only a few places of a design from a construction.
constexpr std::array<double, 4> reheated_to = {0.28, 0.14, 0.22, 0.33};
constexpr std::size_t blocks_between_cuts = 8;
constexpr int most_fruitless = 64;  // attempts in a row that could not start

/// The result of an attempt.
struct Attempted {
  std::optional<Design> design;  // with the requested parameters
  std::uint64_t missed = 0;
  std::uint64_t moves = 0;
  std::uint64_t counted = 0;  // of the moves, already in the sum
  bool started = false;
  bool stopped = false;
  std::string how;
};

class Improver {
 public:
  Improver(const Parameters& p, const ImproveOptions& options, RunControl& control)
      : parameters_(p),
        options_(options),
        control_(control),
        bound_(lower_bound(p).blocks),
        goal_(std::max(bound_, options.target.value_or(0))),
        circle_(p.v <= largest_v ? known_circle(p) : std::nullopt),
        arms_(p, goal_,
              {.imposed = options.imposed && p.v > p.k && p.v <= largest_v,
               .opened = circle_.has_value()},
              control.settings().share, bytes_of_an_attempt(control)),
        seed_(control.seed()) {}

  // Everything but the search. @throws Stopped; results so far are kept.
  void begin() {
    if (!options_.checkpoint.empty()) {
      file_.emplace(options_.checkpoint, parameters_);
      if (auto checkpoint = file_->read()) {
        go_on(*std::move(checkpoint));
      }
    }
    take_known();
    if (options_.start) {
      auto start = verified(*options_.start);
      if (options_.start->parameters() != parameters_ || !start) {
        throw BadInput(fmt::format("the design to start from is not a {}; repair it first",
                                   name(parameters_)));
      }
      start_from(*std::move(start), "the design to start from");
    }
    if (!best_) {
      Random random(seed_);
      Design list(parameters_);
      list.append(random_block(parameters_, random));
      take_found(cover_the_rest(list, random), "blocks added one by one");
    }
    stop_if_done();
  }

  ImproveResult run() {
    if (!best_) {
      return result();
    }
    if (parameters_.v > largest_v) {
      unsearched_ = fmt::format("local search supports v up to {}", largest_v);
      control_.stop(WhyStopped::exhausted);
    } else {
      run_together(control_, control_.threads(), [this](unsigned) { work(); });
    }
    save();
    return result();
  }

 private:
  // Both counts of a checkpoint are for one search that was interrupted between runs.
  void go_on(Checkpoint checkpoint) {
    seed_ = checkpoint.seed;
    attempts_ = checkpoint.attempts;
    moves_ = moves_before_ = checkpoint.moves;
    arms_.restore(checkpoint.arms);
    if (checkpoint.best) {
      start_from(*std::move(checkpoint.best), checkpoint.how);
    }
  }

  // What is known beforehand counts as that even if the search is stopped before all of it is.
  void start_from(VerifiedDesign design, const std::string& how) {
    take(std::move(design), how);
    started_from_ = blocks_of_best();
  }

  // Without memory for the best recipe, the design of the checkpoint is enough.
  void take_known() {
    try {
      // The offers of constructions are there at once; finding the best recipe may take too long.
      if (const auto offer = Registry::standard().best(parameters_)) {
        start_from(built_design(*offer), "best recipe");
      }
      if (auto known = best_known_design(parameters_)) {
        start_from(*std::move(known), "best recipe");
      }
    } catch (const MissingResource&) {
      if (!best_) {
        throw;
      }
    }
  }

  static std::optional<std::uint64_t> bytes_of_an_attempt(const RunControl& control) {
    const auto bytes = control.settings().memory_bytes;
    return bytes ? std::optional(*bytes / control.threads()) : std::nullopt;
  }

  [[nodiscard]] std::optional<std::uint64_t> blocks_of_best() const {
    return best_ ? std::optional<std::uint64_t>(best_->block_count()) : std::nullopt;
  }

  // Keeps the design of an attempt if it is better, whether the search was stopped or not.
  bool take_found(Design design, const std::string& how) {
    if (best_ && design.block_count() >= best_->block_count()) {
      return false;
    }
    const RunGrace to_the_end(control_);
    return take(
        surely_verified(std::move(design), fmt::format("a {} by {}", name(parameters_), how)), how);
  }

  // Keeps a design if it is better. Called under the lock, or before there are threads.
  bool take(VerifiedDesign design, const std::string& how) {
    if (design.parameters() != parameters_) {
      throw InternalError(fmt::format("a {} is not what was searched: {}",
                                      name(design.parameters()), name(parameters_)));
    }
    // The best recipe comes back from a checkpoint without its recipe.
    const bool has_it_again =
        best_ && how == how_ && design.design().recipe && !best_->design().recipe;
    if (best_ && design.block_count() + (has_it_again ? 0 : 1) > best_->block_count()) {
      return false;
    }
    best_ = std::move(design);
    best_blocks_ = best_->block_count();
    how_ = how;
    return true;
  }

  void stop_if_done() {
    if (best_blocks_ <= goal_) {
      control_.stop(WhyStopped::found);
    }
  }

  void work() {
    while (!control_.stop_wanted()) {
      const std::optional<Attempt> attempt = next();
      if (!attempt) {
        return;
      }
      try {
        report(*attempt, make(*attempt));
      } catch (const MissingResource&) {
        leave_out(*attempt);
      } catch (const std::bad_alloc&) {
        leave_out(*attempt);
      }
    }
  }

  void leave_out(const Attempt& attempt) {
    const std::scoped_lock lock(mutex_);
    arms_.leave_out(attempt.arm);
    if (options_.moves) {
      reserved_ -= attempt.moves;
    }
  }

  std::optional<Attempt> next() {
    const std::scoped_lock lock(mutex_);
    std::optional<Attempt> attempt = arms_.next(best_blocks_);
    if (!attempt || fruitless_ > most_fruitless) {
      if (const std::uint64_t bytes = arms_.bytes_left_out(best_blocks_);
          moves_ == moves_before_ && bytes > 0) {
        constexpr double giga = 1e9;
        unsearched_ = fmt::format("local search would need about {:.1f} GB of memory a thread",
                                  static_cast<double>(bytes) / giga);
      }
      control_.stop(WhyStopped::exhausted);
      return std::nullopt;
    }
    attempt->number = attempts_++;
    if (options_.moves) {
      const std::uint64_t left = *options_.moves - std::min(*options_.moves, reserved_);
      if (left == 0) {
        control_.stop(WhyStopped::step_limit);
        return std::nullopt;
      }
      attempt->moves = std::min(attempt->moves, left);
      reserved_ += attempt->moves;
    }
    fit_to_time(*attempt);
    return attempt;
  }

  // A shorter schedule that reaches its lowest temperature is better than a long one that the time
  // limit interrupts.
  void fit_to_time(Attempt& attempt) const {
    const auto left = control_.time_left();
    const double elapsed = control_.elapsed().count() * control_.threads();
    if (left && elapsed > 0.5) {
      const double rate = static_cast<double>(moves_ - moves_before_) / elapsed;
      const double fitting = std::max(1e5, rate * left->count());
      if (fitting < static_cast<double>(attempt.moves)) {
        attempt.moves = static_cast<std::uint64_t>(fitting);
      }
    }
  }

  Attempted make(const Attempt& attempt) {
    SearchArm arm;
    std::optional<Design> best;
    {
      const std::scoped_lock lock(mutex_);
      arm = arms_.arms()[attempt.arm];
      if (best_) {
        best = best_->design();
      }
    }
    const WorkShare share = control_.settings().share;
    Random random(seed_, 1 + attempt.number * share.of + share.index % share.of);
    if (arm.method == Method::imposed) {
      return impose(attempt, arm, random);
    }
    if (arm.method == Method::opened) {
      return open(attempt, random);
    }
    Attempted attempted;
    const auto start = arm.from_random_list() || !best
                           ? random_list(parameters_, static_cast<std::size_t>(attempt.aim), random)
                           : one_block_less(*best, static_cast<std::size_t>(attempt.aim), random);
    if (!start) {
      attempted.missed = 1;
      return attempted;
    }
    attempted.started = true;
    AnnealSchedule schedule{.moves = attempt.moves};
    if (arm.method == Method::cold) {
      schedule.hot = cold_from;
      schedule.cold = cold_to;
    } else if (arm.method == Method::reheated) {
      schedule.hot = reheated_to[attempt.number % reheated_to.size()];
      schedule.cold = std::min(schedule.cold, schedule.hot * 0.6);
    }
    const Annealed annealed = anneal_blocks(
        *start, 0, schedule, random, control_,
        watch(attempt, attempted, fmt::format("annealing {} blocks", attempt.aim), 1));
    attempted.moves = annealed.outcome.moves;
    attempted.missed = annealed.outcome.least;
    attempted.stopped = annealed.outcome.stopped;
    if (annealed.design) {
      attempted.design = shorter(*annealed.design);
      attempted.how = arm.from_random_list() ? "blocks without symmetry"
                                             : "the best design annealed with a block less";
    }
    return attempted;
  }

  Attempted open(const Attempt& attempt, Random& random) {
    Attempted attempted;
    OpenedOutcome found = anneal_opened(
        *circle_, parameters_, attempt, random, control_, [&](std::uint64_t moves_before) {
          return watch(attempt, attempted,
                       fmt::format("annealing {} blocks of a circular design", attempt.aim), 1,
                       moves_before);
        });
    attempted.started = true;
    attempted.moves = found.moves;
    attempted.missed = found.least;
    attempted.stopped = found.stopped;
    if (found.design) {
      attempted.design = shorter(*found.design);
      attempted.how = "the best circular design, cut and annealed with fewer blocks";
    }
    return attempted;
  }

  Attempted impose(const Attempt& attempt, const SearchArm& arm, Random& random) {
    Attempted attempted;
    ImposedOutcome found = search_imposed(
        arms_.parameters_of(arm), *arm.automorphism(parameters_.v),
        static_cast<std::size_t>(attempt.aim),
        {.moves = attempt.moves, .hot = imposed_from, .cold = imposed_to}, random, control_,
        watch(
            attempt, attempted,
            fmt::format("annealing {} under an automorphism of order {} on {} elements",
                        count_of(attempt.aim, "base block"), arm.order, parameters_.v + arm.extra),
            arm.order));
    attempted.started = found.started;
    attempted.moves = found.anneal.moves;
    attempted.missed = found.started ? found.anneal.least : 1;
    attempted.stopped = found.anneal.stopped;
    if (!found.design) {
      return attempted;
    }
    std::optional<Design> design = without_extra(*found.design, arm.extra);
    if (design) {
      attempted.how = fmt::format(
          "{} under an automorphism of order {} with {}{}{}", count_of(attempt.aim, "base block"),
          arm.order, count_of(arm.fixed, "fixed element"),
          arm.extra == 0 ? "" : fmt::format(", {} truncated", count_of(arm.extra, "element")),
          parameters_.kind == Kind::linear ? ", cut" : "");
      attempted.design = shorter(*design);
      if (parameters_.kind == Kind::linear && attempted.design->block_count() >= best_blocks_ &&
          design->block_count() >= best_blocks_ && best_blocks_ > goal_) {
        shorten(attempt, *design, attempted, random);
      }
    }
    return attempted;
  }

  // A circular design whose cut is no shorter than the best design may still be a good start.
  void shorten(const Attempt& attempt, const Design& circular, Attempted& attempted,
               Random& random) {
    const std::uint64_t blocks = best_blocks_ - 1;
    const std::uint64_t before = attempted.moves;
    const std::uint64_t left = attempt.moves - std::min(attempt.moves, before);
    const Annealed annealed = anneal_blocks(
        best_part(circular, static_cast<std::size_t>(blocks)), 0,
        {.moves = left, .hot = reheated_to[attempt.number % reheated_to.size()]}, random, control_,
        watch(attempt, attempted, fmt::format("annealing {} blocks cut from a circle", blocks), 1,
              before));
    attempted.moves += annealed.outcome.moves;
    attempted.stopped = annealed.outcome.stopped;
    if (annealed.design) {
      attempted.design = shorter(*annealed.design);
      attempted.how += ", annealed with a block less";
    }
  }

  // Nullopt if no element can be removed, or no time is left.
  std::optional<Design> without_extra(const Design& design, std::uint64_t extra) const {
    const RunGrace grace(control_, usual_grace);
    try {
      return truncated(design, extra);
    } catch (const Stopped&) {
      return std::nullopt;
    }
  }

  // Makes the design linear if requested, and removes needless blocks; returns it unchanged if time
  // or memory is short.
  Design shorter(Design design) const {
    const RunGrace grace(control_, usual_grace);
    try {
      return parameters_.kind == Kind::linear ? shortest_cut(design)
                                              : without_needless_blocks(design);
    } catch (const Stopped&) {
    } catch (const MissingResource&) {
    } catch (const std::bad_alloc&) {
    }
    design.set_kind(parameters_.kind);
    return design;
  }

  // A linear design loses an end block or an inner block. In a circular one without a removable
  // block, a piece is replaced by a random walk that is one block shorter.
  std::optional<Design> one_block_less(const Design& best, std::size_t blocks,
                                       Random& random) const {
    if (best.block_count() == blocks + 1 && random.below(2) == 0) {
      if (auto list = without_a_block(best, random)) {
        return list;
      }
    }
    if (parameters_.kind == Kind::linear) {
      return best_part(best, blocks);
    }
    const std::size_t b = best.block_count();
    const std::size_t begin = random.below(static_cast<std::uint32_t>(b));
    const std::size_t steps = std::min(blocks_between_cuts, b - 1);
    // Another thread may have found a design with fewer blocks than the aim.
    if (blocks > b || steps <= b - blocks) {
      return random_list(parameters_, blocks, random);
    }
    const auto block = [&](std::size_t i) {
      const auto elements = best.block((begin + i) % b);
      return Block(elements.begin(), elements.end());
    };
    const auto way = random_walk(block(0), block(steps), steps - (b - blocks), parameters_, random);
    if (!way) {
      return random_list(parameters_, blocks, random);
    }
    Design list(parameters_);
    for (std::size_t i = steps; i <= b; ++i) {
      list.append(block(i));
    }
    for (const Block& next : *way) {
      list.append(next);
    }
    return list;
  }

  // Counts moves in `counted` and in total, reports progress, and writes the checkpoint. Stops an
  // attempt whose aim another one has reached.
  AnnealWatch watch(const Attempt& attempt, Attempted& attempted, std::string phase,
                    std::uint64_t pairs_a_unit, std::uint64_t moves_before = 0) {
    return [this, &attempted, promise = attempt.promise, phase = std::move(phase), pairs_a_unit,
            moves_before](std::uint64_t moves, std::uint64_t missing) {
      moves_ += moves_before + moves - attempted.counted;
      attempted.counted = moves_before + moves;
      if (control_.progress_due()) {
        control_.tell({.phase = phase,
                       .steps = moves_,
                       .best = best_blocks_,
                       .lower_bound = bound_,
                       .missing = missing * pairs_a_unit});
      }
      save_if_due();
      return best_blocks_ > promise;
    };
  }

  void report(const Attempt& attempt, Attempted attempted) {
    const std::scoped_lock lock(mutex_);
    moves_ += attempted.moves - attempted.counted;
    fruitless_ = attempted.started ? 0 : fruitless_ + 1;
    if (options_.moves) {
      reserved_ -= attempt.moves - std::min(attempt.moves, attempted.moves);
    }
    bool improved = false;
    if (attempted.design) {
      improved = take_found(*std::move(attempted.design), attempted.how);
      stop_if_done();
    }
    if (!attempted.stopped) {
      arms_.report(attempt, attempted.missed, improved);
    }
    if (improved) {
      control_.tell({.phase = "found a better design",
                     .steps = moves_,
                     .best = best_blocks_,
                     .lower_bound = bound_,
                     .missing = 0},
                    true);
    }
  }

  void save_if_due() {
    if (!file_) {
      return;
    }
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() && RunControl::Clock::now() >= next_save_) {
      save();
    }
  }

  // A checkpoint that cannot be written does not end the search: writing is tried again, and a
  // failure is reported at the end.
  void save() {
    if (!file_) {
      return;
    }
    const RunGrace to_the_end(control_);
    try {
      keep_what_others_found();
      file_->write({.parameters = parameters_,
                    .seed = seed_,
                    .attempts = attempts_,
                    .moves = moves_,
                    .arms = arms_.arms(),
                    .how = how_,
                    .best = best_});
      checkpoint_fault_.clear();
    } catch (const Error& fault) {
      checkpoint_fault_ = fault.what();
    } catch (const std::bad_alloc&) {
      checkpoint_fault_ = options_.checkpoint + ": not enough memory to write the checkpoint";
    }
    next_save_ = RunControl::Clock::now() + std::chrono::duration_cast<RunControl::Clock::duration>(
                                                options_.checkpoint_interval);
  }

  // Another process may have written a better checkpoint; its design is taken over. A file that is
  // no checkpoint is not replaced.
  void keep_what_others_found() {
    if (!file_->was_replaced()) {
      return;
    }
    if (auto other = file_->read(); other && other->best) {
      take(*std::move(other->best), other->how);
    }
  }

  ImproveResult result() {
    ImproveResult result;
    result.lower_bound = bound_;
    result.started_from = started_from_;
    result.how = how_;
    result.moves = moves_;
    result.attempts = attempts_;
    result.elapsed = control_.elapsed();
    result.moves_per_second =
        static_cast<double>(moves_ - moves_before_) / std::max(1e-9, result.elapsed.count());
    result.why_stopped = control_.why_stopped();
    result.unsearched = unsearched_;
    result.checkpoint_fault = checkpoint_fault_;
    if (!best_) {
      return result;
    }
    result.design = std::move(best_);
    return result;
  }

  const Parameters parameters_;
  const ImproveOptions& options_;
  RunControl& control_;
  const std::uint64_t bound_;
  const std::uint64_t goal_;
  const std::optional<Design> circle_;
  SearchArms arms_;
  std::uint64_t seed_;
  std::optional<CheckpointFile> file_;
  std::string checkpoint_fault_;
  std::string unsearched_;
  std::uint64_t attempts_ = 0;
  std::uint64_t moves_before_ = 0;  // of earlier runs
  std::uint64_t reserved_ = 0;      // moves of attempts that were started
  int fruitless_ = 0;
  std::atomic<std::uint64_t> moves_ = 0;
  std::atomic<std::uint64_t> best_blocks_ = std::numeric_limits<std::uint32_t>::max();
  std::optional<VerifiedDesign> best_;
  std::optional<std::uint64_t> started_from_;
  std::string how_;
  RunControl::Clock::time_point next_save_ = RunControl::Clock::now();
  std::mutex mutex_;
};

}  // namespace

ImproveResult improve(const Parameters& p, const ImproveOptions& options, RunControl& control) {
  check(p);
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
  std::optional<Improver> improver;
  try {
    const RunGrace grace(control, usual_grace);
    improver.emplace(p, options, control);
    improver->begin();
  } catch (const Stopped&) {
    // The results so far are returned.
  }
  if (improver) {
    return improver->run();
  }
  ImproveResult nothing;
  nothing.elapsed = control.elapsed();
  nothing.why_stopped = control.why_stopped();
  return nothing;
}

}  // namespace changeover
