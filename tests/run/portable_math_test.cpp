// Logarithms and powers of our own: near the true ones, and the same bits everywhere.
#include "run/portable_math.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "run/random.hpp"

namespace changeover::portable_math_test {
namespace {

double tolerance(double x) { return std::abs(x) * 4e-15 + 1e-16; }

TEST(PortableMath, AgreesWithTheLibrary) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const double u = (static_cast<double>(random.next32()) + 1) / 4294967296.0;
    EXPECT_NEAR(natural_log(u), std::log(u), tolerance(std::log(u)));
    EXPECT_NEAR(natural_log(1 / u), std::log(1 / u), tolerance(std::log(u)));
    const double x = u * 40 - 20;
    EXPECT_NEAR(power_of_two(x), std::exp2(x), tolerance(std::exp2(x)));
  }
  EXPECT_EQ(natural_log(1), 0);
  EXPECT_EQ(power_of_two(0), 1);
  EXPECT_EQ(power_of_two(-3), 0.125);
}

TEST(PortableMath, TablesAreThoseOfEverySearchSoFar) {
  for (std::size_t i = 0; i < log_table().size(); ++i) {
    EXPECT_EQ(log_table().at(i),
              std::round(-std::log((static_cast<double>(i) + 0.5) / 4096) * 1048576) / 1048576);
  }
  EXPECT_NEAR(two_to_minus(3.5), std::exp2(-3.5), 1e-6);
}

// A machine that fuses or reorders operations has other bits.
TEST(PortableMath, HasTheSameBitsOnEveryMachine) {
  std::uint64_t logs = 0;
  std::uint64_t powers = 0;
  for (std::uint32_t i = 1; i <= 10'000; ++i) {
    logs = logs * 31 + std::bit_cast<std::uint64_t>(natural_log(i / 10'001.0));
    powers = powers * 31 + std::bit_cast<std::uint64_t>(power_of_two(i / -1'000.0));
  }
  EXPECT_EQ(logs, 9698592058507386455U);
  EXPECT_EQ(powers, 11460244816595039929U);
}

}  // namespace
}  // namespace changeover::portable_math_test
