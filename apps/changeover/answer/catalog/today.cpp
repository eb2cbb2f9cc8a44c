#include "answer/catalog/today.hpp"

#include <fmt/chrono.h>

#include <ctime>

namespace changeover::cli {

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

}  // namespace changeover::cli
