// What planted sources ask: is this fault real in this run? (tests/mutation/mutate.py)
//
// CHANGEOVER_FAULT=17 makes fault 17 real. With CHANGEOVER_FAULTS_REACHED=FILE the numbers that
// were asked for are written to FILE at the end, so that faults which no test reaches need no run.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>

namespace changeover_planted {

/// Bytes by number: whether it was asked for. Written to a file when the program ends.
class Reached {
 public:
  Reached() {
    file_ = std::getenv("CHANGEOVER_FAULTS_REACHED");
    bytes_.resize(file_ != nullptr ? 100'000 : 0);
  }
  Reached(const Reached&) = delete;
  Reached& operator=(const Reached&) = delete;
  ~Reached() {
    std::FILE* out = file_ != nullptr ? std::fopen(file_, "w") : nullptr;
    for (std::size_t i = 0; out != nullptr && i < bytes_.size(); ++i) {
      if (bytes_[i] != 0) {
        std::fprintf(out, "%zu\n", i);
      }
    }
    if (out != nullptr) {
      std::fclose(out);
    }
  }
  [[nodiscard]] bool wanted() const { return file_ != nullptr; }
  void mark(int number) { bytes_[static_cast<std::size_t>(number)] = 1; }

 private:
  const char* file_ = nullptr;
  std::vector<char> bytes_;
};

inline int asked() {
  const char* number = std::getenv("CHANGEOVER_FAULT");
  return number != nullptr ? std::atoi(number) : -1;
}

// Before they are initialised, no fault is real.
inline int real_plus_one = asked() + 1;
inline Reached reached;
inline const bool marks = reached.wanted();

}  // namespace changeover_planted

/// The same where the compiler would rather compute the value itself: constants.
inline bool planted_constant(int number) {
  if (changeover_planted::marks) {
    changeover_planted::reached.mark(number);
  }
  return number + 1 == changeover_planted::real_plus_one;
}

constexpr bool planted_fault(int number) {
  return !std::is_constant_evaluated() && planted_constant(number);
}
