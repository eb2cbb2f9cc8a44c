#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "changeover/search/random_list.hpp"
#include "changeover/search/repair.hpp"
#include "changeover/verify/verdict.hpp"
#include "search/local_search_states.hpp"
#include "search/repair_cover.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t first_budget = std::uint64_t{1} << 18;

Block block_of(const Design& design, std::size_t i) {
  const auto elements = design.block(i);
  return Block(elements.begin(), elements.end());
}

// The beginning with random blocks after it, `blocks` altogether; nullopt if it cannot be closed
// so.
std::optional<Design> continued(const Design& beginning, std::size_t blocks, Random& random) {
  const Parameters& p = beginning.parameters();
  Design list = beginning;
  list.recipe.reset();
  Block here = block_of(beginning, beginning.block_count() - 1);
  if (p.kind == Kind::linear) {
    while (list.block_count() < blocks) {
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

// What the beginning leaves uncovered must be newly covered by what follows.
std::uint64_t fewest_blocks(const Design& beginning, const Verdict& verdict) {
  const Parameters& p = beginning.parameters();
  return beginning.block_count() + ceil_div(verdict.uncovered, newly_covered_at_most(p));
}

void require_steps(const Design& beginning) {
  Parameters linear = beginning.parameters();
  linear.kind = Kind::linear;
  Design list = beginning;
  list.set_kind(Kind::linear);
  const Verdict verdict = verify(list);
  if (verdict.bad_steps > 0) {
    const BadStep& step = verdict.bad_step_examples.front();
    throw BadInput(fmt::format(
        "the step from block {} to block {} changes {} elements, not {}; repair the list first",
        step.from, step.to, step.changes, linear.change));
  }
}

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
  require_steps(beginning);
  const Verdict verdict = verify(beginning);
  ExtendResult result{beginning};
  if (verdict.valid()) {
    result.lower_bound = beginning.block_count();
    result.why_stopped = WhyStopped::found;
    return result;
  }
  Random random(control.seed());
  result.design = cover_the_rest(beginning, random);
  result.lower_bound =
      std::max<std::uint64_t>(fewest_blocks(beginning, verdict), beginning.block_count() + 1);
  const std::uint64_t enough = std::max(result.lower_bound, options.blocks.value_or(0));
  std::uint64_t step = std::max<std::uint64_t>(
      1,
      (result.design.block_count() - std::min<std::uint64_t>(result.design.block_count(), enough)) /
          2);
  std::uint64_t budget = first_budget;
  while (result.design.block_count() > enough && !control.stop_wanted()) {
    const std::uint64_t best = result.design.block_count();
    const std::uint64_t aim = std::max(enough, best - std::min(best, step));
    std::uint64_t moves = budget;
    if (options.moves) {
      moves = std::min(moves, *options.moves - std::min(*options.moves, result.moves));
    }
    if (moves == 0) {
      control.stop(WhyStopped::step_limit);
      break;
    }
    Annealed annealed;
    if (const auto start = continued(beginning, static_cast<std::size_t>(aim), random)) {
      annealed = anneal_blocks(
          *start, beginning.block_count(), {.moves = moves}, random, control,
          [&](std::uint64_t done, std::uint64_t missing) {
            if (control.progress_due()) {
              control.tell({.phase = fmt::format("annealing {} blocks after the given ones",
                                                 aim - beginning.block_count()),
                            .steps = result.moves + done,
                            .best = best,
                            .lower_bound = result.lower_bound,
                            .missing = missing});
            }
            return true;
          });
    }
    // A list that cannot be closed costs something too, or an attempt at it would never end.
    result.moves += std::max<std::uint64_t>(1, annealed.outcome.moves);
    if (annealed.design) {
      result.design = *std::move(annealed.design);
      step *= 2;
    } else if (step > 1) {
      step /= 2;
    } else {
      budget *= 2;
    }
  }
  if (result.design.block_count() <= enough) {
    control.stop(WhyStopped::found);
  }
  if (!verify(result.design).valid()) {
    throw InternalError(fmt::format("an extended {} is not valid", name(p)));
  }
  result.design.set_labels(beginning.labels());
  result.why_stopped = control.why_stopped();
  return result;
}

}  // namespace changeover
