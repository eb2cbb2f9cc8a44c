// Base blocks developed under a permutation π of cycles of one length n and f fixed points, so that a
// design found by search is stored as c blocks and not as cn.
//
// Element on + r is the residue r of cycle o, 0 ≤ r < n; the last f elements are fixed. π adds `shift`, a
// unit of Z_n, to every residue. The list is B₀, …, B_{c−1}, π(B₀), …, π^{n−1}(B_{c−1}). With v = n and
// shift 1 these are base blocks over Z_v (core/developed.hpp). Nothing is offered and nothing promised.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

/// π and what it works on.
struct Permutation {
  std::uint64_t n = 0;      ///< length of its cycles
  std::uint64_t fixed = 0;  ///< number of fixed points
  std::uint64_t shift = 0;  ///< what it adds to a residue
};

std::uint64_t argument(const Recipe& recipe, const char* name, std::uint64_t least) {
  const auto found = recipe.arguments.find(name);
  if (found == recipe.arguments.end() || found->second < 0 ||
      static_cast<std::uint64_t>(found->second) < least) {
    throw BadInput(fmt::format("developed takes an argument {}, at least {}", name, least));
  }
  return static_cast<std::uint64_t>(found->second);
}

/// Of a recipe whose arguments are right. @throws BadInput otherwise.
Permutation permutation_of(const Recipe& recipe, const Construction& construction) {
  require_recipe(recipe, construction,
                 Recipe{std::string(construction.name()),
                        recipe.parameters,
                        recipe.arguments,
                        {},
                        recipe.blocks,
                        recipe.provenance});
  const Permutation pi{argument(recipe, "n", 2), argument(recipe, "f", 0),
                       argument(recipe, "shift", 1)};
  if (recipe.arguments.size() != 3) {
    throw BadInput("developed takes the arguments n, f and shift, and no others");
  }
  const std::uint64_t v = recipe.parameters.v;
  if (pi.fixed >= v || (v - pi.fixed) % pi.n != 0) {
    throw BadInput(
        fmt::format("v = {} is not f = {} more than a multiple of n = {}", v, pi.fixed, pi.n));
  }
  if (pi.shift >= pi.n || std::gcd(pi.shift, pi.n) != 1) {
    throw BadInput(fmt::format("shift = {} is no unit of Z_{}", pi.shift, pi.n));
  }
  if (recipe.parameters.kind != Kind::circular) {
    throw BadInput("developed makes circular designs; 'cut' reads one as linear");
  }
  return pi;
}

class PermutedSource final : public BlockSource {
 public:
  // The list checks its blocks; it is read once for each power of π.
  PermutedSource(const Recipe& recipe, const Permutation& pi)
      : base_(recipe.parameters, recipe.blocks), pi_(pi) {}

  const Parameters& parameters() const override { return base_.parameters(); }

  std::optional<std::uint64_t> block_count() const override { return *base_.block_count() * pi_.n; }

  bool next(std::span<Element> block) override {
    if (power_ == pi_.n) {
      return false;
    }
    if (!base_.next(block)) {
      (void)base_.rewind();
      add_ += pi_.shift;
      add_ -= add_ >= pi_.n ? pi_.n : 0;
      ++power_;
      return next(block);
    }
    const std::uint64_t moved = parameters().v - pi_.fixed;
    for (Element& x : block) {
      if (x < moved) {
        const std::uint64_t residue = x % pi_.n;
        const std::uint64_t sum = residue + add_;
        x = static_cast<Element>(x - residue + (sum >= pi_.n ? sum - pi_.n : sum));
      }
    }
    return true;
  }

  bool rewind() override {
    power_ = 0;
    add_ = 0;
    return base_.rewind();
  }

 private:
  BlockListSource base_;
  Permutation pi_;
  std::uint64_t power_ = 0;
  std::uint64_t add_ = 0;  // power · shift, modulo n
};

constexpr Description description{
    .name = "developed",
    .summary = "base blocks that the recipe lists, developed under n-cycles and f fixed points",
    .preconditions = "circular, v = sn+f, c base blocks; shift is a unit of Z_n",
    .guarantee = "cn blocks; whether a design: verify",
};

class Developed final : public Entry {
 public:
  Developed() : Entry(description) {}

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    const Permutation pi = permutation_of(recipe, *this);
    return std::make_unique<PermutedSource>(recipe, pi);
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
    const std::uint64_t cycles = (recipe.parameters.v - pi.fixed) / pi.n;
    std::string text = "Develop the base block";
    text += recipe.blocks.size() == 1 ? "" : "s";
    for (std::size_t i = 0; i < recipe.blocks.size(); ++i) {
      text += fmt::format("{}{{{}}}", i == 0 ? " " : ", ", fmt::join(recipe.blocks[i], ","));
    }
    text += cycles == 1 ? fmt::format(" over Z_{}", pi.n)
                        : fmt::format(" over {} copies of Z_{}", cycles, pi.n);
    text += pi.fixed == 0 ? "" : fmt::format(" and {} fixed", pi.fixed);
    text += pi.shift == 1 ? "" : fmt::format(", adding {} each time", pi.shift);
    return text + (recipe.provenance.empty() ? "." : fmt::format("; from: {}.", recipe.provenance));
  }

  // r_o for the residue r of cycle o, plain r if there is one cycle; ∞_i for the fixed points.
  std::vector<std::string> labels(const Recipe& recipe, const Registry&) const override {
    const Permutation pi = permutation_of(recipe, *this);
    const std::uint64_t v = recipe.parameters.v;
    std::vector<std::string> labels;
    if (pi.n == v) {
      return labels;
    }
    const bool one_cycle = pi.n == v - pi.fixed;
    for (std::uint64_t x = 0; x < v; ++x) {
      if (x >= v - pi.fixed) {
        labels.push_back(pi.fixed == 1 ? "∞" : fmt::format("∞_{}", x - (v - pi.fixed)));
      } else {
        labels.push_back(one_cycle ? fmt::format("{}", x)
                                   : fmt::format("{}_{}", x % pi.n, x / pi.n));
      }
    }
    return labels;
  }
};

}  // namespace

const Construction& developed_construction() {
  static const Developed construction;
  return construction;
}

}  // namespace changeover
