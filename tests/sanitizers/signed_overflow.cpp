// Overflows an int; must die in a sanitizer build.
#include <cstdio>
#include <limits>

int main(int argc, char**) {
  const int beyond = std::numeric_limits<int>::max() + argc;
  std::printf("survived %d\n", beyond);
}
