// A program outside the project: includes the whole public door, calls into the library and prints
// its version.
#include <changeover/changeover.hpp>
#include <iostream>

int main() {
  const changeover::Parameters parameters{.v = 61, .k = 4};
  check(parameters);
  std::cout << changeover::version << '\n';
}
