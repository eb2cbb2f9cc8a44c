#include "changeover/isomorphism/isomorphism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "isomorphism/least_form.hpp"

namespace changeover {
namespace {

bool is_permutation(const std::vector<Element>& elements, std::size_t v) {
  if (elements.size() != v) {
    return false;
  }
  std::vector<bool> seen(v, false);
  for (const Element x : elements) {
    if (x >= v || seen[x]) {
      return false;
    }
    seen[x] = true;
  }
  return true;
}

// Whether the map can act on such a list at all.
bool fits(const Isomorphism& map, const Design& design) {
  const std::size_t b = design.block_count();
  if (!is_permutation(map.elements, design.v()) || map.shift >= std::max<std::size_t>(b, 1)) {
    return false;
  }
  const std::size_t linear_shift = map.reversed && b > 0 ? b - 1 : 0;
  return design.parameters().kind == Kind::circular || map.shift == linear_shift;
}

}  // namespace

std::size_t position(const Isomorphism& map, std::size_t index, std::size_t b) {
  return map.reversed ? (map.shift + b - index) % b : (map.shift + index) % b;
}

Isomorphism identity(std::size_t v) {
  Isomorphism map;
  map.elements.resize(v);
  std::iota(map.elements.begin(), map.elements.end(), Element{0});
  return map;
}

Isomorphism compose(const Isomorphism& first, const Isomorphism& second, std::size_t b) {
  Isomorphism both;
  both.elements.reserve(first.elements.size());
  for (const Element x : first.elements) {
    both.elements.push_back(second.elements[x]);
  }
  both.shift = b == 0 ? 0 : position(second, first.shift, b);
  both.reversed = first.reversed != second.reversed;
  return both;
}

Isomorphism inverse(const Isomorphism& map, std::size_t b) {
  Isomorphism back;
  back.elements.resize(map.elements.size());
  for (std::size_t x = 0; x < map.elements.size(); ++x) {
    back.elements[map.elements[x]] = static_cast<Element>(x);
  }
  back.shift = map.reversed || b == 0 ? map.shift : (b - map.shift) % b;
  back.reversed = map.reversed;
  return back;
}

Design image(const Isomorphism& map, const Design& design) {
  if (!fits(map, design)) {
    throw BadInput(fmt::format("this map does not act on {} and {}",
                               count_of(design.v(), "element"),
                               count_of(design.block_count(), "block")));
  }
  const std::size_t b = design.block_count();
  const std::size_t k = design.k();
  std::vector<Element> elements(design.elements().size());
  for (std::size_t i = 0; i < b; ++i) {
    const auto begin = elements.begin() + static_cast<std::ptrdiff_t>(position(map, i, b) * k);
    std::ranges::transform(design.block(i), begin, [&](Element x) { return map.elements[x]; });
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(k));
  }
  Design image(design.parameters());
  image.reserve(b);
  for (std::size_t at = 0; at < elements.size(); at += k) {
    image.append(std::span(elements).subspan(at, k));
  }
  return image;
}

bool carries(const Isomorphism& map, const Design& from, const Design& to) {
  const std::size_t b = from.block_count();
  if (from.v() != to.v() || from.k() != to.k() || b != to.block_count() ||
      from.parameters().kind != to.parameters().kind || !fits(map, from)) {
    return false;
  }
  std::vector<std::size_t> last_seen(to.v(), 0);
  for (std::size_t i = 0; i < b; ++i) {
    for (const Element y : to.block(position(map, i, b))) {
      last_seen[y] = i + 1;
    }
    if (!std::ranges::all_of(from.block(i),
                             [&](Element x) { return last_seen[map.elements[x]] == i + 1; })) {
      return false;
    }
  }
  return true;
}

std::optional<Isomorphism> find_isomorphism(const Design& from, const Design& to,
                                            const Sameness& same) {
  const std::size_t b = from.block_count();
  if (from.v() != to.v() || from.k() != to.k() || b != to.block_count() ||
      from.parameters().kind != to.parameters().kind) {
    return std::nullopt;
  }
  const LeastForm one = least_form(from, same);
  const LeastForm other = least_form(to, same);
  if (one.form != other.form) {
    return std::nullopt;
  }
  Isomorphism map = compose(one.map, inverse(other.map, b), b);
  if (!carries(map, from, to)) {
    throw InternalError("an isomorphism does not carry one design to the other");
  }
  return map;
}

}  // namespace changeover
