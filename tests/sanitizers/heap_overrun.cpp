// Reads one past the end of an array; must die in a sanitizer build.
#include <cstdio>
#include <memory>

int main(int argc, char**) {
  const auto numbers = std::make_unique<int[]>(4);
  const int beyond = numbers[static_cast<unsigned>(argc) + 3];
  std::printf("survived %d\n", beyond);
}
