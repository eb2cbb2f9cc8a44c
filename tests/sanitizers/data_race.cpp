// Two threads write one number; must die in a build with the thread sanitizer.
#include <cstdio>
#include <thread>

int main() {
  int shared = 0;
  std::thread other([&shared] { ++shared; });
  ++shared;
  other.join();
  std::printf("survived %d\n", shared);
}
