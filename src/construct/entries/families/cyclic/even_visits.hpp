// The steps of even-visits (even_visits.cpp), which chained-visits changes near both ends.
#pragma once

#include <cstdint>
#include <vector>

#include "construct/entries/families/cyclic/without_neighbours.hpp"

namespace changeover {

/// Leg j makes the blocks with W_j.
class EvenVisits : public LegsWithHeldPlaces {
 public:
  using LegsWithHeldPlaces::LegsWithHeldPlaces;

 protected:
  [[nodiscard]] std::vector<std::uint64_t> visitors_of(std::uint64_t j) const final {
    std::vector<std::uint64_t> visitors;
    const auto enter = [&](std::uint64_t o) {
      const std::uint64_t x = (j + o * numbers().big) % numbers().u;
      if (!deleted(x) && (o == 2 || !holds_a_place(x))) {
        visitors.push_back(x);
      }
    };
    for (std::uint64_t o = 2 * numbers().c - 2; o >= 2; o -= 2) {
      enter(o);
    }
    enter(1);
    return visitors;
  }

 private:
  [[nodiscard]] bool holds_a_place(std::uint64_t x) const {
    return x >= numbers().big && deleted(x - numbers().big);
  }
};

}  // namespace changeover
