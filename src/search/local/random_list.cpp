#include "search/local/random_list.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/tools/path.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// Moves `count` random members of `list` to its front.
void choose(Block& list, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto left = static_cast<std::uint32_t>(list.size() - i);
    std::swap(list[i], list[i + random.below(left)]);
  }
}

// The elements below v that are in neither block, increasing, without listing them all.
class Outside {
 public:
  Outside(const Block& one, const Block& other, std::uint64_t v) : taken_(one) {
    taken_.insert(taken_.end(), other.begin(), other.end());
    std::ranges::sort(taken_);
    taken_.erase(std::unique(taken_.begin(), taken_.end()), taken_.end());
    count_ = static_cast<std::size_t>(v) - taken_.size();
  }

  [[nodiscard]] std::size_t count() const { return count_; }

  [[nodiscard]] Block list() const {
    Block all;
    all.reserve(count_);
    Element x = 0;
    for (const Element next : taken_) {
      for (; x < next; ++x) {
        all.push_back(x);
      }
      ++x;
    }
    while (all.size() < count_) {
      all.push_back(x++);
    }
    return all;
  }

  // If `below` elements of the blocks are smaller, the element at `place` is place + below.
  [[nodiscard]] Element at(std::size_t place) const {
    std::size_t below = 0;
    for (std::size_t above = taken_.size(); below < above;) {
      const std::size_t middle = below + (above - below) / 2;
      if (taken_[middle] - middle <= place) {
        below = middle + 1;
      } else {
        above = middle;
      }
    }
    return static_cast<Element>(place + below);
  }

 private:
  Block taken_;
  std::size_t count_ = 0;
};

// `count` random elements outside both blocks, the same ones as choose() would select from their
// list. A few swaps are remembered; for many the list is made.
Block choose_outside(const Block& one, const Block& other, std::uint64_t v, std::size_t count,
                     Random& random) {
  constexpr std::size_t few = 16;
  const Outside all(one, other, v);
  if (count > few) {
    Block list = all.list();
    choose(list, count, random);
    list.resize(count);
    return list;
  }
  Block chosen;
  std::vector<std::pair<std::size_t, Element>>
      moved;  // the element at a place now; the last entry counts
  const auto at = [&](std::size_t place) {
    const auto last = std::find_if(moved.rbegin(), moved.rend(),
                                   [place](const auto& each) { return each.first == place; });
    return last == moved.rend() ? all.at(place) : last->second;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = i + random.below(static_cast<std::uint32_t>(all.count() - i));
    chosen.push_back(at(from));
    moved.emplace_back(from, at(i));
  }
  return chosen;
}

// The distances from which the goal can be reached in exactly r steps, for all r up to a limit.
class Arrivals {
 public:
  Arrivals(std::size_t steps, const Parameters& p)
      : distances_(static_cast<std::size_t>(std::min(p.k, p.v - p.k)) + 1) {
    const std::uint64_t bits = checked_multiply(checked_add(steps, 1), distances_);
    require_memory(bits / 8, "the table of ways between two blocks");
    arrives_.reserve(static_cast<std::size_t>(bits));
    arrives_.assign(distances_, false);
    arrives_[0] = true;
    std::vector<std::uint32_t> before;
    for (std::size_t r = 1; r <= steps; ++r) {
      stop_if_asked();
      counts(r - 1, before);
      for (std::size_t d = 0; d < distances_; ++d) {
        const StepMoves step = moves_at(d, p.k, p.change, p.v);
        const bool reached =
            step.possible() && number(before, d + step.strange.low - step.wrong.high,
                                      d + step.strange.high - step.wrong.low) > 0;
        arrives_.push_back(reached);
      }
    }
  }

  [[nodiscard]] bool operator()(std::size_t steps, std::size_t distance) const {
    return arrives_[steps * distances_ + distance];
  }

  // counts[d]: the number of distances below d from which r steps can reach the goal.
  void counts(std::size_t r, std::vector<std::uint32_t>& counts) const {
    counts.assign(1, 0);
    for (std::size_t d = 0; d < distances_; ++d) {
      counts.push_back(counts.back() + ((*this)(r, d) ? 1 : 0));
    }
  }

  // The number of such distances from `least` to `most`.
  [[nodiscard]] static std::uint32_t number(const std::vector<std::uint32_t>& counts,
                                            std::uint64_t least, std::uint64_t most) {
    const std::uint64_t end = std::min<std::uint64_t>(most + 1, counts.size() - 1);
    return least >= end
               ? 0
               : counts[static_cast<std::size_t>(end)] - counts[static_cast<std::size_t>(least)];
  }

 private:
  std::size_t distances_;
  std::vector<bool> arrives_;
};

// Draws a step at distance d after which r steps can reach the goal, each with the same
// probability: the numbers of wrong elements that leave and of strange ones that come. There must
// be one.
std::pair<std::uint64_t, std::uint64_t> random_choice(const Arrivals& arrives, std::size_t r,
                                                      std::uint64_t d, const Parameters& p,
                                                      std::vector<std::uint32_t>& counts,
                                                      Random& random) {
  const StepMoves step = moves_at(d, p.k, p.change, p.v);
  arrives.counts(r, counts);
  std::uint64_t open = 0;
  for (std::uint64_t wrong = step.wrong.low; wrong <= step.wrong.high; ++wrong) {
    open += Arrivals::number(counts, d - wrong + step.strange.low, d - wrong + step.strange.high);
  }
  std::uint64_t chosen = random.below(static_cast<std::uint32_t>(open));
  for (std::uint64_t wrong = step.wrong.low; wrong <= step.wrong.high; ++wrong) {
    for (std::uint64_t strange = step.strange.low; strange <= step.strange.high; ++strange) {
      const std::uint64_t next = d - wrong + strange;
      if (arrives(r, static_cast<std::size_t>(next)) && chosen-- == 0) {
        return {wrong, strange};
      }
    }
  }
  throw InternalError("a random way has lost its goal");
}

}  // namespace

Block random_block(const Parameters& p, Random& random) {
  return choose_outside({}, {}, p.v, static_cast<std::size_t>(p.k), random);
}

Block random_step(const Block& from, const Parameters& p, Random& random) {
  const auto m = static_cast<std::size_t>(p.change);
  const Block coming = choose_outside(from, {}, p.v, m, random);
  Block to = from;
  choose(to, m, random);
  std::copy_n(coming.begin(), m, to.begin());
  return to;
}

std::optional<std::vector<Block>> random_walk(const Block& from, const Block& to, std::size_t steps,
                                              const Parameters& p, Random& random) {
  const Arrivals arrives(steps, p);
  Block here = from;
  if (!arrives(steps, difference(here, to).size())) {
    return std::nullopt;
  }
  std::vector<Block> between;
  std::vector<std::uint32_t> counts;
  for (std::size_t r = steps; r > 1; --r) {
    stop_if_asked();
    Block wrong = difference(here, to);
    Block right = intersection(here, to);
    Block wanted = difference(to, here);
    const auto step = random_choice(arrives, r - 1, wrong.size(), p, counts, random);
    const auto wrong_go = static_cast<std::ptrdiff_t>(step.first);
    const auto right_go = static_cast<std::ptrdiff_t>(p.change - step.first);
    const auto strange_come = static_cast<std::size_t>(step.second);
    const auto wanted_come = static_cast<std::ptrdiff_t>(p.change - step.second);
    choose(wrong, static_cast<std::size_t>(wrong_go), random);
    choose(right, static_cast<std::size_t>(right_go), random);
    const Block strange = choose_outside(here, to, p.v, strange_come, random);
    choose(wanted, static_cast<std::size_t>(wanted_come), random);
    Block next(wrong.begin() + wrong_go, wrong.end());
    next.insert(next.end(), right.begin() + right_go, right.end());
    next.insert(next.end(), strange.begin(), strange.end());
    next.insert(next.end(), wanted.begin(), wanted.begin() + wanted_come);
    here = std::move(next);
    between.push_back(here);
  }
  return between;
}

std::optional<Design> random_list(const Parameters& p, std::size_t blocks, Random& random) {
  constexpr std::size_t between_questions = 64;
  require_memory(checked_multiply(checked_multiply(blocks, p.k), sizeof(Element)),
                 "a random list of blocks");
  Design design(p);
  design.reserve(blocks);
  Block here = random_block(p, random);
  design.append(here);
  if (blocks == 1) {
    return design;
  }
  if (p.v < p.k + p.change) {
    return std::nullopt;
  }
  if (p.kind == Kind::linear) {
    for (std::size_t i = 1; i < blocks; ++i) {
      if (i % between_questions == 0) {
        stop_if_asked();
      }
      here = random_step(here, p, random);
      design.append(here);
    }
    return design;
  }
  const auto between = random_walk(here, here, blocks, p, random);
  if (!between) {
    return std::nullopt;
  }
  for (const Block& block : *between) {
    design.append(block);
  }
  return design;
}

}  // namespace changeover
