#include "changeover/core/developed.hpp"

#include "core/checked.hpp"

namespace changeover {

std::uint64_t Automorphism::pair_orbits() const {
  const std::uint64_t within = checked_multiply(cycles, n / 2);
  const std::uint64_t between = checked_multiply(binomial(cycles, 2), n);
  return checked_add(checked_add(within, between), cycles * fixed + binomial(fixed, 2));
}

}  // namespace changeover
