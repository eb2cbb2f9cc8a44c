#include "construct/references.hpp"

#include <algorithm>
#include <string_view>

namespace changeover {

/// docs/references.bib; generated.
[[nodiscard]] std::string_view references_text();

std::string bibtex_of(const std::string& key) {
  const std::string_view all = references_text();
  const std::size_t named = all.find("{" + key + ",");
  if (named == std::string_view::npos) {
    return "";
  }
  const std::size_t begin = all.rfind('@', named);
  const std::size_t end = all.find("\n}", named);
  return std::string(all.substr(begin, end + 2 - begin)) + "\n";
}

void add_keys(const std::string& sentence, std::vector<std::string>& keys) {
  for (std::size_t at = sentence.find('['); at != std::string::npos;
       at = sentence.find('[', at + 1)) {
    const std::size_t end = sentence.find_first_of(",]", at);
    if (end == std::string::npos) {
      return;
    }
    const std::string key = sentence.substr(at + 1, end - at - 1);
    if (std::ranges::find(keys, key) == keys.end() && !bibtex_of(key).empty()) {
      keys.push_back(key);
    }
  }
}

}  // namespace changeover
