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

// Hamiltonian paths and cycles of the graph whose vertices are pairs, disjoint ones adjacent.
class PairOrder {
 public:
  PairOrder(std::uint64_t v, Kind kind, std::uint64_t nodes) : kind_(kind), nodes_(nodes) {
    for (Element y = 1; y < v; ++y) {
      for (Element x = 0; x < y; ++x) {
        pairs_.push_back({x, y});
      }
    }
    free_.assign(pairs_.size(), true);
  }

  // {0,1} first: a relabelling takes the first pair of any order to it.
  bool run() {
    path_.push_back(0);
    free_[0] = false;
    return extend();
  }

  [[nodiscard]] const std::vector<std::size_t>& path() const { return path_; }
  [[nodiscard]] const std::vector<Block>& pairs() const { return pairs_; }
  [[nodiscard]] bool complete() const { return steps_ <= nodes_; }

 private:
  [[nodiscard]] bool adjacent(std::size_t i, std::size_t j) const {
    return pairs_[i][0] != pairs_[j][0] && pairs_[i][0] != pairs_[j][1] &&
           pairs_[i][1] != pairs_[j][0] && pairs_[i][1] != pairs_[j][1];
  }

  [[nodiscard]] std::vector<std::size_t> ways_on(std::size_t from) const {
    std::vector<std::size_t> ways;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (free_[i] && adjacent(from, i)) {
        ways.push_back(i);
      }
    }
    return ways;
  }

  bool extend() {
    if (path_.size() == pairs_.size()) {
      return kind_ == Kind::linear || adjacent(path_.front(), path_.back());
    }
    std::vector<std::pair<std::size_t, std::size_t>> next;
    for (const std::size_t i : ways_on(path_.back())) {
      next.emplace_back(ways_on(i).size(), i);
    }
    std::sort(next.begin(), next.end());
    for (const auto& [ways, i] : next) {
      if (++steps_ > nodes_) {
        return false;
      }
      path_.push_back(i);
      free_[i] = false;
      if (extend()) {
        return true;
      }
      free_[i] = true;
      path_.pop_back();
    }
    return false;
  }

  Kind kind_;
  std::uint64_t nodes_, steps_ = 0;
  std::vector<Block> pairs_;
  std::vector<bool> free_;
  std::vector<std::size_t> path_;
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

std::optional<Design> order_of_pairs(std::uint64_t v, Kind kind, std::uint64_t nodes,
                                     bool* complete) {
  PairOrder order(v, kind, nodes);
  const bool found = order.run();
  if (complete != nullptr) {
    *complete = order.complete();
  }
  if (!found) {
    return std::nullopt;
  }
  Design design({.v = v, .k = 2, .change = 2, .kind = kind});
  for (const std::size_t i : order.path()) {
    design.append(order.pairs()[i]);
  }
  return design;
}

}  // namespace changeover
