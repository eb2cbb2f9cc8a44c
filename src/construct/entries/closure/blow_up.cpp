// Every element replaced by s copies: an m-change covering design on (v,k) becomes an sm-change
// covering design on (sv,sk) with as many blocks, of the same kind.
//
// A closure rule on recipes: it makes no offers, which would recurse without end. Constructions
// that know which input to take compose it.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"

namespace changeover::blow_up_entry {
namespace {

constexpr Description description{
    .name = "blow-up",
    .summary = "every element of a design replaced by s copies",
    .preconditions = "an (m/s)-change design on (v/s,k/s) of the same kind, as input; s >= 2",
    .guarantee = "as many blocks as the input",
};

class BlowUp final : public Described<Rule, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::uint64_t s = number(recipe);
    return blown_up(recipe.parameters, registry.build(recipe.inputs.front()), s);
  }

  // Copies of a partition into unchanged subsets are a partition into unchanged subsets.
  std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t s = number(recipe);
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
    const std::uint64_t s = number(recipe);
    return fmt::format("Replace every element x in the blocks of the {0} by {1}x{2}{1}x+{3}.",
                       changeover::name(recipe.inputs.front().parameters), s,
                       s == 2 ? " and " : ",…,", s - 1);
  }

  // Copy i of the element named a is a.i, i = 1, …, s.
  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t s = number(recipe);
    const Recipe& input = recipe.inputs.front();
    std::vector<std::string> labels;
    for (const std::string& label : registry.construction_of(input).labels(input, registry)) {
      for (std::uint64_t i = 1; i <= s; ++i) {
        labels.push_back(fmt::format("{}.{}", label, i));
      }
    }
    return labels;
  }

 protected:
  std::uint64_t number_between(const Parameters& small, const Parameters& large) const override {
    const std::uint64_t s = small.v == 0 ? 0 : large.v / small.v;
    const auto is_times = [s](std::uint64_t x, std::uint64_t y) {
      return x % s == 0 && x / s == y;
    };
    return s >= 2 && is_times(large.v, small.v) && is_times(large.k, small.k) &&
                   is_times(large.change, small.change)
               ? s
               : 0;
  }
  Recipe with(const Recipe& input, std::uint64_t s) const override {
    return blow_up_recipe(input, s);
  }
  std::string_view needs() const override {
    return "on v/s elements with k/s and m/s for some s >= 2, otherwise with the same parameters";
  }
};

}  // namespace

const Construction& construction() { return only<BlowUp>(); }

}  // namespace changeover::blow_up_entry

namespace changeover {

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

}  // namespace changeover
