#include "changeover/search/random_list.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "changeover/core/transitions.hpp"

namespace changeover {
namespace {

// Brings `count` random members of `list` to its front.
void choose(Block& list, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto left = static_cast<std::uint32_t>(list.size() - i);
    std::swap(list[i], list[i + random.below(left)]);
  }
}

// The elements below v that are in neither block.
Block outside(const Block& one, const Block& other, std::uint64_t v) {
  std::vector<bool> taken(static_cast<std::size_t>(v), false);
  for (const Element x : one) {
    taken[x] = true;
  }
  for (const Element x : other) {
    taken[x] = true;
  }
  Block rest;
  for (Element x = 0; x < v; ++x) {
    if (!taken[x]) {
      rest.push_back(x);
    }
  }
  return rest;
}

// One step at distance d: of the m that go, `wrong` are not in the goal; of the m that come,
// `strange` are in neither block. The distance becomes d − wrong + strange.
struct Step {
  std::uint64_t wrong = 0;
  std::uint64_t strange = 0;
};

std::vector<Step> possible_steps(std::uint64_t d, const Parameters& p) {
  std::vector<Step> steps;
  const std::uint64_t m = p.change;
  for (std::uint64_t wrong = 0; wrong <= std::min(m, d); ++wrong) {
    for (std::uint64_t strange = 0; strange <= std::min(m, p.v - p.k - d); ++strange) {
      if (m - wrong <= p.k - d && m - strange <= d) {
        steps.push_back({wrong, strange});
      }
    }
  }
  return steps;
}

}  // namespace

Block random_block(const Parameters& p, Random& random) {
  Block all = outside({}, {}, p.v);
  choose(all, static_cast<std::size_t>(p.k), random);
  all.resize(static_cast<std::size_t>(p.k));
  return all;
}

Block random_step(const Block& from, const Parameters& p, Random& random) {
  const auto m = static_cast<std::size_t>(p.change);
  Block coming = outside(from, {}, p.v);
  choose(coming, m, random);
  Block to = from;
  choose(to, m, random);
  std::copy_n(coming.begin(), m, to.begin());
  return to;
}

std::optional<std::vector<Block>> random_walk(const Block& from, const Block& to, std::size_t steps,
                                              const Parameters& p, Random& random) {
  const auto farthest = static_cast<std::size_t>(std::min(p.k, p.v - p.k));
  std::vector<std::vector<Step>> choices(farthest + 1);
  for (std::size_t d = 0; d <= farthest; ++d) {
    choices[d] = possible_steps(d, p);
  }
  // arrives[r][d]: the goal can be reached from distance d in exactly r steps.
  std::vector<std::vector<bool>> arrives(steps + 1, std::vector<bool>(farthest + 1, false));
  arrives[0][0] = true;
  for (std::size_t r = 1; r <= steps; ++r) {
    for (std::size_t d = 0; d <= farthest; ++d) {
      for (const Step step : choices[d]) {
        const auto next = static_cast<std::size_t>(d - step.wrong + step.strange);
        if (next <= farthest && arrives[r - 1][next]) {
          arrives[r][d] = true;
        }
      }
    }
  }
  Block here = from;
  if (!arrives[steps][difference(here, to).size()]) {
    return std::nullopt;
  }
  std::vector<Block> between;
  for (std::size_t r = steps; r > 1; --r) {
    Block wrong = difference(here, to);
    Block right = intersection(here, to);
    Block wanted = difference(to, here);
    Block strange = outside(here, to, p.v);
    std::vector<Step> open;
    for (const Step step : choices[wrong.size()]) {
      const auto next = static_cast<std::size_t>(wrong.size() - step.wrong + step.strange);
      if (next <= farthest && arrives[r - 1][next]) {
        open.push_back(step);
      }
    }
    const Step step = open[random.below(static_cast<std::uint32_t>(open.size()))];
    const auto wrong_go = static_cast<std::ptrdiff_t>(step.wrong);
    const auto right_go = static_cast<std::ptrdiff_t>(p.change - step.wrong);
    const auto strange_come = static_cast<std::ptrdiff_t>(step.strange);
    const auto wanted_come = static_cast<std::ptrdiff_t>(p.change - step.strange);
    choose(wrong, static_cast<std::size_t>(wrong_go), random);
    choose(right, static_cast<std::size_t>(right_go), random);
    choose(strange, static_cast<std::size_t>(strange_come), random);
    choose(wanted, static_cast<std::size_t>(wanted_come), random);
    Block next(wrong.begin() + wrong_go, wrong.end());
    next.insert(next.end(), right.begin() + right_go, right.end());
    next.insert(next.end(), strange.begin(), strange.begin() + strange_come);
    next.insert(next.end(), wanted.begin(), wanted.begin() + wanted_come);
    here = std::move(next);
    between.push_back(here);
  }
  return between;
}

std::optional<Design> random_list(const Parameters& p, std::size_t blocks, Random& random) {
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
