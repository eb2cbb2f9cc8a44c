#include "changeover/search/base_block_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "run/grace.hpp"
#include "search/symmetric/base_block_anneal.hpp"
#include "search/symmetric/base_block_sat.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_elements = 2000;
constexpr std::uint64_t few_base_blocks = 8;

/// One search: its question, and its results so far.
class Search {
 public:
  Search(const Parameters& p, const BaseBlockOptions& options, RunControl& control)
      : p_(p),
        circular_(p.as(Kind::circular)),
        options_(options),
        control_(control),
        random_(control.seed()) {}

  BaseBlockResult run() {
    const RunScope scope(control_);
    try {
      work();
    } catch (const Stopped&) {
      // The results so far are returned.
    }
    if (!result_.found() && !left_out_.empty() && result_.moves + result_.conflicts == 0) {
      throw MissingResource(left_out_);  // no shape could be tried
    }
    result_.why_stopped = why();
    return std::move(result_);
  }

 private:
  void work() {
    if (const auto best = Registry::standard().best(p_)) {
      result_.registry_b = best->b;
      result_.registry_construction = best->recipe.construction;
      registry_tight_ = best->tight;
    }
    const std::vector<BaseBlockShape> shapes = base_block_shapes(p_, shape_options());
    for (const BaseBlockShape& shape : shapes) {
      if (std::gcd(options_.shift, shape.n) != 1) {
        throw BadInput(
            fmt::format("the shift {} is not a unit of Z_{}; give a number coprime to {}",
                        options_.shift, shape.n, shape.n));
      }
    }
    std::vector<bool> open(shapes.size(), true);
    std::uint64_t moves = options_.moves;
    for (std::uint64_t round = 0; round < options_.rounds; ++round, moves *= 2) {
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (control_.stop_wanted()) {
          return;
        }
        if (!open[i]) {
          continue;
        }
        try {
          if (round == 0) {
            places_.push_back(result_.attempts.size());
          }
          if (attempt(shapes[i], round, moves, places_[i])) {
            return;
          }
          open[i] = result_.attempts[places_[i]].outcome != Outcome::none &&
                    options_.method != BaseBlockMethod::sat;
        } catch (const MissingResource& fault) {
          left_out_ = fault.what();  // a smaller one may follow
          open[i] = false;
        }
      }
      if (std::ranges::find(open, true) == open.end()) {
        return;
      }
    }
  }

  ShapeOptions shape_options() const {
    ShapeOptions options = options_.shapes;
    if (!options.tight && !options.base_blocks && !options.most_blocks) {
      options.most_blocks = result_.registry_b ? *result_.registry_b
                                               : checked_multiply(2, lower_bound(circular_).blocks);
    }
    return options;
  }

  bool attempt(const BaseBlockShape& shape, std::uint64_t round, std::uint64_t moves,
               std::size_t place) {
    if (place == result_.attempts.size()) {
      result_.attempts.emplace_back().shape = shape;
    }
    ShapeAttempt& attempt = result_.attempts[place];
    const ShapeAttempt before = attempt;
    std::vector<Block> blocks;
    const bool tight = options_.shapes.tight;
    const bool small = sat_size(shape) <= options_.sat_size;
    const auto solve = [&] {
      BaseBlocksBySat by_sat =
          base_blocks_by_sat(circular_, shape, tight, options_.conflicts, control_);
      attempt.conflicts += by_sat.conflicts;
      attempt.outcome = by_sat.outcome;
      blocks = std::move(by_sat.blocks);
    };
    const auto anneal = [&](std::uint64_t most) {
      BaseBlockAnnealing outcome =
          base_blocks_by_annealing(circular_, shape, most, random_, control_);
      attempt.moves += outcome.moves;
      attempt.missing = std::min(attempt.missing.value_or(outcome.missing), outcome.missing);
      blocks = std::move(outcome.blocks);
    };
    const auto undecided = [&] {
      return blocks.empty() && attempt.outcome != Outcome::none && !control_.stop_wanted();
    };
    switch (options_.method) {
      case BaseBlockMethod::sat:
        solve();
        break;
      case BaseBlockMethod::anneal:
        anneal(moves);
        break;
      case BaseBlockMethod::automatic: {
        const bool few = shape.base_blocks <= few_base_blocks;
        const std::uint64_t first = round > 0 ? moves : tight && small && few ? 0 : moves / 4;
        if (first > 0) {
          anneal(first);
        }
        if (round == 0 && small && undecided()) {
          solve();
        }
        if (first < moves && undecided()) {
          anneal(moves - first);
        }
        break;
      }
    }
    result_.moves += attempt.moves - before.moves;
    result_.conflicts += attempt.conflicts - before.conflicts;
    if (blocks.empty()) {
      return false;
    }
    attempt.outcome = Outcome::found;
    take(shape, std::move(blocks), attempt);
    return true;
  }

  // Called whether the search was stopped or not.
  void take(const BaseBlockShape& shape, std::vector<Block> blocks, const ShapeAttempt& attempt) {
    const RunGrace to_the_end(control_);
    result_.shape = shape;
    result_.base_blocks = std::move(blocks);
    const std::string provenance =
        attempt.conflicts > 0 && attempt.moves == 0
            ? fmt::format("SAT search for base blocks, seed {}, {}", control_.seed(),
                          count_of(attempt.conflicts, "conflict"))
            : fmt::format("annealing of base blocks, seed {}, {}, {}", control_.seed(),
                          count_of(attempt.moves, "move"), count_of(attempt.conflicts, "conflict"));
    Recipe recipe =
        developed_recipe(circular_, shape, result_.base_blocks, options_.shift, provenance);
    if (p_.kind == Kind::linear) {
      recipe = cut_recipe(std::move(recipe));
    }
    const std::string what = fmt::format("a {} from base blocks", changeover::name(p_));
    result_.design = surely_verified(Registry::standard().build_design(recipe), what);
    result_.recipe = std::move(recipe);
    if (options_.shapes.tight && p_.kind == Kind::circular && !result_.verdict().tight()) {
      throw InternalError(what + " is not tight");
    }
    result_.comparison = compare();
  }

  Comparison compare() const {
    if (!result_.registry_b) {
      return Comparison::only;
    }
    const std::uint64_t b = result_.verdict().b;
    if (b != *result_.registry_b) {
      return b < *result_.registry_b ? Comparison::better : Comparison::worse;
    }
    return result_.verdict().tight() && !registry_tight_ ? Comparison::better : Comparison::equal;
  }

  WhyStopped why() const {
    if (result_.found()) {
      return WhyStopped::found;
    }
    if (control_.why_stopped() != WhyStopped::running) {
      return control_.why_stopped();
    }
    const bool all_none = std::ranges::all_of(
        result_.attempts, [](const ShapeAttempt& a) { return a.outcome == Outcome::none; });
    return all_none ? WhyStopped::exhausted : WhyStopped::step_limit;
  }

  Parameters p_;
  Parameters circular_;
  const BaseBlockOptions& options_;
  RunControl& control_;
  Random random_;
  bool registry_tight_ = false;
  std::string left_out_;             // why a shape was not tried
  std::vector<std::size_t> places_;  // of the shapes, among the attempts
  BaseBlockResult result_;
};

}  // namespace

std::string_view to_string(Comparison comparison) {
  constexpr std::array<std::string_view, 4> names{"only", "better", "equal", "worse"};
  return names.at(static_cast<std::size_t>(comparison));
}

BaseBlockResult search_base_blocks(const Parameters& p, const BaseBlockOptions& options,
                                   RunControl& control) {
  check(p);
  if (p.strength != 2) {
    throw ImpossibleParameters(
        "the search for base blocks supports strength 2 only; give strength 2");
  }
  if (p.v > most_elements) {
    throw ImpossibleParameters(
        fmt::format("the search for base blocks supports v up to {}, not {}; give fewer elements",
                    most_elements, p.v));
  }
  return Search(p, options, control).run();
}

Recipe developed_recipe(const Parameters& p, const BaseBlockShape& shape,
                        std::vector<Block> base_blocks, std::uint64_t shift,
                        std::string provenance) {
  if (shape.n == 0 || std::gcd(shift, shape.n) != 1) {
    throw BadInput(fmt::format("the shift {} is not a unit of Z_{}; give a number coprime to {}",
                               shift, shape.n, shape.n));
  }
  shift %= shape.n;
  if (shift != 1) {
    for (Block& block : base_blocks) {
      for (Element& x : block) {
        x = shape.renamed(x, shift);
      }
      std::ranges::sort(block);
    }
  }
  return {"developed",
          p,
          {{"n", static_cast<std::int64_t>(shape.n)},
           {"f", static_cast<std::int64_t>(shape.fixed)},
           {"shift", static_cast<std::int64_t>(shift)}},
          {},
          std::move(base_blocks),
          std::move(provenance)};
}

std::string describe(const BaseBlockResult& result) {
  if (!result.found()) {
    const auto none = std::ranges::count(result.attempts, Outcome::none, &ShapeAttempt::outcome);
    if (result.attempts.empty()) {
      return result.why_stopped == WhyStopped::exhausted
                 ? "No shape of base blocks passes the counting conditions."
                 : fmt::format("Nothing tried: {}.", to_string(result.why_stopped));
    }
    return fmt::format(
        "No base blocks found ({}): of {} tried the SAT solver says none exist in {}.",
        to_string(result.why_stopped), count_of(result.attempts.size(), "shape"), none);
  }
  const Verdict& verdict = result.verdict();
  std::string text = fmt::format("{} with {} blocks{}: {}.", name(verdict.parameters), verdict.b,
                                 verdict.tight() ? ", tight"
                                 : verdict.economical()
                                     ? ", economical"
                                     : fmt::format(", counting bound {}", verdict.counting_bound),
                                 to_string(result.shape));
  if (result.registry_b) {
    text +=
        fmt::format(" The best construction, {}, has {} blocks: this is {}.",
                    result.registry_construction, *result.registry_b, to_string(result.comparison));
  } else {
    text += " No construction of the registry serves these parameters.";
  }
  return text;
}

}  // namespace changeover
