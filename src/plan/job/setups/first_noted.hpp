// The first of several places that one note is about, and how many more there are.
//
//     FirstNoted empty;
//     empty.add([&] { return reader.place(cell) + ": the cell is empty"; });   // for each
//     if (empty) notes.push_back(empty.said("other row") + "; fill it in");
//     // "d.csv:3:7: the cell is empty, as in 2 other rows; fill it in"
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "core/words.hpp"

namespace changeover {

class FirstNoted {
 public:
  /// `words()` is asked for the first only.
  template <class Words>
  void add(Words&& words) {
    if (count_++ == 0) {
      first_ = words();
    }
  }

  [[nodiscard]] explicit operator bool() const { return count_ > 0; }
  [[nodiscard]] std::uint64_t count() const { return count_; }

  [[nodiscard]] std::string said(std::string_view other) const {
    return count_ == 1 ? first_ : fmt::format("{}, as in {}", first_, count_of(count_ - 1, other));
  }

 private:
  std::string first_;
  std::uint64_t count_ = 0;
};

}  // namespace changeover
