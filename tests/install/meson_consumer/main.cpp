// Verifies two designs and plans a load order with the library outside of which this is, and prints
// its version.
#include <changeover/core/version.hpp>
#include <changeover/loadorder/load_order.hpp>
#include <changeover/verify/verdict.hpp>
#include <iostream>

#if CHANGEOVER_VERSION < 10000
#error "the version is a number that the preprocessor can compare"
#endif

int main() {
  using namespace changeover;
  const Parameters six{.v = 6, .k = 4, .kind = Kind::circular};
  const Design right(six, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  const Design wrong(six, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 2}});
  if (!verify(right).valid() || verify(wrong).valid()) {
    std::cerr << "the verdicts are wrong\n";
    return 1;
  }
  // The library for C has the same name without lib and .so, and none of these functions.
  const LoadOrder order = plan_load_order(64, 16);
  if (order.facts().loads < order.facts().bound.loads || order.facts().loads < 64) {
    std::cerr << "the load order is wrong\n";
    return 1;
  }
  std::cout << version << '\n';
}
