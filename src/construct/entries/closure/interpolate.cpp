// Interpolate: each step that changes M elements made in M/m steps of m, through the blocks
// between.
//
// What was covered still is, so an M-change design with b blocks gives an m-change design, m a
// divisor of M, with (M/m)(b−1) + 1 blocks if it is linear and (M/m)b if it is circular.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover::interpolate_entry {
namespace {

// Between two blocks the smallest of what leaves goes first, for the smallest of what enters.
class InterpolatedSource final : public BlockByBlock<InterpolatedSource> {
 public:
  InterpolatedSource(const Parameters& parameters, std::unique_ptr<BlockSource> source)
      : parameters_(parameters),
        source_(std::move(source)),
        steps_(source_->parameters().change / parameters.change) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    const auto b = source_->block_count();
    return b ? std::optional(interpolated_count(source_->parameters(), parameters_.change, *b))
             : std::nullopt;
  }

  bool make(std::span<Element> block) {
    if (current_.empty()) {
      if (!read_input(current_)) {
        return false;
      }
      first_ = current_;
    } else if (done_ < leaving_.size()) {
      for (std::uint64_t i = 0; i < parameters_.change; ++i, ++done_) {
        *std::ranges::find(current_, leaving_[done_]) = entering_[done_];
      }
    } else if (!begin_step()) {
      return false;
    } else {
      return make(block);
    }
    // The last step of a circular design ends where it began: that block was there already.
    if (closing_ && done_ == leaving_.size()) {
      return false;
    }
    std::ranges::copy(current_, block.begin());
    return true;
  }

  bool rewind() override {
    if (!source_->rewind()) {
      return false;
    }
    current_.clear();
    leaving_.clear();
    entering_.clear();
    done_ = 0;
    closing_ = false;
    return true;
  }

 private:
  bool read_input(Block& block) {
    block.resize(static_cast<std::size_t>(parameters_.k));
    if (source_->next(block)) {
      return true;
    }
    block.clear();
    return false;
  }

  bool begin_step() {
    if (closing_) {
      return false;
    }
    Block next;
    if (!read_input(next)) {
      if (parameters_.kind != Kind::circular) {
        return false;
      }
      closing_ = true;
      next = first_;
    }
    Block from = current_;
    std::ranges::sort(from);
    std::ranges::sort(next);
    leaving_.clear();
    entering_.clear();
    std::set_difference(from.begin(), from.end(), next.begin(), next.end(),
                        std::back_inserter(leaving_));
    std::set_difference(next.begin(), next.end(), from.begin(), from.end(),
                        std::back_inserter(entering_));
    if (leaving_.size() != steps_ * parameters_.change || leaving_.size() != entering_.size()) {
      throw BadInput(
          fmt::format("interpolate: a step of the input changes {} instead of {}; use "
                      "another input",
                      count_of(leaving_.size(), "element"), steps_ * parameters_.change));
    }
    done_ = 0;
    return true;
  }

  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
  std::uint64_t steps_;
  Block current_;
  Block first_;
  Block leaving_;
  Block entering_;
  std::size_t done_ = 0;  // of those
  bool closing_ = false;  // from the last block to the first
};

constexpr Description description{
    .name = "interpolate",
    .summary = "each step of a design with a larger change number made in several smaller steps",
    .preconditions = "an M-change design on (v,k) of the same kind, as input; m divides M, m < M",
    .guarantee = "(M/m)(b-1)+1 blocks if it is linear, (M/m)b if it is circular",
};

class Interpolate final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Recipe& input = only_input(recipe);
    return std::make_unique<InterpolatedSource>(recipe.parameters, registry.build(input));
  }

  std::string explain(const Recipe& recipe) const override {
    const Parameters& p = only_input(recipe).parameters;
    return fmt::format("Make each step of the {} in {} steps.", changeover::name(p),
                       p.change / recipe.parameters.change);
  }

 private:
  const Recipe& only_input(const Recipe& recipe) const {
    const std::uint64_t m = recipe.parameters.change;
    const std::uint64_t larger =
        recipe.inputs.empty() ? 0 : recipe.inputs.front().parameters.change;
    Parameters p = recipe.parameters;
    p.change = larger;
    if (m == 0 || larger <= m || larger % m != 0 || p.v <= p.k) {
      throw BadInput(
          fmt::format("interpolate to {} takes one design whose change number is a multiple; "
                      "correct the recipe",
                      changeover::name(recipe.parameters)));
    }
    require_input(recipe, p, {});
    return recipe.inputs.front();
  }
};

}  // namespace

const Construction& construction() { return only<Interpolate>(); }

}  // namespace changeover::interpolate_entry

namespace changeover {

std::uint64_t interpolated_count(const Parameters& p, std::uint64_t m, std::uint64_t b) {
  return p.kind == Kind::circular ? checked_multiply(p.change / m, b)
                                  : checked_add(checked_multiply(p.change / m, b - 1), 1);
}

Recipe interpolate_recipe(const Recipe& input, std::uint64_t m) {
  Parameters p = input.parameters;
  if (m == 0 || p.change % m != 0) {
    throw BadInput(fmt::format("{} does not divide the change number {}", m, p.change));
  }
  if (p.change == m) {
    return input;
  }
  p.change = m;
  return {"interpolate", p, {}, {input}, {}};
}

}  // namespace changeover
