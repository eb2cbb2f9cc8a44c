// What is known in general, as JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace changeover::serve {

/// docs/theorems.md; generated.
[[nodiscard]] std::string_view theorems_text();

/// atlas_json() of stored_cells() for each change number and kind, a line each; generated. Empty in
/// builds that are not optimised.
[[nodiscard]] std::string_view stored_atlases();

struct Theorem {
  std::string number;
  std::string title;
  std::string statement;  ///< Markdown, up to the proof
  std::string proof;      ///< Markdown, and what follows it in its section; empty if there is none
};

/// The theorems of a text like docs/theorems.md: sections "## Theorem N", titles in the list of
/// contents.
[[nodiscard]] std::vector<Theorem> theorems_of(std::string_view text);

/// [{"number","title","statement","proof","example":{v,k,change,kind}|null}]
[[nodiscard]] std::string theorems_json();

/// [{"name","summary","citation","serves","gives","example":{v,k,change,kind}|null}]
[[nodiscard]] std::string constructions_json();

}  // namespace changeover::serve
