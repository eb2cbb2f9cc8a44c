#include "answer/known/theorems.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover::cli {

std::vector<Theorem> theorems_of(std::string_view text) {
  std::vector<Theorem> theorems;
  constexpr std::string_view heading = "\n## Theorem ";
  for (std::size_t at = text.find(heading); at != std::string_view::npos;
       at = text.find(heading, at + 1)) {
    Theorem theorem;
    std::size_t begin = text.find('\n', at + 1);
    theorem.number = std::string(text.substr(at + heading.size(), begin - at - heading.size()));
    // The title is in the list of contents: "- [Theorem 1](#theorem-1): tight circular designs …".
    const std::string entry = fmt::format("- [Theorem {0}](#theorem-{0}): ", theorem.number);
    if (const std::size_t listed = text.find(entry); listed != std::string_view::npos) {
      const std::size_t from = listed + entry.size();
      theorem.title = std::string(text.substr(from, text.find("\n- ", from) - from));
      std::ranges::replace(theorem.title, '\n', ' ');
    }
    const std::size_t next = std::min(text.find("\n## ", begin), text.size());
    const std::size_t proof = std::min(text.find("\n*Proof", begin), next);
    begin = text.find_first_not_of('\n', begin);
    theorem.statement = std::string(text.substr(begin, proof - begin));
    theorem.statement.erase(theorem.statement.find_last_not_of('\n') + 1);
    theorem.proof = std::string(text.substr(proof, next - proof));
    theorem.proof.erase(0, theorem.proof.find_first_not_of('\n'));
    theorem.proof.erase(theorem.proof.find_last_not_of('\n') + 1);
    theorems.push_back(std::move(theorem));
  }
  return theorems;
}

}  // namespace changeover::cli
