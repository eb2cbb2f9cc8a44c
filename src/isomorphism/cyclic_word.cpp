#include "isomorphism/cyclic_word.hpp"

#include <algorithm>
#include <limits>

namespace changeover {
namespace {

// A well-mixing bijection of 64 bits; the constants are those of splitmix64's finalizer.
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint64_t mix(std::uint64_t length, std::uint64_t before, std::uint64_t after) {
  return mix(mix(mix(length) + before) + after);
}

struct Run {
  std::size_t begin = 0;
  std::size_t length = 0;
};

// The runs of an element in the cyclic order of blocks; none if it is in every block.
std::vector<Run> runs_of(const std::vector<std::size_t>& occurrences, std::size_t b) {
  std::vector<Run> runs;
  if (occurrences.size() == b) {
    return runs;
  }
  for (const std::size_t at : occurrences) {
    if (!runs.empty() && runs.back().begin + runs.back().length == at) {
      ++runs.back().length;
    } else {
      runs.push_back({.begin = at, .length = 1});
    }
  }
  if (runs.size() > 1 && runs.front().begin == 0 &&
      runs.back().begin + runs.back().length == b) {  // One run across the end.
    runs.back().length += runs.front().length;
    runs.erase(runs.begin());
  }
  return runs;
}

void add(BlockSymbol& symbol, std::uint64_t length, std::uint64_t before, std::uint64_t after) {
  symbol.shorter = std::min(symbol.shorter, std::numeric_limits<std::uint64_t>::max() - length);
  symbol.mixed += mix(length, before, after);  // A sum does not depend on the order of elements.
}

}  // namespace

CyclicWords cyclic_words(const Design& design) {
  const std::size_t b = design.block_count();
  constexpr BlockSymbol nothing{.shorter = std::numeric_limits<std::uint64_t>::max(), .mixed = 0};
  CyclicWords words{.forwards = std::vector<BlockSymbol>(b, nothing),
                    .backwards = std::vector<BlockSymbol>(b, nothing)};
  std::vector<std::vector<std::size_t>> occurrences(design.v());
  for (std::size_t i = 0; i < b; ++i) {
    for (const Element x : design.block(i)) {
      occurrences[x].push_back(i);
    }
  }
  for (const auto& own : occurrences) {
    const std::vector<Run> runs = runs_of(own, b);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const Run& run = runs[r];
      const Run& last = runs[(r + runs.size() - 1) % runs.size()];
      const Run& next = runs[(r + 1) % runs.size()];
      // With a single run both gaps are the whole rest of the circle.
      const std::size_t before = (run.begin + 2 * b - last.begin - last.length) % b;
      const std::size_t after = (next.begin + 2 * b - run.begin - run.length) % b;
      add(words.forwards[run.begin], run.length, before, after);
      add(words.backwards[(run.begin + run.length - 1) % b], run.length, after, before);
    }
  }
  return words;
}

LeastRotation least_rotation(const std::vector<BlockSymbol>& word) {
  const std::size_t n = word.size();
  // Two candidates race; the one that loses at offset `same` is out, and so are the `same` after
  // it.
  std::size_t one = 0;
  std::size_t other = 1;
  std::size_t same = 0;
  while (one < n && other < n && same < n) {
    const BlockSymbol& a = word[(one + same) % n];
    const BlockSymbol& b = word[(other + same) % n];
    if (a == b) {
      ++same;
      continue;
    }
    (a < b ? other : one) += same + 1;
    other += one == other ? 1U : 0U;
    same = 0;
  }
  // The period from the borders of the word.
  std::vector<std::size_t> border(n + 1, 0);
  for (std::size_t i = 1, length = 0; i < n; ++i) {
    while (length > 0 && word[i] != word[length]) {
      length = border[length];
    }
    length += word[i] == word[length] ? 1U : 0U;
    border[i + 1] = length;
  }
  const std::size_t period = n - border[n];
  return {.start = std::min(one, other), .period = n > 0 && n % period == 0 ? period : n};
}

}  // namespace changeover
