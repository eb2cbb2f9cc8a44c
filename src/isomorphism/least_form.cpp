#include "isomorphism/least_form.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace changeover {
namespace {

// Readings that may give the least form: start, start ± stride, …, `count` of them, in one
// direction.
struct Candidates {
  std::size_t start = 0;
  std::size_t stride = 0;
  std::size_t count = 0;
  bool backwards = false;

  [[nodiscard]] Reading reading(std::size_t index, std::size_t b) const {
    const Reading first{.start = start, .backwards = backwards};
    return index == 0 ? first
                      : Reading{.start = first.block(index * stride, b), .backwards = backwards};
  }
};

// Whether two words of the same length are equal, each read from its own start; if not, which is
// less.
bool same_rotation(const std::vector<BlockSymbol>& a, std::size_t a_start,
                   const std::vector<BlockSymbol>& b, std::size_t b_start, bool& less) {
  const std::size_t n = a.size();
  for (std::size_t i = 0; i < n; ++i) {
    const BlockSymbol& x = a[(a_start + i) % n];
    const BlockSymbol& y = b[(b_start + i) % n];
    if (x != y) {
      less = x < y;
      return false;
    }
  }
  return true;
}

std::vector<Candidates> candidates(const Design& design, const Sameness& same) {
  const std::size_t b = design.block_count();
  const std::size_t last = b == 0 ? 0 : b - 1;
  if (design.parameters().kind == Kind::linear || !same.rotation || b < 2) {
    std::vector<Candidates> ends{{.start = 0, .stride = 1, .count = 1, .backwards = false}};
    if (same.reversal) {
      ends.push_back({.start = last, .stride = 1, .count = 1, .backwards = true});
    }
    return ends;
  }
  std::vector<Candidates> all;
  CyclicWords words = cyclic_words(design);
  const LeastRotation forwards = least_rotation(words.forwards);
  all.push_back({.start = forwards.start,
                 .stride = forwards.period,
                 .count = b / forwards.period,
                 .backwards = false});
  if (same.reversal) {
    // As a word that is read from left to right: block b−1 first.
    std::ranges::reverse(words.backwards);
    const LeastRotation backwards = least_rotation(words.backwards);
    const Candidates reversed{.start = last - backwards.start,
                              .stride = backwards.period,
                              .count = b / backwards.period,
                              .backwards = true};
    bool less = false;
    if (same_rotation(words.backwards, backwards.start, words.forwards, forwards.start, less)) {
      all.push_back(reversed);
    } else if (less) {
      all = {reversed};
    }
  }
  return all;
}

}  // namespace

LeastForm least_form(const Design& design, const Sameness& same) {
  const std::size_t b = design.block_count();
  StandardNames names(design);
  LeastForm least{.reading = {},
                  .form = {},
                  .map = {},
                  .twins = {},
                  .step = std::max<std::size_t>(b, 1),
                  .mirror = {}};
  bool any = false;
  for (const Candidates& set : candidates(design, same)) {
    // Once two readings agree, rotating by their distance is a symmetry, and readings that differ
    // by it need not be looked at any more. The distance is the same in both directions.
    std::size_t distinct = std::min(set.count, least.step / set.stride);
    std::size_t own_best = 0;
    bool own_is_best = false;
    for (std::size_t index = 0; index < distinct; ++index) {
      names.read(set.reading(index, b));
      const bool equal = any && names.form() == least.form;
      if (equal && own_is_best) {
        distinct = std::gcd(distinct, index - own_best);
        least.step = distinct * set.stride;
      } else if (equal) {
        least.mirror = set.reading(index, b);
        break;
      } else if (!any || names.form() < least.form) {
        any = true;
        own_is_best = true;
        own_best = index;
        least.mirror.reset();
        least.reading = set.reading(index, b);
        least.form = names.form();
        least.map = names.map();
        least.twins = names.twins();
      }
    }
  }
  return least;
}

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

StandardNames::StandardNames(const Design& design)
    : design_(&design),
      name_of_(design.v()),
      element_of_(design.v()),
      form_(design.elements().size()),
      class_of_(design.v()) {}

void StandardNames::read(const Reading& reading) {
  const std::size_t v = name_of_.size();
  const std::size_t b = design_->block_count();
  const std::size_t k = design_->k();
  reading_ = reading;
  std::iota(name_of_.begin(), name_of_.end(), Element{0});
  std::iota(element_of_.begin(), element_of_.end(), Element{0});
  std::ranges::fill(class_of_, 0);
  classes_.assign(1, Class{.begin = 0, .size = v, .met = 0});
  for (std::size_t place = 0; place < b && classes_.size() < v; ++place) {
    split(design_->block(reading.block(place, b)));
  }
  auto out = form_.begin();
  for (std::size_t place = 0; place < b; ++place) {
    const auto begin = out;
    for (const Element x : design_->block(reading.block(place, b))) {
      *out++ = name_of_[x];
    }
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(k));
  }
}

void StandardNames::split(std::span<const Element> block) {
  touched_.clear();
  for (const Element x : block) {
    Class& own = classes_[class_of_[x]];
    if (own.met == 0) {
      touched_.push_back(class_of_[x]);
    }
    const auto front = static_cast<Element>(own.begin + own.met++);
    const Element other = element_of_[front];
    std::swap(element_of_[front], element_of_[name_of_[x]]);
    std::swap(name_of_[x], name_of_[other]);
  }
  for (const std::size_t index : touched_) {
    Class& own = classes_[index];
    const std::size_t met = std::exchange(own.met, 0);
    if (met == own.size) {
      continue;
    }
    const Class in{.begin = own.begin, .size = met, .met = 0};
    own.begin += met;
    own.size -= met;
    for (std::size_t name = in.begin; name < in.begin + met; ++name) {
      class_of_[element_of_[name]] = classes_.size();
    }
    classes_.push_back(in);
  }
}

std::vector<std::vector<Element>> StandardNames::twins() const {
  std::vector<std::vector<Element>> twins;
  for (const Class& each : classes_) {
    if (each.size > 1) {
      const auto begin = element_of_.begin() + static_cast<std::ptrdiff_t>(each.begin);
      twins.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(each.size));
      std::ranges::sort(twins.back());
    }
  }
  std::ranges::sort(twins);
  return twins;
}

Isomorphism StandardNames::map() const {
  const std::size_t b = design_->block_count();
  const std::size_t shift =
      reading_.backwards || b == 0 ? reading_.start : (b - reading_.start) % b;
  return {.elements = name_of_, .shift = shift, .reversed = reading_.backwards};
}

}  // namespace changeover
