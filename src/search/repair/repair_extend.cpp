#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/search/local_search.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "run/grace.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/random_list.hpp"
#include "search/repair/repair_cover.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t first_budget = std::uint64_t{1} << 18;

// The beginning with random blocks after it, `blocks` in total; nullopt if it cannot be closed with
// that many.
std::optional<Design> continued(const Design& beginning, std::size_t blocks, Random& random) {
  const Parameters& p = beginning.parameters();
  Design list = beginning;
  list.recipe.reset();
  Block here = block_of(beginning, beginning.block_count() - 1);
  if (p.kind == Kind::linear) {
    while (list.block_count() < blocks) {
      stop_if_asked();
      here = random_step(here, p, random);
      list.append(here);
    }
    return list;
  }
  const auto way =
      random_walk(here, block_of(beginning, 0), blocks - beginning.block_count() + 1, p, random);
  if (!way) {
    return std::nullopt;
  }
  for (const Block& block : *way) {
    list.append(block);
  }
  return list;
}

// Subsets that the beginning leaves uncovered must be newly covered by later blocks.
std::uint64_t fewest_blocks(const Design& beginning, const Verdict& verdict) {
  const Parameters& p = beginning.parameters();
  return checked_add(beginning.block_count(),
                     ceil_div(verdict.uncovered, newly_covered_at_most(p)));
}

void require_steps(const Design& beginning) {
  Design list = beginning;
  list.set_kind(Kind::linear);
  const Verdict verdict = verify(list);
  if (verdict.bad_steps > 0) {
    const BadStep& step = verdict.bad_step_examples.front();
    throw BadInput(fmt::format(
        "the step from block {} to block {} changes {}, not {}; repair the list first", step.from,
        step.to, count_of(step.changes, "element"), beginning.parameters().change));
  }
}

/// One extension, from the beginning to the design.
class Extension {
 public:
  Extension(const Design& beginning, const ExtendOptions& options, RunControl& control)
      : beginning_(beginning),
        p_(beginning.parameters()),
        options_(options),
        control_(control),
        random_(control.seed()) {}

  ExtendResult run() {
    const RunGrace grace(control_, usual_grace);
    try {
      work();
    } catch (const Stopped&) {
      // The result so far is returned.
    }
    if (result_.why_stopped == WhyStopped::running) {
      result_.why_stopped = control_.why_stopped();
    }
    return std::move(result_);
  }

 private:
  void work() {
    require_steps(beginning_);
    const Verdict verdict = verify(beginning_);
    if (verdict.valid()) {
      keep(beginning_);
      result_.lower_bound = beginning_.block_count();
      result_.why_stopped = WhyStopped::found;
      return;
    }
    result_.lower_bound =
        std::max<std::uint64_t>(fewest_blocks(beginning_, verdict), beginning_.block_count() + 1);
    keep(cover_the_rest(beginning_, random_));
    result_.unsearched = annealing_fault([this] { shorten(); });
    if (!result_.unsearched.empty() && result_.why_stopped == WhyStopped::running) {
      result_.why_stopped = WhyStopped::exhausted;
    }
  }

  void shorten() {
    const std::uint64_t enough = std::max(result_.lower_bound, options_.blocks.value_or(0));
    const std::uint64_t first = result_.design->block_count();
    std::uint64_t step = std::max<std::uint64_t>(1, (first - std::min(first, enough)) / 2);
    std::uint64_t budget = first_budget;
    while (result_.design->block_count() > enough && !control_.stop_wanted()) {
      const std::uint64_t best = result_.design->block_count();
      const std::uint64_t aim = std::max(enough, best - std::min(best, step));
      std::uint64_t moves = budget;
      if (options_.moves) {
        moves = std::min(moves, *options_.moves - std::min(*options_.moves, result_.moves));
      }
      if (moves == 0) {
        control_.stop(WhyStopped::step_limit);
        break;
      }
      if (attempt(aim, moves)) {
        step *= 2;
      } else if (step > 1) {
        step /= 2;
      } else {
        budget *= 2;
      }
    }
    if (result_.design->block_count() <= enough) {
      control_.stop(WhyStopped::found);
    }
  }

  // Returns whether a design of `aim` blocks was found.
  bool attempt(std::uint64_t aim, std::uint64_t moves) {
    control_.require_memory(annealing_bytes(p_, aim), "local search for the " + name(p_));
    Annealed annealed;
    if (const auto start = continued(beginning_, static_cast<std::size_t>(aim), random_)) {
      annealed = anneal_blocks(
          *start, beginning_.block_count(), {.moves = moves}, random_, control_,
          telling(control_, {.phase = fmt::format("annealing {} blocks after the given ones",
                                                  aim - beginning_.block_count()),
                             .steps = result_.moves,
                             .best = result_.design->block_count(),
                             .lower_bound = result_.lower_bound}));
    }
    // A list that cannot be closed counts as a move, too, so that an attempt at it ends.
    result_.moves += std::max<std::uint64_t>(1, annealed.outcome.moves);
    if (annealed.design) {
      keep(*std::move(annealed.design));
    }
    return annealed.design.has_value();
  }

  // Called whether the search was stopped or not.
  void keep(Design design) {
    const RunGrace to_the_end(control_);
    design.set_labels(beginning_.labels());
    result_.design = surely_verified(std::move(design), "an extended " + name(p_));
  }

  const Design& beginning_;
  const Parameters& p_;
  const ExtendOptions& options_;
  RunControl& control_;
  Random random_;
  ExtendResult result_;
};

}  // namespace

ExtendResult extend(const Design& beginning, const ExtendOptions& options, RunControl& control) {
  const Parameters& p = beginning.parameters();
  check(p);
  if (beginning.block_count() == 0) {
    throw BadInput("there is no block to begin with; give at least one, or search from scratch");
  }
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
  return Extension(beginning, options, control).run();
}

}  // namespace changeover
