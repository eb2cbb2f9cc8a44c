#include "construct/tools/leave/triple_leave.hpp"

#include <algorithm>
#include <iterator>

#include "construct/tools/leave/held_lists.hpp"
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

std::array<std::uint64_t, 3> differences_of(const TripleLeave::Triple& triple, std::uint64_t w) {
  const auto difference = [w](std::uint64_t x, std::uint64_t y) {
    const std::uint64_t d = (x + w - y) % w;
    return std::min(d, w - d);
  };
  return {difference(triple[0], triple[1]), difference(triple[0], triple[2]),
          difference(triple[1], triple[2])};
}

}  // namespace

std::shared_ptr<const TripleLeave> TripleLeave::any_of(std::uint64_t k, std::uint64_t v,
                                                       bool leaves) {
  if (k < 4) {
    return nullptr;
  }
  const std::uint64_t N = k - 2;
  std::shared_ptr<const TripleLeave> best;
  std::uint64_t least = 0;  // blocks, without the ways
  for (const FormalLeave& known : formal_leaves()) {
    const std::uint64_t w = known.elements(N);
    if ((known.left > 0) != leaves || w + (k - 3) * known.left != v || !known.serves(N)) {
      continue;
    }
    const std::shared_ptr<TripleLeave> leave(new TripleLeave(w, known.left));
    if (!leave->make(known, N)) {
      continue;
    }
    const std::uint64_t blocks = leave->sets() + (leaves ? HeldList(k, 3, leave->t_).size() : 0);
    if (!best || blocks < least) {
      best = leave;
      least = blocks;
    }
  }
  return best;
}

std::shared_ptr<const TripleLeave> TripleLeave::of(std::uint64_t k, std::uint64_t v) {
  return any_of(k, v, true);
}

std::shared_ptr<const TripleLeave> TripleLeave::without_leave(std::uint64_t k, std::uint64_t v) {
  return any_of(k, v, false);
}

// Differences that come twice are whatever they are. False if for this N they are among those that
// are left, or if they spoil the link.
bool TripleLeave::make(const FormalLeave& known, std::uint64_t N) {
  for (std::size_t i = 0; i < known.points.size(); i += 3) {
    base_.push_back(elements_at(std::span(known.points).subspan(i).first<3>(), N, w_));
  }
  for (std::size_t i = 0; i < known.triangles.size(); i += 2) {
    const Element d = element_at(known.triangles[i], N, w_);
    const Element e = element_at(known.triangles[i + 1], N, w_);
    triangles_.push_back({0, d, static_cast<Element>((std::uint64_t{d} + e) % w_)});
  }
  const std::vector<std::uint64_t> left = differences();
  return std::ranges::none_of(base_,
                              [&](const Triple& triple) {
                                return std::ranges::any_of(
                                    differences_of(triple, w_), [&](std::uint64_t d) {
                                      return std::ranges::binary_search(left, d);
                                    });
                              }) &&
         order_for_link();
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
  if (t_ % 3 == 1) {
    left.push_back(w_ / 3);
  }
  for (const Triple& triangle : triangles_) {
    std::ranges::copy(differences_of(triangle, w_), std::back_inserter(left));
  }
  std::ranges::sort(left);
  return left;
}

}  // namespace changeover
