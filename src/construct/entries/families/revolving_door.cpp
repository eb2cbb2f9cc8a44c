// Strength t = k for m = 1: all k-subsets, each once, in revolving-door order.
//
// Every t elements are to be in a block of t elements, so each t-subset is a block: C(v,t) at
// least. The order F(n,k) of the k-subsets of {0, …, n−1} lists those whose largest element is k−1,
// then k, and so on to n−1, and for largest element c the (k−1)-subsets of {0, …, c−1} in the order
// F(c,k−1) backwards. It begins with {0, …, k−1} and ends with {0, …, k−2, n−1}, for backwards F
// ends where it begins; consecutive subsets, the last and the first included, differ in one
// element. Proof: docs/theorems.md, Theorem 38.
//
// Pairs are served by pairs-single-change, which has an expansion set.
#include <fmt/format.h>

#include <array>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"

namespace changeover::revolving_door_entry {
namespace {

// C(v,4) of it fits in 64 bits many times over.
constexpr std::uint64_t largest_v = std::uint64_t{1} << 16;

// The elements of a block in ascending order: in the order of lists backwards and forwards again,
// every second one, the largest first, goes up and the others go down.
class RevolvingDoorSource final : public BlockByBlock<RevolvingDoorSource> {
 public:
  explicit RevolvingDoorSource(const Parameters& parameters)
      : parameters_(parameters), k_(static_cast<std::size_t>(parameters.k)) {
    RevolvingDoorSource::rewind();
  }

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return binomial(parameters_.v, parameters_.k);
  }

  bool make(std::span<Element> block) {
    if (ended_) {
      return false;
    }
    for (std::size_t place = 0; place < k_; ++place) {
      block[place] = static_cast<Element>(elements_.at(place));
    }
    ended_ = !next();
    return true;
  }

  bool rewind() override {
    restart_below(k_);
    ended_ = false;
    return true;
  }

 private:
  [[nodiscard]] bool goes_up(std::size_t place) const { return (k_ - place) % 2 == 1; }
  [[nodiscard]] std::uint64_t above(std::size_t place) const {
    return place + 1 == k_ ? parameters_.v : elements_.at(place + 1);
  }

  // The places below `end` as each begins.
  void restart_below(std::size_t end) {
    for (std::size_t place = end; place-- > 0;) {
      elements_.at(place) = goes_up(place) ? place : above(place) - 1;
    }
  }

  bool next() {
    for (std::size_t place = 0; place < k_; ++place) {
      std::uint64_t& element = elements_.at(place);
      if (goes_up(place) ? element + 1 < above(place) : element > place) {
        element += goes_up(place) ? 1 : std::uint64_t(-1);
        restart_below(place);
        return true;
      }
    }
    return false;
  }

  Parameters parameters_;
  std::size_t k_;
  std::array<std::uint64_t, max_strength> elements_{};
  bool ended_ = false;
};

constexpr Description description{
    .name = "revolving-door",
    .summary = "all blocks that there are, each once, consecutive ones differ in one element",
    .preconditions = "m = 1, strength t = k >= 3, v <= 2^16",
    .guarantee = "a minimum design of C(v,k) blocks, linear and circular",
    .place = "docs/theorems.md, Theorem 38",
};

class RevolvingDoor final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    Parameters pairs = p;
    pairs.strength = 2;
    if (p.strength < 3 || p.strength > max_strength || p.k != p.strength ||
        !asks_for_pairs(pairs, 1) || p.v <= p.k || p.v > largest_v) {
      return std::nullopt;
    }
    return Promise{binomial(p.v, p.k), true, true, false};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<RevolvingDoorSource>(p);
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "All {0}-subsets of {1} elements. Those with largest element {2} come first, then {0} and "
        "so on to {3}; for each, the {2}-subsets of the smaller elements in the same kind of "
        "order, backwards. Every {0} elements must be a block, so no design has fewer.",
        p.k, p.v, p.k - 1, p.v - 1);
  }
};

}  // namespace

const Construction& construction() { return only<RevolvingDoor>(); }

}  // namespace changeover::revolving_door_entry
