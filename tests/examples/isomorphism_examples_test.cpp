// The examples of the headers of isomorphism/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::isomorphism_examples_test {
namespace {

// The cyclic circular DCCD(11,4,11), and the same read backwards from another block, with other
// names.
Design cyclic() {
  DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});
  return read_all(source);
}

Design disguised() {
  Isomorphism map = identity(11);
  std::ranges::rotate(map.elements, map.elements.begin() + 4);
  std::swap(map.elements[0], map.elements[7]);
  map.shift = 5;
  map.reversed = true;
  return image(map, cyclic());
}

TEST(IsomorphismExamples, Isomorphism) {
  const Design mine = cyclic();
  const Design theirs = disguised();
  const std::size_t b = mine.block_count();
  bool found = false;
  if (const auto map = find_isomorphism(mine, theirs, {.reversal = true})) {
    EXPECT_LT(map->elements[0], 11U);
    EXPECT_LT(position(*map, 0, b), b);
    found = carries(*map, mine, theirs);
  }
  EXPECT_TRUE(found);
}

TEST(IsomorphismExamples, Canonical) {
  const Design design = disguised();
  const CanonicalForm form = canonical_form(design, {.reversal = true});
  const CanonicalForm other = canonical_form(cyclic(), {.reversal = true});
  EXPECT_TRUE(std::ranges::equal(form.design.elements(), other.design.elements()));
  EXPECT_TRUE(carries(form.map, design, form.design));
}

TEST(IsomorphismExamples, Automorphisms) {
  const Design design = cyclic();
  const AutomorphismGroup group = automorphisms(design);
  EXPECT_EQ(group.order, "11");
  EXPECT_EQ(group.rotations, 11U);
  EXPECT_FALSE(group.generators.empty());
  for (const Isomorphism& map : group.generators) {
    EXPECT_TRUE(carries(map, design, design));
  }
}

TEST(IsomorphismExamples, BlockSystem) {
  const Design first = cyclic();
  const Design second = disguised();
  const BlockSystem a = block_system(first);
  const BlockSystem b = block_system(second);
  EXPECT_TRUE(a.blocks == b.blocks);
  EXPECT_EQ(a.group_order, b.group_order);
}

}  // namespace
}  // namespace changeover::test::isomorphism_examples_test
