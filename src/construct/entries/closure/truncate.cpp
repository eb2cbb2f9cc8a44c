// Truncate: one element fewer, as many blocks.
//
// Delete x. In each run of consecutive blocks that hold x, put in its place some element that is in
// none of them nor in the block before or after the run: the steps at both ends of the run then
// change as many elements as before, and no other pair is lost. The last element takes the name x.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/entry.hpp"
#include "construct/trusted_entry.hpp"

namespace changeover::truncate_entry {
namespace {

/// Where the elements of a design are, to see which of them can go.
class Truncation {
 public:
  explicit Truncation(const Design& design)
      : design_(design),
        b_(design.block_count()),
        circular_(design.parameters().kind == Kind::circular && b_ > 1),
        where_(static_cast<std::size_t>(design.v())),
        used_(static_cast<std::size_t>(design.v()), 0) {
    for (std::size_t i = 0; i < b_; ++i) {
      for (const Element x : design.block(i)) {
        where_[x].push_back(i);
      }
    }
  }

  /// Whether each run of blocks that hold x leaves an element to put in its place. O(blocks with x
  /// · k).
  bool can_go(Element x) {
    if (where_[x].size() == b_) {
      return false;
    }
    for (const Run& run : runs(x)) {
      // So few blocks cannot hold all elements.
      if ((run.length + 2) * design_.k() >= design_.v() && !substitute(run)) {
        return false;
      }
    }
    return true;
  }

  /// The largest element that can go, if blocks stay smaller than what is left.
  std::optional<Element> last_that_can_go() {
    for (auto x = static_cast<Element>(design_.v()); x-- > 0 && design_.v() > design_.k() + 1;) {
      stop_if_asked();
      if (can_go(x)) {
        return x;
      }
    }
    return std::nullopt;
  }

  /// The design without x, if it can go.
  std::optional<std::vector<Block>> without(Element x) {
    if (where_[x].size() == b_) {
      return std::nullopt;
    }
    std::vector<Block> blocks;
    blocks.reserve(b_);
    for (std::size_t i = 0; i < b_; ++i) {
      blocks.emplace_back(design_.block(i).begin(), design_.block(i).end());
    }
    for (const Run& run : runs(x)) {
      const std::optional<Element> other = substitute(run);
      if (!other) {
        return std::nullopt;
      }
      for (std::size_t i = 0; i < run.length; ++i) {
        Block& block = blocks[(run.first + i) % b_];
        std::ranges::replace(block, x, *other);
      }
    }
    const auto last = static_cast<Element>(design_.v() - 1);
    for (Block& block : blocks) {
      std::ranges::replace(block, last, x);
    }
    return blocks;
  }

 private:
  /// Consecutive blocks, modulo b, that hold an element; those before and after do not.
  struct Run {
    std::size_t first = 0;
    std::size_t length = 0;
  };

  [[nodiscard]] std::vector<Run> runs(Element x) const {
    std::vector<Run> runs;
    for (const std::size_t i : where_[x]) {
      if (!runs.empty() && runs.back().first + runs.back().length == i) {
        ++runs.back().length;
      } else {
        runs.push_back({i, 1});
      }
    }
    const bool wraps = circular_ && runs.size() > 1 && runs.front().first == 0 &&
                       runs.back().first + runs.back().length == b_;
    if (wraps) {
      runs.back().length += runs.front().length;
      runs.erase(runs.begin());
    }
    return runs;
  }

  // The least element that is in no block of the run nor beside it.
  std::optional<Element> substitute(const Run& run) {
    ++stamp_;
    const auto mark = [this](std::size_t i) {
      for (const Element y : design_.block(i)) {
        used_[y] = stamp_;
      }
    };
    for (std::size_t i = 0; i < run.length; ++i) {
      mark((run.first + i) % b_);
    }
    if (circular_ || run.first > 0) {
      mark((run.first + b_ - 1) % b_);
    }
    if (circular_ || run.first + run.length < b_) {
      mark((run.first + run.length) % b_);
    }
    const auto free = std::ranges::find_if(used_, [this](std::size_t s) { return s != stamp_; });
    return free == used_.end() ? std::nullopt
                               : std::optional(static_cast<Element>(free - used_.begin()));
  }

  const Design& design_;
  std::size_t b_;
  bool circular_;
  std::vector<std::vector<std::size_t>> where_;  // by element: the blocks that hold it, in order
  std::vector<std::size_t> used_;                // by element: the stamp of the last mark
  std::size_t stamp_ = 0;
};

// A planner finds out which element can go; see construct/best_known.hpp.
constexpr Description description{
    .name = "truncate",
    .summary = "delete an element; other elements take its place, run by run",
    .preconditions =
        "a design on v+1 elements in which each run of some element leaves another one free",
    .guarantee = "as many blocks as the larger design",
};

class Truncate final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Element x = deleted(recipe);
    const std::unique_ptr<BlockSource> source = registry.build(recipe.inputs.front());
    const Design design = read_within_memory(*source);
    std::optional<std::vector<Block>> blocks = Truncation(design).without(x);
    if (!blocks) {
      throw BadInput(
          fmt::format("truncate: no element can take the place of {} everywhere; "
                      "delete another element",
                      x));
    }
    return std::make_unique<BlockListSource>(recipe.parameters, *std::move(blocks));
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format(
        "Delete element {} of the {}, others taking its place; the last element takes its name.",
        deleted(recipe), changeover::name(recipe.inputs.front().parameters));
  }

 private:
  Element deleted(const Recipe& recipe) const {
    const Parameters larger = recipe.parameters.on(recipe.parameters.v + 1);
    return element_of(recipe, larger,
                      fmt::format("one input on {} elements and the element to delete", larger.v));
  }
};

}  // namespace

const Construction& construction() { return only<Truncate>(); }

}  // namespace changeover::truncate_entry

namespace changeover {

std::optional<Recipe> truncate_recipe(const Recipe& input, const Design& design) {
  if (const auto x = truncate_entry::Truncation(design).last_that_can_go()) {
    return Recipe{
        "truncate", input.parameters.on(input.parameters.v - 1), {{"element", *x}}, {input}, {}};
  }
  return std::nullopt;
}

std::optional<Design> truncated(const Design& design, std::uint64_t elements) {
  Design result = design;
  for (std::uint64_t i = 0; i < elements; ++i) {
    truncate_entry::Truncation truncation(result);
    const auto x = truncation.last_that_can_go();
    if (!x) {
      return std::nullopt;
    }
    result = Design(result.parameters().on(result.v() - 1), *truncation.without(*x));
  }
  return result;
}

}  // namespace changeover
