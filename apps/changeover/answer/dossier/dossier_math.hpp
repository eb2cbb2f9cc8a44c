// Formulas of a dossier that need two dimensions, as MathML.
#pragma once

#include <string>
#include <string_view>

namespace changeover::cli {

/// HTML as html_prose() makes it, in which binomials, C(43,2), and sums with an index are MathML.
/// What is no formula stays as it is. O(length · depth).
[[nodiscard]] std::string with_mathml(std::string_view html);

}  // namespace changeover::cli
