#include "isomorphism/least_form.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "isomorphism/cyclic_word.hpp"

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
    std::reverse(words.backwards.begin(), words.backwards.end());
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

}  // namespace changeover
