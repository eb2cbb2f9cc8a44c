// A program outside the project: includes every installed header, calls into the library and
// prints its version.
#include <iostream>

#include "every_header.hpp"

int main() {
  const changeover::Parameters parameters{.v = 61, .k = 4};
  check(parameters);
  std::cout << changeover::version << '\n';
}
