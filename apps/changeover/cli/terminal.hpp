// What the terminal can do, if there is one.
#pragma once

#include <cstddef>

#include "changeover/io/output.hpp"

namespace changeover::cli {

/// Whether a descriptor is a terminal that can overwrite a line and show colours: not with
/// TERM=dumb.
[[nodiscard]] bool is_clever_terminal(int descriptor);

/// Whether answers to standard output may be coloured: such a terminal, and NO_COLOR is not set.
[[nodiscard]] bool may_colour(const OutputFile& out);

/// The columns of the terminal, COLUMNS, or 100.
[[nodiscard]] std::size_t terminal_width(const OutputFile& out);

}  // namespace changeover::cli
