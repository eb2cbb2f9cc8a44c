#include "answer/dossier/dossier_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "answer/known/theorems.hpp"
#include "changeover/core/version.hpp"
#include "core/words.hpp"

namespace changeover::cli {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::string_view our_theorems = "docs/theorems.md";
constexpr std::string_view numbered = ", Theorem ";
constexpr std::string_view stays_of = "stays of Theorem ";

// The length of "docs/theorems.md, Theorem 5", or of it without a number.
std::size_t place_length(std::string_view text) {
  const std::size_t path = our_theorems.size();
  return text.substr(path).starts_with(numbered)
             ? std::min(text.find_first_not_of(digits, path + numbered.size()), text.size())
             : path;
}

std::string cited(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with(stays_of)) {
      const std::size_t end =
          std::min(rest.find_first_not_of(digits, stays_of.size()), rest.size());
      out += fmt::format("stays of [{}, Theorem {}]", own_key,
                         rest.substr(stays_of.size(), end - stays_of.size()));
      at += end;
      continue;
    }
    if (!rest.starts_with(our_theorems)) {
      out += text[at++];
      continue;
    }
    const std::size_t length = place_length(rest);
    const std::string ours = fmt::format(
        "{}{}", own_key, rest.substr(our_theorems.size(), length - our_theorems.size()));
    const std::string_view behind = rest.substr(length);
    at += length;
    if (out.ends_with('[')) {
      out += ours;
    } else if (out.ends_with('(') && behind.starts_with(')')) {
      out.back() = '[';
      out += ours + "]";
      ++at;
    } else if (out.ends_with(", ") && behind.starts_with(']')) {
      out.resize(out.size() - 2);
      out += "] [" + ours;
    } else {
      out += "[" + ours + "]";
    }
  }
  return out;
}

// A command goes up to what no command has: a sentence's end, or what follows it in a list.
std::size_t command_length(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends = text.substr(i).starts_with("; ") || text.substr(i).starts_with(", ") ||
                      text.substr(i).starts_with(". ") || text[i] == ')' ||
                      (text[i] == '.' && i + 1 == text.size());
    if (ends) {
      return i;
    }
  }
  return text.size();
}

}  // namespace

std::string for_paper(std::string_view sentence) {
  static constexpr std::array<std::string_view, 6> verbs{
      "changeover search ", "changeover design ", "changeover catalog ",
      "changeover expand ", "changeover verify ", "changeover classify "};
  const std::string text = cited(sentence);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    const bool begins =
        (at == 0 || !is_alphanumeric(text[at - 1])) &&
        std::ranges::any_of(verbs, [&](auto verb) { return rest.starts_with(verb); });
    if (begins) {
      const std::size_t length = command_length(rest);
      out += fmt::format("`{}`", rest.substr(0, length));
      at += length;
    } else {
      out += text[at++];
    }
  }
  return out;
}

std::vector<QuotedTheorem> cited_theorems(const std::vector<std::string>& sentences) {
  std::set<std::string> numbers;
  const std::string mark = fmt::format("[{}{}", own_key, numbered);
  for (const std::string& sentence : sentences) {
    for (std::size_t at = sentence.find(mark); at != std::string::npos;
         at = sentence.find(mark, at + 1)) {
      const std::size_t from = at + mark.size();
      const std::size_t end = std::min(sentence.find_first_not_of(digits, from), sentence.size());
      numbers.insert(sentence.substr(from, end - from));
    }
  }
  std::vector<QuotedTheorem> quoted;
  for (const Theorem& theorem : theorems_of(theorems_text())) {
    if (!numbers.contains(theorem.number)) {
      continue;
    }
    // "[Theorem 5](#theorem-5)" leads nowhere from here.
    std::string bare;
    const std::string& text = theorem.statement;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::size_t target =
          text[i] == ']' && text.substr(i, 2) == "](" ? text.find(')', i) : std::string::npos;
      if (target != std::string::npos) {
        const std::size_t open = bare.rfind('[');
        if (open != std::string::npos) {
          bare.erase(open, 1);
        }
        i = target;
      } else {
        bare += text[i];
      }
    }
    quoted.push_back({theorem.number, theorem.title, bare});
  }
  return quoted;
}

std::string own_theorems_bibtex() {
  return fmt::format(
      "@misc{{{},\n  author = {{{{The Changeover developers}}}},\n"
      "  title  = {{{{Theorems of Changeover, with proofs}}}},\n"
      "  note   = {{Changeover {}, page Theorems of its explorer: changeover serve}}\n}}\n",
      own_key, version);
}

std::vector<std::pair<std::string, bool>> pieces_of(std::string_view text) {
  std::vector<std::pair<std::string, bool>> pieces;
  bool code = false;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || text[i] == '`') {
      if (i > from) {
        pieces.emplace_back(text.substr(from, i - from), code);
      }
      code = !code;
      from = i + 1;
    }
  }
  return pieces;
}

}  // namespace changeover::cli
