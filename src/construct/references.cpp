#include "construct/references.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "io/scan/json_events.hpp"

namespace changeover {

/// docs/references.bib; generated.
[[nodiscard]] std::string_view references_text();

/// web/references.json; generated.
[[nodiscard]] std::string_view works_text();

namespace {

std::map<std::string, Work> read_works() {
  const std::string text(works_text());
  std::map<std::string, Work> works;
  for (const JsonMember& member :
       json_tree({.text = text, .name = "web/references.json"}).members) {
    const auto said = [&](std::string_view key) {
      const JsonNode* const node = member.node.find(key);
      return node != nullptr && node->is_text() ? node->text : std::string();
    };
    works[member.key] = {.name = said("name"), .text = said("text"), .url = said("url")};
  }
  return works;
}

}  // namespace

const Work* find_work(const std::string& key) {
  static const std::map<std::string, Work> works = read_works();
  const auto found = works.find(key);
  return found == works.end() ? nullptr : &found->second;
}

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
