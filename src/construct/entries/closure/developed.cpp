// Base blocks developed under a permutation π of cycles of one length n and f fixed points, so that
// a design found by search is stored as c blocks and not as cn.
//
// The list is B₀, …, B_{c−1}, π(B₀), …, π^{n−1}(B_{c−1}) where π is the `shift`-th power, a unit of
// Z_n, of the permutation of core/developed.hpp. With v = n and shift 1 these are base blocks over
// Z_v. Nothing is offered and nothing promised.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover::developed_entry {
namespace {

/// What a recipe develops under: the power `shift` of an automorphism.
struct Permutation : Automorphism {
  std::uint64_t shift = 1;
};

std::uint64_t argument(const Recipe& recipe, const char* name, std::uint64_t least) {
  const auto found = recipe.arguments.find(name);
  if (found == recipe.arguments.end() || found->second < 0 ||
      static_cast<std::uint64_t>(found->second) < least) {
    throw BadInput(fmt::format("developed needs the argument {}, at least {}; correct the recipe",
                               name, least));
  }
  return static_cast<std::uint64_t>(found->second);
}

/// The permutation that a recipe with right arguments names. @throws BadInput otherwise.
Permutation permutation_of(const Recipe& recipe, const Construction& construction) {
  require_recipe(recipe, construction,
                 Recipe{std::string(construction.name()),
                        recipe.parameters,
                        recipe.arguments,
                        {},
                        recipe.blocks,
                        recipe.provenance});
  const std::uint64_t n = argument(recipe, "n", 2);
  const std::uint64_t fixed = argument(recipe, "f", 0);
  const std::uint64_t shift = argument(recipe, "shift", 1);
  if (recipe.arguments.size() != 3) {
    throw BadInput(
        "developed takes the arguments n, f and shift, and no others; remove the others");
  }
  const std::uint64_t v = recipe.parameters.v;
  const auto pi = Automorphism::on(v, n, fixed);
  if (!pi || pi->cycles == 0) {
    throw BadInput(fmt::format(
        "v = {} is not f = {} more than a multiple of n = {}; correct v, f or n", v, fixed, n));
  }
  if (shift >= n || std::gcd(shift, n) != 1) {
    throw BadInput(
        fmt::format("shift = {} is not a unit of Z_{}; give a shift that has no factor "
                    "in common with n",
                    shift, n));
  }
  if (recipe.parameters.kind != Kind::circular) {
    throw BadInput("developed makes circular designs; 'cut' reads one as linear");
  }
  return {*pi, shift};
}

constexpr Description description{
    .name = "developed",
    .summary = "base blocks that the recipe lists, developed under n-cycles and f fixed points",
    .preconditions = "circular, v = sn+f, c base blocks; shift is a unit of Z_n",
    .guarantee = "cn blocks; whether a design: verify",
};

// Which number is which element: ": 3j + i is i of copy j, written i_j; 42 is fixed, written ∞".
std::string names_of(const Permutation& pi) {
  std::string text;
  if (pi.cycles > 1) {
    text += fmt::format(": {}j + i is i of copy j, written i_j", pi.n);
  }
  if (pi.fixed > 0) {
    text += text.empty() ? ": " : "; ";
    text += pi.fixed == 1 ? fmt::format("{} is fixed, written ∞", pi.moved())
                          : fmt::format("{} to {} are fixed, written ∞_0 to ∞_{}", pi.moved(),
                                        pi.v() - 1, pi.fixed - 1);
  }
  return text;
}

class Developed final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    const Permutation pi = permutation_of(recipe, *this);
    (void)BlockListSource(recipe.parameters, recipe.blocks);  // checks them
    return std::make_unique<DevelopedSource>(BaseBlocks{recipe.parameters, recipe.blocks}, pi,
                                             pi.shift);
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    const Permutation pi = permutation_of(recipe, *this);
    if (pi.n != recipe.parameters.v || pi.shift != 1) {
      return std::nullopt;
    }
    return BaseBlocks{recipe.parameters, recipe.blocks};
  }

  std::string explain(const Recipe& recipe) const override {
    const Permutation pi = permutation_of(recipe, *this);
    std::string text = "Develop the base block";
    text += recipe.blocks.size() == 1 ? "" : "s";
    for (std::size_t i = 0; i < recipe.blocks.size(); ++i) {
      text += fmt::format("{}{{{}}}", i == 0 ? " " : ", ", fmt::join(recipe.blocks[i], ","));
    }
    text += pi.cycles == 1 ? fmt::format(" over Z_{}", pi.n)
                           : fmt::format(" over {} copies of Z_{}", pi.cycles, pi.n);
    text += pi.fixed == 0   ? ""
            : pi.fixed == 1 ? " and a fixed element"
                            : fmt::format(" and {} fixed elements", pi.fixed);
    text += pi.shift == 1 ? "" : fmt::format(", adding {} each time", pi.shift);
    text += names_of(pi);
    return text + (recipe.provenance.empty() ? "." : fmt::format("; from: {}.", recipe.provenance));
  }

  // r_o for the residue r of cycle o, plain r if there is one cycle; ∞_i for the fixed points.
  std::vector<std::string> labels(const Recipe& recipe, const Registry&) const override {
    const Permutation pi = permutation_of(recipe, *this);
    std::vector<std::string> labels;
    if (pi.n == pi.v()) {
      return labels;
    }
    for (Element x = 0; x < pi.v(); ++x) {
      if (!pi.moves(x)) {
        labels.push_back(pi.fixed == 1 ? "∞" : fmt::format("∞_{}", x - pi.moved()));
      } else {
        labels.push_back(pi.cycles == 1 ? fmt::format("{}", x)
                                        : fmt::format("{}_{}", pi.residue(x), pi.cycle(x)));
      }
    }
    return labels;
  }
};

}  // namespace

const Construction& construction() { return only<Developed>(); }

}  // namespace changeover::developed_entry
