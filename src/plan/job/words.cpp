#include "plan/job/words.hpp"

#include <fmt/format.h>

namespace changeover {

std::string count_of(std::uint64_t n, const std::string& singular) {
  return fmt::format("{} {}{}", n, singular, n == 1 ? "" : "s");
}

}  // namespace changeover
