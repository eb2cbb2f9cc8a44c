// A design from a file of any format that is known here.
//
//     Design design = read_design("mine.txt");                      // "-": standard input
//     auto stream = open_design("huge.txt", {.kind = Kind::circular});
//     Verdict verdict = verify(*stream);
//
// The first byte that is not blank decides: `{` or `[` is JSON; otherwise, a first line with a comma or
// semicolon (before any `#`) is CSV; all else is text. Names of files mean nothing.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "changeover/core/design.hpp"
#include "changeover/io/design_input.hpp"
#include "changeover/io/input.hpp"

namespace changeover {

enum class Format : std::uint8_t { text, json, csv };

/// The format of a file that begins like this; a few hundred bytes are enough.
[[nodiscard]] Format guess_format(std::string_view beginning);

/// The whole design with labels and recipe.
/// @throws MissingResource with one line if the file cannot be read; BadInput as io/design_input.hpp
/// says.
[[nodiscard]] Design read_design(const std::string& path, const ReadOptions& options = {});
[[nodiscard]] Design read_design(std::unique_ptr<Input> input, const ReadOptions& options = {});

/// The design as a stream: text is read as it is needed (see io/text.hpp for when it is kept), JSON
/// and CSV are held in memory. @throws as read_design(), from here or from next().
[[nodiscard]] std::unique_ptr<DesignInput> open_design(const std::string& path,
                                                       const ReadOptions& options = {});
[[nodiscard]] std::unique_ptr<DesignInput> open_design(std::unique_ptr<Input> input,
                                                       const ReadOptions& options = {});

}  // namespace changeover
