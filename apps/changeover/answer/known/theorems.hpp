// The theorems of docs/theorems.md, which is in the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace changeover::cli {

/// docs/theorems.md; generated.
[[nodiscard]] std::string_view theorems_text();

struct Theorem {
  std::string number;
  std::string title;
  std::string statement;  ///< Markdown, up to the proof
  std::string proof;      ///< Markdown, and what follows it in its section; empty if there is none
};

/// The theorems of a text like docs/theorems.md: sections "## Theorem N", titles in the list of
/// contents.
[[nodiscard]] std::vector<Theorem> theorems_of(std::string_view text);

}  // namespace changeover::cli
