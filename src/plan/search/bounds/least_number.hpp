// A number that something is at least, and why.
#pragma once

#include <cstdint>
#include <string>

namespace changeover {

/// The largest lower bound so far, with its reason; the first of equals.
struct LeastNumber {
  std::uint64_t number = 0;
  std::string why;

  void at_least(std::uint64_t other, const std::string& reason) {
    if (other > number) {
      number = other;
      why = reason;
    }
  }
};

}  // namespace changeover
