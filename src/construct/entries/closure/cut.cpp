// A circular design read as a linear one that begins after block `at`.
//
// All pairs stay covered and no step is added, so it has the same b. Its first block covers C(k,2)
// pairs where the circular one covers at most p = C(m,2) + m(k−m): C(k−m,2) pairs are covered once
// more, so a tight design stays tight only for k − m ≤ 1 (or if it is one block). Unchanged subsets
// stay where they were, and the one between block `at` and the next may still serve, at the end
// after the last block.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover::cut_entry {
namespace {

class CutSource final : public BlockSource {
 public:
  CutSource(const Parameters& parameters, std::unique_ptr<BlockSource> source, std::uint64_t at)
      : parameters_(parameters), source_(std::move(source)), at_(at) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }

  std::span<const Element> read(std::span<Element> room) override {
    const auto k = static_cast<std::size_t>(parameters_.k);
    if (!started_) {
      started_ = true;
      for (std::uint64_t i = 0; i < at_; ++i) {
        if (!source_->next(room.first(k))) {
          throw BadInput(fmt::format("cut after block {}: there are only {}", at_, i));
        }
      }
    }
    if (!wrapped_) {
      if (const auto blocks = source_->read(room); !blocks.empty()) {
        return blocks;
      }
      if (at_ > 0 && !source_->rewind()) {
        throw BadInput("cut needs a list of blocks that can be read twice");
      }
      wrapped_ = true;
    }
    const std::uint64_t wanted = std::min<std::uint64_t>(room.size() / k, at_ - again_);
    if (wanted == 0) {
      return {};
    }
    const auto blocks = source_->read(room.first(static_cast<std::size_t>(wanted) * k));
    again_ += blocks.size() / k;
    return blocks;
  }

  bool rewind() override {
    if (!source_->rewind()) {
      return false;
    }
    started_ = wrapped_ = false;
    again_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
  std::uint64_t at_;
  bool started_ = false;     // the first `at` blocks were skipped
  bool wrapped_ = false;     // the source started again
  std::uint64_t again_ = 0;  // blocks read since
};

constexpr Description description{
    .name = "cut",
    .summary = "a circular design read as a linear one, from any of its blocks on",
    .preconditions = "linear, and a circular design with the same m, v, k",
    .guarantee = "as many blocks as the circular design",
};

class Cut final : public Described<Entry, description> {
 public:
  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    if (p.kind != Kind::linear || !asks_for_pairs(p, p.change)) {
      return std::nullopt;
    }
    std::optional<Offer> input = best_input(p.as(Kind::circular), Need::blocks, *this, registry);
    if (!input) {
      return std::nullopt;
    }
    const std::uint64_t b = input->b;
    const bool tight = input->tight && (p.k - p.change <= 1 || b == 1);
    const bool economical = b == counting_bound(p);
    return Offer{cut_recipe(std::move(input->recipe)), b, tight, economical, input->expansion_set};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::uint64_t at = place(recipe);
    std::unique_ptr<BlockSource> source = registry.build(recipe.inputs.front());
    if (const auto b = source->block_count(); b && at >= *b) {
      throw BadInput(fmt::format("cut at = {}: it must be below the number of blocks, {}", at, *b));
    }
    return std::make_unique<CutSource>(recipe.parameters, std::move(source), at);
  }

  std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t at = place(recipe);
    const Recipe& input = recipe.inputs.front();
    std::optional<ExpansionSet> set =
        registry.construction_of(input).expansion_set(input, registry);
    const std::optional<std::uint64_t> b = build(recipe, registry)->block_count();
    if (!set || !b) {
      return std::nullopt;
    }
    for (UnchangedSubset& subset : *set) {
      subset.position = static_cast<std::size_t>((subset.position + *b - at - 1) % *b + 1);
    }
    std::ranges::sort(*set, [](const auto& x, const auto& y) { return x.position < y.position; });
    return set;
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t at = place(recipe);
    const std::string input = changeover::name(recipe.inputs.front().parameters);
    return at == 0
               ? fmt::format("Read the {} as a linear list.", input)
               : fmt::format("Read the {} as a linear list that begins after block {}.", input, at);
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    (void)place(recipe);
    return labels_of_input(recipe, registry);
  }

 private:
  // The argument `at`, when the rest of the recipe fits too.
  std::uint64_t place(const Recipe& recipe) const {
    if (recipe.parameters.kind != Kind::linear) {
      require_recipe(recipe, *this, std::nullopt);
    }
    const auto at = recipe.arguments.find("at");
    const std::int64_t value = at != recipe.arguments.end() && at->second > 0 ? at->second : 0;
    require_input(recipe, recipe.parameters.as(Kind::circular), {{"at", value}});
    return static_cast<std::uint64_t>(value);
  }
};

}  // namespace

const Construction& construction() { return only<Cut>(); }

}  // namespace changeover::cut_entry

namespace changeover {

Recipe cut_recipe(Recipe input, std::uint64_t at) {
  if (input.parameters.kind != Kind::circular) {
    throw BadInput("cut: only a circular design can be cut open");
  }
  const Parameters linear = input.parameters.as(Kind::linear);
  return {"cut", linear, {{"at", static_cast<std::int64_t>(at)}}, {std::move(input)}, {}};
}

}  // namespace changeover
