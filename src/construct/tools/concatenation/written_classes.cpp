#include "construct/tools/concatenation/written_classes.hpp"

#include <span>
#include <string_view>

namespace changeover {
namespace {

// Two digits for each a: the elements of groups 1 and 2.
constexpr std::string_view of_six[] = {
    "253004134251", "542540011332", "021145345023", "413453200215",
    "314312552400", "035221403514", "100533225144",
};

constexpr std::string_view of_ten[] = {
    "00471876299385346152", "86115728703994450263", "95802267387149561304", "59968133074872602415",
    "73699082441758013526", "68740991835527124630", "37087519928466235041", "14253640516203778998",
    "21324354650610889779", "42536405162031997887",
};

std::span<const std::string_view> classes_of(std::uint64_t g) {
  if (g == 6) {
    return of_six;
  }
  return g == 10 ? std::span<const std::string_view>(of_ten) : std::span<const std::string_view>();
}

}  // namespace

std::uint64_t written_class_count(std::uint64_t g) { return classes_of(g).size(); }

std::uint64_t in_written_class(std::uint64_t g, std::uint64_t index, std::uint64_t i,
                               std::uint64_t a) {
  if (i == 0) {
    return a;
  }
  const std::string_view digits = classes_of(g)[static_cast<std::size_t>(index)];
  return static_cast<std::uint64_t>(digits[static_cast<std::size_t>(2 * a + i - 1)] - '0');
}

}  // namespace changeover
