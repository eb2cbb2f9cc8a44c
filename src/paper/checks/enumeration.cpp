#include "paper/checks/enumeration.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

using Mask = std::uint32_t;

// The C(16,2) = 120 pairs, one bit each.
struct Pairs {
  std::array<std::uint64_t, 2> words{};

  [[nodiscard]] std::uint64_t size() const {
    return static_cast<std::uint64_t>(std::popcount(words[0])) +
           static_cast<std::uint64_t>(std::popcount(words[1]));
  }
};

Pairs with_pairs_of(Pairs pairs, Mask block) {
  for (Mask rest = block; rest != 0; rest &= rest - 1) {
    const auto y = static_cast<Element>(std::countr_zero(rest));
    for (Mask below = block & ((Mask{1} << y) - 1); below != 0; below &= below - 1) {
      const std::uint64_t r = PairSet::rank(static_cast<Element>(std::countr_zero(below)), y);
      pairs.words[r >> 6] |= std::uint64_t{1} << (r & 63);
    }
  }
  return pairs;
}

class Search {
 public:
  Search(const Parameters& p, std::uint64_t b, const EnumerationOptions& options)
      : p_(p), b_(b), options_(options), most_(newly_covered_at_most(p)), all_(binomial(p.v, 2)) {
    for (Mask subset = 1; subset < Mask{1} << p.v; ++subset) {
      if (static_cast<std::uint64_t>(std::popcount(subset)) == p.change) {
        exchanged_.push_back(subset);
      }
    }
  }

  Enumeration run() {
    const Mask first = (Mask{1} << p_.k) - 1;
    blocks_.push_back(first);
    stopped_ = false;
    extend(first, first, with_pairs_of({}, first));
    result_.complete = !stopped_;
    return std::move(result_);
  }

 private:
  // `used`: elements that have been in a block.
  void extend(Mask block, Mask used, const Pairs& covered) {
    const std::uint64_t left = b_ - blocks_.size();
    if (all_ - covered.size() > left * most_) {
      return;
    }
    if (left == 0) {
      if (closes()) {
        keep();
      }
      return;
    }
    const Mask outside = ((Mask{1} << p_.v) - 1) & ~block;
    for (const Mask out : exchanged_) {
      if ((out & ~block) != 0) {
        continue;
      }
      for (const Mask in : exchanged_) {
        if ((in & ~outside) != 0 || !enters_in_order(in & ~used, used)) {
          continue;
        }
        if (stopped_ || ++nodes_ > options_.nodes) {
          stopped_ = true;
          return;
        }
        const Mask next = (block & ~out) | in;
        blocks_.push_back(next);
        extend(next, used | in, with_pairs_of(covered, next));
        blocks_.pop_back();
      }
    }
  }

  // Whether the new elements are the smallest that are unused; used ones are 0, …, n−1.
  static bool enters_in_order(Mask fresh, Mask used) {
    const Mask together = fresh | used;
    return (together & (together + 1)) == 0;
  }

  [[nodiscard]] bool closes() const {
    return p_.kind == Kind::linear || b_ == 1 ||
           static_cast<std::uint64_t>(std::popcount(blocks_.front() & ~blocks_.back())) ==
               p_.change;
  }

  void keep() {
    Design& design = result_.designs.emplace_back(p_);
    for (const Mask mask : blocks_) {
      Block block;
      for (Mask rest = mask; rest != 0; rest &= rest - 1) {
        block.push_back(static_cast<Element>(std::countr_zero(rest)));
      }
      design.append(block);
    }
    if (++result_.found >= options_.keep) {
      stopped_ = true;
    }
  }

  Parameters p_;
  std::uint64_t b_;
  EnumerationOptions options_;
  std::uint64_t most_, all_;
  std::vector<Mask> exchanged_;  // all m-subsets of the v elements
  std::vector<Mask> blocks_;
  std::uint64_t nodes_ = 0;
  bool stopped_ = false;
  Enumeration result_;
};

}  // namespace

Enumeration enumerate(const Parameters& parameters, std::uint64_t b,
                      const EnumerationOptions& options) {
  check(parameters);
  if (parameters.v > 16 || b == 0) {
    throw BadInput("enumeration is for v <= 16 and at least one block");
  }
  return Search(parameters, b, options).run();
}

bool same_up_to_relabelling(const Design& a, const Design& b) {
  if (a.parameters() != b.parameters() || a.block_count() != b.block_count() || a.v() > 8) {
    return false;
  }
  std::vector<Element> images(static_cast<std::size_t>(a.v()));
  std::iota(images.begin(), images.end(), Element{0});
  const auto maps = [&] {
    for (std::size_t i = 0; i < a.block_count(); ++i) {
      std::set<Element> image;
      for (const Element x : a.block(i)) {
        image.insert(images[x]);
      }
      if (image != std::set<Element>(b.block(i).begin(), b.block(i).end())) {
        return false;
      }
    }
    return true;
  };
  do {
    if (maps()) {
      return true;
    }
  } while (std::next_permutation(images.begin(), images.end()));
  return false;
}

}  // namespace changeover
