// Is a list of blocks developed from its first ones under a rotation?
#include <algorithm>
#include <numeric>

#include "changeover/core/developed.hpp"
#include "changeover/draw/draw.hpp"

namespace changeover {
namespace {

class Search {
 public:
  explicit Search(const Design& design)
      : design_(design), seen_(static_cast<std::size_t>(design.v())) {}

  // π^shift takes each block to the one c later, and the last c to the first.
  bool holds(const Automorphism& pi, std::uint64_t shift, std::size_t c) {
    for (std::size_t i = 0; i < design_.block_count(); ++i) {
      if (!takes(pi, shift, i, (i + c) % design_.block_count())) {
        return false;
      }
    }
    return true;
  }

 private:
  bool takes(const Automorphism& pi, std::uint64_t shift, std::size_t from, std::size_t to) {
    ++stamp_;
    for (const Element x : design_.block(to)) {
      seen_[x] = stamp_;
    }
    return std::ranges::none_of(
        design_.block(from), [&](const Element x) { return seen_[pi.image(x, shift)] != stamp_; });
  }

  const Design& design_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t stamp_ = 0;
};

// What may have that order, one cycle first.
std::vector<std::pair<Automorphism, std::uint64_t>> candidates(std::uint64_t v,
                                                               std::uint64_t order) {
  constexpr std::uint64_t most_fixed = 3;
  std::vector<std::pair<Automorphism, std::uint64_t>> all;
  for (const std::uint64_t fixed : {0U, 1U}) {
    const std::uint64_t n = v - fixed;
    if (n < 2 || n % order != 0) {
      continue;
    }
    for (std::uint64_t shift = n / order; shift < n; shift += n / order) {
      if (std::gcd(n, shift) == n / order) {
        all.emplace_back(Automorphism{.n = n, .cycles = 1, .fixed = fixed}, shift);
      }
    }
  }
  for (std::uint64_t fixed = 0; fixed <= std::min(most_fixed, v); ++fixed) {
    const auto pi = Automorphism::on(v, order, fixed);
    if (pi && pi->cycles > 1) {
      all.emplace_back(*pi, 1);
    }
  }
  return all;
}

}  // namespace

std::optional<FoundRotation> find_rotation(const Design& design) {
  const std::size_t b = design.block_count();
  if (design.parameters().kind != Kind::circular || b < 2) {
    return std::nullopt;
  }
  Search search(design);
  for (std::size_t c = 1; 2 * c <= b; ++c) {
    if (b % c != 0) {
      continue;
    }
    const std::uint64_t order = b / c;  // of π^shift
    for (const auto& [pi, shift] : candidates(design.v(), order)) {
      if (search.holds(pi, shift, c)) {
        const std::vector<Block> blocks = design.blocks();
        return FoundRotation{
            pi, shift, {blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(c)}};
      }
    }
  }
  return std::nullopt;
}

}  // namespace changeover
