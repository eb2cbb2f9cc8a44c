#include "bounds/counting_bound.hpp"

#include "core/checked.hpp"

namespace changeover {

std::uint64_t counting_bound(const Parameters& p) {
  if (p.v == p.k) {
    return 1;
  }
  const std::uint64_t all = binomial(p.v, p.strength);
  const std::uint64_t most = newly_covered_at_most(p);
  return p.kind == Kind::circular ? ceil_div(all, most)
                                  : ceil_div(all - binomial(p.k, p.strength), most) + 1;
}

}  // namespace changeover
