#include "search/enumerate/enumeration_degrees.hpp"

#include <algorithm>

namespace changeover {
namespace {

constexpr std::int64_t prices = 4;
constexpr std::int64_t most_cost = 511;  // stands for "impossible" too
constexpr unsigned lane_bits = 16;

std::int64_t lane(std::uint64_t word, std::int64_t price) {
  return static_cast<std::int64_t>((word >> (lane_bits * static_cast<unsigned>(price))) & 0xffffU);
}

std::uint64_t in_lane(std::int64_t value, std::int64_t price) {
  return static_cast<std::uint64_t>(value) << (lane_bits * static_cast<unsigned>(price));
}

}  // namespace

DegreeTable::DegreeTable(const EnumerationCase& own) : change_(own.change), rows_(own.b) {
  const auto stay = static_cast<std::int64_t>(own.change);
  const auto introduction = static_cast<std::int64_t>(own.k) - 1;
  constexpr std::array roles{EndRole::anywhere, EndRole::in, EndRole::out};
  for (std::size_t left = 0; left < own.b; ++left) {
    for (const EndRole role : roles) {
      for (const bool in : {false, true}) {
        for (std::int64_t missing = 0; missing < 64; ++missing) {
          std::uint64_t word = 0;
          for (std::int64_t price = 0; price < prices; ++price) {
            std::int64_t cost = most_cost;
            if (left == 0) {
              const bool allowed = role == EndRole::anywhere || (role == EndRole::in) == in;
              cost = allowed && missing == 0 ? 0 : most_cost;
            } else {
              const auto after = [&](bool next_in, std::int64_t covers) {
                const auto still =
                    static_cast<std::size_t>(std::max<std::int64_t>(missing - covers, 0));
                return lane(rows_[left - 1][offset(role, next_in) + still], price) +
                       std::max<std::int64_t>(covers - missing, 0);
              };
              const std::int64_t next_in =
                  in ? after(true, stay) : after(true, introduction) + price;
              cost = std::min({most_cost, next_in, after(false, 0)});
            }
            word |= in_lane(cost, price);
          }
          rows_[left][offset(role, in) + static_cast<std::size_t>(missing)] = word;
        }
      }
    }
  }
}

std::uint64_t DegreeTable::allowance(std::int64_t excess, std::size_t blocks_left) const {
  constexpr std::int64_t top = 0x7fff;
  const auto introductions = static_cast<std::int64_t>(change_ * blocks_left);
  std::uint64_t word = 0;
  for (std::int64_t price = 0; price < prices; ++price) {
    word |= in_lane(std::min(top, 2 * excess + price * introductions), price);
  }
  return word;
}

}  // namespace changeover
