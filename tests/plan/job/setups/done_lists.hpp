// Lists of done tests of the parts A to F, as a file `d.csv`.
#pragma once

#include <cstdint>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/plan/job.hpp"

namespace changeover::test {

inline DoneList done_list(const std::string& text, std::uint64_t at_once) {
  return read_done(*input_from_text(text, "d.csv"), {"A", "B", "C", "D", "E", "F"}, at_once);
}

/// Why it is refused; "none" if it is not.
inline std::string fault_of_list(const std::string& text, std::uint64_t at_once) {
  try {
    static_cast<void>(done_list(text, at_once));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "none";
}

}  // namespace changeover::test
