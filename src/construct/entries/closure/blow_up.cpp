// Every element replaced by s copies: an m-change covering design on (v,k) becomes an sm-change
// covering design on (sv,sk) with as many blocks, of the same kind.
//
// A closure rule on recipes: it makes no offers, lest offers recurse without end. Constructions
// that know which input to take compose it.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

// The copies of the elements of `from`, in order; `to` has `copies` places for each.
void blow_up(std::span<const Element> from, std::uint64_t copies, std::span<Element> to) {
  std::size_t filled = 0;
  for (const Element x : from) {
    for (std::uint64_t i = 0; i < copies; ++i) {
      to[filled++] = static_cast<Element>(copies * x + i);
    }
  }
}

class BlowUpSource final : public BlockSource {
 public:
  BlowUpSource(const Parameters& parameters, std::unique_ptr<BlockSource> source,
               std::uint64_t copies)
      : parameters_(parameters),
        source_(std::move(source)),
        copies_(copies),
        small_(static_cast<std::size_t>(source_->parameters().k)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }
  bool next(std::span<Element> block) override {
    if (!source_->next(small_)) {
      return false;
    }
    blow_up(small_, copies_, block);
    return true;
  }
  bool rewind() override { return source_->rewind(); }

 private:
  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
  std::uint64_t copies_;
  Block small_;
};

class BlowUp final : public Construction {
 public:
  std::string_view name() const override { return "blow-up"; }
  std::string_view summary() const override {
    return "every element of a design replaced by s copies";
  }
  std::string_view preconditions() const override {
    return "an (m/s)-change design on (v/s,k/s) of the same kind, as input; s >= 2";
  }
  std::string_view guarantee() const override { return "as many blocks as the input"; }
  Citation citation() const override { return {}; }

  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::uint64_t s = copies(recipe);
    return std::make_unique<BlowUpSource>(recipe.parameters, registry.build(recipe.inputs.front()),
                                          s);
  }

  // Copies of a partition into unchanged subsets are a partition into unchanged subsets.
  std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t s = copies(recipe);
    const Recipe& input = recipe.inputs.front();
    auto set = registry.construction_of(input).expansion_set(input, registry);
    if (set) {
      for (UnchangedSubset& subset : *set) {
        Block larger(subset.elements.size() * static_cast<std::size_t>(s));
        blow_up(subset.elements, s, larger);
        subset.elements = std::move(larger);
      }
    }
    return set;
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t s = copies(recipe);
    return fmt::format("Replace every element x in the blocks of the {0} by {1}x{2}{1}x+{3}.",
                       changeover::name(recipe.inputs.front().parameters), s,
                       s == 2 ? " and " : ",…,", s - 1);
  }

  // Copy i of the element named a is a.i, i = 1, …, s.
  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t s = copies(recipe);
    const Recipe& input = recipe.inputs.front();
    std::vector<std::string> labels;
    for (const std::string& label : registry.construction_of(input).labels(input, registry)) {
      for (std::uint64_t i = 1; i <= s; ++i) {
        labels.push_back(fmt::format("{}.{}", label, i));
      }
    }
    return labels;
  }

 private:
  // The number s of copies, when the recipe fits; the input may be any of the right parameters.
  std::uint64_t copies(const Recipe& recipe) const {
    const Parameters& p = recipe.parameters;
    try {
      check(p);
    } catch (const ImpossibleParameters& fault) {
      throw BadInput(fmt::format("blow-up: {}", fault.what()));
    }
    const std::uint64_t small_v =
        recipe.inputs.size() == 1 ? recipe.inputs.front().parameters.v : 0;
    const std::uint64_t s = small_v == 0 || p.v % small_v != 0 ? 0 : p.v / small_v;
    Parameters smaller = p;
    if (s >= 2) {
      smaller.v /= s;
      smaller.k /= s;
      smaller.change /= s;
    }
    if (s < 2 || recipe.inputs.front().parameters != smaller || p.k % s != 0 || p.change % s != 0) {
      throw BadInput(
          fmt::format("blow-up to {} takes one input on v/s elements with k/s and m/s for some s "
                      ">= 2, else alike",
                      changeover::name(p)));
    }
    require_recipe(recipe, *this, blow_up_recipe(recipe.inputs.front(), s));
    return s;
  }
};

}  // namespace

Recipe blow_up_recipe(const Recipe& input, std::uint64_t s) {
  if (s == 0) {
    throw BadInput("an element cannot be replaced by no copies at all");
  }
  if (s == 1) {
    return input;
  }
  Parameters p = input.parameters;
  p.v = checked_multiply(s, p.v);
  p.k = checked_multiply(s, p.k);
  p.change = checked_multiply(s, p.change);
  return {"blow-up", p, {{"s", static_cast<std::int64_t>(s)}}, {input}, {}};
}

const Construction& blow_up_construction() {
  static const BlowUp construction;
  return construction;
}

}  // namespace changeover
