#include "changeover/core/error.hpp"

#include "core/printable.hpp"

namespace changeover {

Error::Error(std::string_view line) : std::runtime_error(printable(line)) {}

}  // namespace changeover
