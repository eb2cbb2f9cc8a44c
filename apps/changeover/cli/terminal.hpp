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

// What this process asks of the system before it does anything else.

/// Call it first. A closed standard stream gets a descriptor that cannot be used, so that no file
/// takes its number; a write to a pipe without a reader, or beyond the limit on the size of files,
/// fails instead of ending the process.
void prepare_process();

/// The reader of standard output left: ends the process as it would have ended without
/// prepare_process(), by SIGPIPE. Returns only if that is ignored by the parent's wish.
void leave_with_the_reader();

}  // namespace changeover::cli
