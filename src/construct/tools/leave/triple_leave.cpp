#include "construct/tools/leave/triple_leave.hpp"

#include <algorithm>

#include "construct/tools/leave/triple_leave_tables.hpp"

namespace changeover {
namespace {

// aN + s modulo w.
Element element_at(const FormalPlace& place, std::uint64_t N, std::uint64_t w) {
  const std::int64_t x = place.multiple * static_cast<std::int64_t>(N) + place.more;
  return static_cast<Element>(x < 0 ? x + static_cast<std::int64_t>(w) : x);
}

TripleLeave::Triple elements_at(std::span<const FormalPlace, 3> places, std::uint64_t N,
                                std::uint64_t w) {
  return {element_at(places[0], N, w), element_at(places[1], N, w), element_at(places[2], N, w)};
}

}  // namespace

std::shared_ptr<const TripleLeave> TripleLeave::any_of(std::uint64_t k, std::uint64_t v,
                                                       bool leaves) {
  if (k < 4) {
    return nullptr;
  }
  const std::uint64_t N = k - 2;
  for (const FormalLeave& known : formal_leaves()) {
    const std::uint64_t t = known.left;
    const std::uint64_t w = 6 * known.rounds() * N + 2 * t + (known.doubled ? 0 : 1);
    if ((t > 0) != leaves || w + (k - 3) * t != v || !known.serves(N)) {
      continue;
    }
    const std::shared_ptr<TripleLeave> leave(new TripleLeave(w, t));
    for (std::size_t i = 0; i < known.points.size(); i += 3) {
      leave->base_.push_back(elements_at(std::span(known.points).subspan(i).first<3>(), N, w));
    }
    for (std::size_t i = 0; i < known.triangles.size(); i += 2) {
      const Element d = element_at(known.triangles[i], N, w);
      const Element e = element_at(known.triangles[i + 1], N, w);
      leave->triangles_.push_back({0, d, static_cast<Element>((std::uint64_t{d} + e) % w)});
    }
    if (leave->order_for_link()) {
      return leave;
    }
  }
  return nullptr;
}

std::shared_ptr<const TripleLeave> TripleLeave::of(std::uint64_t k, std::uint64_t v) {
  return any_of(k, v, true);
}

std::shared_ptr<const TripleLeave> TripleLeave::without_leave(std::uint64_t k, std::uint64_t v) {
  return any_of(k, v, false);
}

// The last base block holds A + 1. A translate by 1 of the first one has no other element in common
// with it.
bool TripleLeave::order_for_link() {
  const Triple& last = base_.back();
  const auto meets_last = [&](const Triple& triple) {
    return std::ranges::any_of(
        triple, [&](Element x) { return std::ranges::count(last, (x + 1) % w_) > 0; });
  };
  const auto first = std::ranges::find_if_not(base_, meets_last);
  if (first == base_.end() || (first == base_.end() - 1 && base_.size() > 1)) {
    return false;
  }
  std::iter_swap(base_.begin(), first);
  for (Triple& triple : base_) {
    std::ranges::sort(triple);
  }
  return true;
}

IntervalDevelopedSource::Points TripleLeave::points() const {
  return [base = base_](std::uint64_t which, std::span<Element> points) {
    std::ranges::copy(base[static_cast<std::size_t>(which)], points.begin());
  };
}

// First the class of w/3, if that is left; then three of each other triangle, translated by the
// numbers 2, 1 and 0 modulo 3. All begin with the largest translate.
void TripleLeave::write(std::uint64_t i, std::uint64_t j, std::span<Element> set) const {
  const std::uint64_t thirds = t_ % 3;
  const std::uint64_t from_last = w_ / 3 - 1 - j;
  if (i < thirds) {
    for (std::uint64_t p = 0; p < 3; ++p) {
      set[static_cast<std::size_t>(p)] = static_cast<Element>(from_last + p * (w_ / 3));
    }
    return;
  }
  const std::uint64_t shift = 3 * from_last + 2 - (i - thirds) % 3;
  const Triple& triangle = triangles_[static_cast<std::size_t>((i - thirds) / 3)];
  std::ranges::transform(triangle, set.begin(),
                         [&](std::uint64_t x) { return static_cast<Element>((x + shift) % w_); });
}

std::vector<std::uint64_t> TripleLeave::differences() const {
  std::vector<std::uint64_t> left;
  const auto add = [&](std::uint64_t d) { left.push_back(std::min(d, w_ - d)); };
  if (t_ % 3 == 1) {
    add(w_ / 3);
  }
  for (const Triple& triangle : triangles_) {
    add(triangle[1]);
    add(triangle[2]);
    add((triangle[2] + w_ - triangle[1]) % w_);
  }
  std::ranges::sort(left);
  return left;
}

}  // namespace changeover
