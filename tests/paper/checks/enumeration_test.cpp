#include "paper/checks/enumeration.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"

namespace changeover::enumeration_test {
namespace {

// Minima that three independent programs agree on.
TEST(Enumeration, finds_the_known_minima) {
  struct Case {
    std::uint64_t v, k, change;
    Kind kind;
    std::uint64_t minimum;
  };
  for (const Case& c : {Case{7, 4, 2, Kind::linear, 5}, Case{10, 5, 2, Kind::linear, 7},
                        Case{6, 4, 2, Kind::circular, 3}, Case{7, 5, 2, Kind::circular, 3},
                        Case{8, 5, 2, Kind::circular, 5}, Case{8, 6, 2, Kind::circular, 3},
                        Case{7, 3, 2, Kind::circular, 7}, Case{3, 2, 1, Kind::circular, 3}}) {
    const Parameters p{.v = c.v, .k = c.k, .change = c.change, .kind = c.kind};
    for (std::uint64_t b = 2; b < c.minimum; ++b) {
      const Enumeration none = enumerate(p, b);
      EXPECT_TRUE(none.found == 0 && none.complete) << name(p) << ' ' << b;
    }
    const Enumeration some = enumerate(p, c.minimum);
    ASSERT_EQ(some.found, 1U) << name(p);
    EXPECT_TRUE(verify(some.designs.front()).valid()) << name(p);
    EXPECT_FALSE(some.complete);  // it stopped at the first
  }
}

TEST(Enumeration, lists_only_valid_designs) {
  const Enumeration all =
      enumerate({.v = 7, .k = 5, .change = 2, .kind = Kind::circular}, 3, {.keep = 1000});
  EXPECT_TRUE(all.complete);
  EXPECT_EQ(all.found, all.designs.size());
  for (const Design& design : all.designs) {
    EXPECT_TRUE(verify(design).valid());
  }
}

TEST(Enumeration, gives_up_without_a_claim) {
  const Enumeration cut =
      enumerate({.v = 10, .k = 5, .change = 2, .kind = Kind::linear}, 6, {.nodes = 10});
  EXPECT_FALSE(cut.complete);
  EXPECT_EQ(cut.found, 0U);
  EXPECT_REFUSAL((void)enumerate({.v = 17, .k = 4, .kind = Kind::linear}, 3), BadInput,
                 "enumeration is for v <= 16 and at least one block");
  EXPECT_THROW((void)enumerate({.v = 6, .k = 4, .kind = Kind::linear}, 0), BadInput);
}

TEST(Enumeration, relabelling_keeps_the_order_of_blocks) {
  const Parameters p{.v = 6, .k = 4, .change = 2, .kind = Kind::circular};
  const Design a(p, std::vector<Block>{{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 0, 1}});
  const Design b(p, std::vector<Block>{{5, 1, 2, 0}, {2, 5, 4, 3}, {4, 3, 0, 1}});
  EXPECT_TRUE(same_up_to_relabelling(a, b));
  const Design c(p, std::vector<Block>{{0, 1, 2, 3}, {2, 3, 4, 5}, {3, 4, 0, 1}});
  EXPECT_FALSE(same_up_to_relabelling(a, c));
}

TEST(Enumeration, finds_no_cycle_in_the_petersen_graph) {
  const Parameters path{.v = 5, .k = 2, .change = 2, .kind = Kind::linear};
  EXPECT_EQ(enumerate(path, 10).found, 1U);
  const Enumeration none = enumerate(path.as(Kind::circular), 10);
  EXPECT_TRUE(none.complete);
  EXPECT_EQ(none.found, 0U);
}

}  // namespace
}  // namespace changeover::enumeration_test
