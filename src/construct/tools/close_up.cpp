#include "construct/tools/close_up.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "changeover/run/scope.hpp"

namespace changeover {
namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

struct Stay {
  std::size_t begin = 0;
  std::size_t end = 0;  // the last block
  Element element = 0;
  std::size_t again = never;  // when the next stay of the element begins
};

std::vector<Stay> stays_of(const Design& design) {
  require_memory(design.block_count() * sizeof(Stay), "the stays of " + name(design.parameters()));
  std::vector<Stay> stays;
  std::vector<std::size_t> current(static_cast<std::size_t>(design.v()), never);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    for (const Element x : design.block(i)) {
      std::size_t& stay = current[x];
      if (stay == never || stays[stay].end + 1 < i) {
        if (stay != never) {
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

}  // namespace

std::optional<Design> closed_up(const Design& design, Element x, std::uint64_t count) {
  Parameters p = design.parameters();
  if (p.kind != Kind::linear || p.change != 1 || count == 0 || p.v <= p.k || count >= p.v - p.k ||
      x > p.v - count) {
    return std::nullopt;
  }
  p.v -= count;
  Design closed(p);
  Block block;
  std::vector<Stay> present;  // in the order of the block
  for (const Stay& stay : stays_of(design)) {
    if (stay.element >= x && stay.element < x + count) {
      continue;
    }
    stop_if_asked();
    const auto same = std::find_if(present.begin(), present.end(), [&](const Stay& other) {
      return other.element == stay.element;
    });
    if (same != present.end()) {
      *same = stay;
      continue;
    }
    const auto number =
        static_cast<Element>(stay.element < x ? stay.element : stay.element - count);
    if (present.size() < p.k) {
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
    if (present.size() == p.k) {
      closed.append(block);
    }
  }
  return closed;
}

std::optional<Element> best_to_close_up(const Design& design, std::size_t most_tries) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(design.v()));
  for (const Stay& stay : stays_of(design)) {
    ++counts[stay.element];
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
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
  std::optional<Element> best;
  std::size_t fewest = never;
  for (const Element x : candidates) {
    const auto closed = closed_up(design, x);
    if (closed && closed->block_count() < fewest) {
      fewest = closed->block_count();
      best = x;
    }
  }
  return best;
}

}  // namespace changeover
