#include "construct/tools/close_up.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

constexpr std::size_t never_again = std::numeric_limits<std::size_t>::max();

struct Stay {
  std::size_t begin = 0;
  std::size_t end = 0;  // the last block
  Element element = 0;
  std::size_t again = never_again;  // when the next stay of the element begins
};

std::vector<Stay> stays_of(const Design& design) {
  require_memory(design.block_count() * sizeof(Stay), "the stays of " + name(design.parameters()));
  std::vector<Stay> stays;
  std::vector<std::size_t> current(static_cast<std::size_t>(design.v()), never_again);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    for (const Element x : design.block(i)) {
      std::size_t& stay = current[x];
      if (stay == never_again || stays[stay].end + 1 < i) {
        if (stay != never_again) {
          stays[stay].again = i;
        }
        stay = stays.size();
        stays.push_back({.begin = i, .end = i, .element = x});
      } else {
        stays[stay].end = i;
      }
    }
  }
  return stays;  // by begin, since blocks were read in order
}

bool can_close_up(const Parameters& p, Element x, std::uint64_t count) {
  return p.kind == Kind::linear && p.change == 1 && count > 0 && p.v > p.k && count < p.v - p.k &&
         x <= p.v - count;
}

// Shows each block of k elements that is left without the elements x, …, x+count−1.
template <typename Visit>
void close_up(const std::vector<Stay>& stays, std::uint64_t k, Element x, std::uint64_t count,
              Visit&& visit) {
  constexpr std::size_t stays_between_looks = 4096;
  Block block;
  std::vector<Stay> present;  // in the order of the block
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (i % stays_between_looks == 0) {
      stop_if_asked();
    }
    const Stay& stay = stays[i];
    if (stay.element >= x && stay.element < x + count) {
      continue;
    }
    const auto same = std::ranges::find(present, stay.element, &Stay::element);
    if (same != present.end()) {
      *same = stay;
      continue;
    }
    const auto number =
        static_cast<Element>(stay.element < x ? stay.element : stay.element - count);
    if (present.size() < k) {
      present.push_back(stay);
      block.push_back(number);
    } else {
      auto out = present.end();
      for (auto it = present.begin(); it != present.end(); ++it) {
        if (it->end < stay.begin &&
            (out == present.end() ||
             std::tie(out->again, out->element) < std::tie(it->again, it->element))) {
          out = it;
        }
      }
      block[static_cast<std::size_t>(out - present.begin())] = number;
      *out = stay;
    }
    if (present.size() == k) {
      visit(block);
    }
  }
}

}  // namespace

std::optional<Design> closed_up(const Design& design, Element x, std::uint64_t count) {
  Parameters p = design.parameters();
  if (!can_close_up(p, x, count)) {
    return std::nullopt;
  }
  p.v -= count;
  Design closed(p);
  close_up(stays_of(design), p.k, x, count, [&](const Block& block) { closed.append(block); });
  return closed;
}

std::optional<BestToCloseUp> best_to_close_up(const Design& design, std::size_t most_tries) {
  if (!can_close_up(design.parameters(), 0, 1)) {
    return std::nullopt;
  }
  const std::vector<Stay> stays = stays_of(design);
  std::vector<std::size_t> counts(static_cast<std::size_t>(design.v()));
  for (const Stay& stay : stays) {
    ++counts[stay.element];
  }
  const std::size_t most = *std::ranges::max_element(counts);
  std::vector<Element> candidates;
  for (Element x = 0; x < counts.size(); ++x) {
    if (counts[x] == most) {
      candidates.push_back(x);
    }
  }
  if (candidates.size() > most_tries) {
    const std::size_t front = (most_tries + 1) / 2;
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(front),
                     candidates.end() - static_cast<std::ptrdiff_t>(most_tries - front));
  }
  std::optional<BestToCloseUp> best;
  for (const Element x : candidates) {
    std::uint64_t blocks = 0;
    close_up(stays, design.k(), x, 1, [&](const Block&) { ++blocks; });
    if (!best || blocks < best->blocks) {
      best = {x, blocks};
    }
  }
  return best;
}

}  // namespace changeover
