// The tight circular SCCD(2k−1, k, 2k−1): k consecutive residues modulo 2k−1, developed.
//
// The only change from one block to the next is j out, j+k in. The differences that k adds to the
// k−1 residues before it are 1, …, k−1, each once up to sign, so every pair is covered exactly
// once.
#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::mcsorley_circular_entry {
namespace {

BaseBlocks base(const Parameters& p) {
  Block block(static_cast<std::size_t>(p.k));
  std::iota(block.begin(), block.end(), Element{0});
  return {p, {std::move(block)}};
}

constexpr Description description{
    .name = "mcsorley-circular",
    .summary = "k consecutive residues modulo 2k-1, developed",
    .preconditions = "circular, m = 1, v = 2k-1, k >= 2",
    .guarantee = "a tight circular SCCD(2k-1,k,2k-1)",
    .cited = "McSorley1999",
};

class McSorleyCircular final : public Described<Family, description> {
 public:
  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    return base(required(recipe));
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || p.v != 2 * p.k - 1) {
      return std::nullopt;
    }
    return Promise{p.v, true, true};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<DevelopedSource>(base(p));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format("Develop the base block {{{}}} over Z_{}.", first_elements(p.k), p.v);
  }
};

}  // namespace

const Construction& construction() { return only<McSorleyCircular>(); }

}  // namespace changeover::mcsorley_circular_entry
