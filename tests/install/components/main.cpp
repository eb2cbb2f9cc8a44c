// Linked with all of a room; see CMakeLists.txt.
#include <changeover/core/version.hpp>
#include <iostream>

int main() { std::cout << changeover::version << '\n'; }
