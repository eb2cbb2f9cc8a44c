#include "construct/references.hpp"

#include <algorithm>
#include <string_view>

namespace changeover {

/// docs/references.bib; generated.
[[nodiscard]] std::string_view references_text();

namespace {

// A field of an entry without braces, accents and ends of lines; empty if there is none.
std::string field(std::string_view entry, std::string_view name) {
  std::size_t at = entry.find('\n');
  for (; at != std::string_view::npos; at = entry.find('\n', at + 1)) {
    const std::size_t begin = entry.find_first_not_of(" \n", at);
    if (begin != std::string_view::npos && entry.substr(begin).starts_with(name) &&
        (entry[begin + name.size()] == ' ' || entry[begin + name.size()] == '=')) {
      break;
    }
  }
  at = at == std::string_view::npos ? at : entry.find('{', at);
  std::string text;
  int depth = 0;
  for (; at < entry.size(); ++at) {
    const char c = entry[at];
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (depth == 0) {
      break;
    }
    if (c == '\\') {
      ++at;  // The accent of the letter behind it.
    } else if (c == ' ' || c == '\n') {
      text += text.ends_with(' ') ? "" : " ";
    } else if (c != '{' && c != '}') {
      text += c;
    }
  }
  return text;
}

// "Chafee, Amanda Lynn and Stevens, Brett": the family names.
std::vector<std::string> families(std::string authors) {
  constexpr std::string_view between = " and ";
  std::vector<std::string> names;
  for (authors += between; !authors.empty();) {
    const std::size_t end = authors.find(between);
    names.push_back(authors.substr(0, std::min(end, authors.find(','))));
    authors.erase(0, end + between.size());
  }
  return names;
}

}  // namespace

std::string spoken_work(const std::string& key) {
  const std::string entry = bibtex_of(key);
  const std::string authors = field(entry, "author");
  if (authors.empty()) {
    return "";
  }
  const std::vector<std::string> names = families(authors);
  std::string words = names.front();
  if (names.size() > 3 || names.back() == "others") {
    words += " et al.";
  } else {
    for (std::size_t i = 1; i < names.size(); ++i) {
      words += (i + 1 < names.size() ? ", " : " and ") + names[i];
    }
  }
  const std::string year = field(entry, "year");
  return year.empty() ? words : words + " " + year;
}

std::string title_of_work(const std::string& key) { return field(bibtex_of(key), "title"); }

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
