// Has two designs verified by the library outside of which this is, and prints its version.
#include <changeover/core/version.hpp>
#include <changeover/verify/verdict.hpp>
#include <iostream>

int main() {
  using namespace changeover;
  const Parameters six{.v = 6, .k = 4, .kind = Kind::circular};
  const Design right(six, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  const Design wrong(six, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 2}});
  if (!verify(right).valid() || verify(wrong).valid()) {
    std::cerr << "the verdicts are wrong\n";
    return 1;
  }
  std::cout << version << '\n';
}
