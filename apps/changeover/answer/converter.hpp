// Pictures as PDF and PNG, by a program that knows how: rsvg-convert of librsvg.
#pragma once

#include <string>

namespace changeover::cli {

/// An SVG file as "pdf" or "png", enlarged by `zoom`. @throws MissingResource in one line: that the
/// program is missing and which package has it, what it said, or that what it wrote is no such
/// picture.
[[nodiscard]] std::string converted(const std::string& svg, const std::string& format,
                                    unsigned zoom);

/// Where that program is, as PATH says; empty if it is not to be found.
[[nodiscard]] std::string converter_path();

}  // namespace changeover::cli
