#include "construct/references.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace changeover {

/// docs/references.bib; generated.
[[nodiscard]] std::string_view references_text();

namespace {

// Letters with an accent: as BibTeX writes them after the backslash, without braces. A test finds
// any that docs/references.bib has and this has not.
using Accented = std::pair<std::string_view, std::string_view>;
constexpr std::array accented_letters{
    Accented{"\"o", "ö"}, Accented{"\"u", "ü"}, Accented{"'a", "á"}, Accented{"'e", "é"},
    Accented{"'i", "í"},  Accented{"'o", "ó"},  Accented{"vs", "š"},
};

// What a command of TeX at `at`, just after its backslash, stands for; moves `at` to its last
// character. The file is our own: no command is cut off.
std::string_view command_text(std::string_view entry, std::size_t& at) {
  const bool accent = std::string_view("'\"`^~v=.").find(entry[at]) != std::string_view::npos;
  if (!accent) {
    return entry.substr(at, 1);
  }
  const bool braced = entry.substr(at + 1, 1) == "{";
  const std::size_t letter = at + (braced ? 2 : 1);
  const auto* const found = std::ranges::find_if(accented_letters, [&](const auto& one) {
    return one.first[0] == entry[at] && one.first[1] == entry[letter];
  });
  at = letter + (braced ? 1 : 0);
  return found != accented_letters.end() ? found->second : entry.substr(letter, 1);
}

// A field of an entry without braces and ends of lines, its accents as letters of Unicode; empty
// if there is none.
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
      text += command_text(entry, ++at);
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

// "Chafee, Amanda Lynn and Stevens, Brett": "A. L. Chafee and B. Stevens".
std::string listed_authors(std::string authors) {
  constexpr std::string_view between = " and ";
  std::vector<std::string> names;
  for (authors += between; !authors.empty();) {
    const std::size_t end = authors.find(between);
    const std::string name = authors.substr(0, end);
    authors.erase(0, end + between.size());
    const std::size_t comma = name.find(", ");
    std::string initials;
    for (std::size_t at = comma; at < name.size(); at = name.find(' ', at + 1)) {
      const std::size_t first = name.find_first_not_of(", ", at);
      const bool ascii = static_cast<unsigned char>(name[first]) < 0x80;
      initials += name.substr(first, ascii ? 1 : 2) + ". ";
      at = first;
    }
    names.push_back(initials + name.substr(0, comma));
  }
  std::string words = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) {
    const bool last = i + 1 == names.size();
    words += names[i] == "others" ? " et al." : (last ? " and " : ", ") + names[i];
  }
  return words;
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

std::string written_work(const std::string& key) {
  const std::string entry = bibtex_of(key);
  std::string words;
  // A work that is known from others only has no title: its note says what it is.
  const char* const named = field(entry, "title").empty() ? "note" : "title";
  for (const std::string_view name : {"author", named, "journal", "booktitle", "school"}) {
    const std::string given = field(entry, name);
    const bool people = name == "author" && !given.empty();
    const std::string part = people ? listed_authors(given) : given;
    words += part.empty() ? "" : (words.empty() ? "" : words.ends_with('.') ? " " : ". ") + part;
  }
  for (const std::string_view name : {"volume", "year"}) {
    const std::string part = field(entry, name);
    words += part.empty() ? "" : (name == "year" ? ", " : " ") + part;
  }
  std::string pages = field(entry, "pages");
  if (const std::size_t dash = pages.find("--"); dash != std::string::npos) {
    pages.replace(dash, 2, "–");
  }
  words += pages.empty() ? "" : ", pages " + pages;
  return words;
}

std::string address_of_work(const std::string& key) {
  const std::string entry = bibtex_of(key);
  if (const std::string doi = field(entry, "doi"); !doi.empty()) {
    return "https://doi.org/" + doi;
  }
  const std::string preprint = field(entry, "eprint");
  return preprint.empty() ? field(entry, "url") : "https://arxiv.org/abs/" + preprint;
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
