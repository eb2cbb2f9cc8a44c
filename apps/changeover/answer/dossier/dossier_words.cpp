#include "answer/dossier/dossier_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "changeover/core/version.hpp"
#include "serve/api/about.hpp"

namespace changeover::cli {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::string_view our_theorems = "docs/theorems.md";
constexpr std::string_view numbered = ", Theorem ";
constexpr std::string_view stays_of = "stays of Theorem ";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

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
        (at == 0 || !is_word(text[at - 1])) &&
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
  for (serve::Theorem& theorem : serve::theorems_of(serve::theorems_text())) {
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
      "  note   = {{The file docs/theorems.md in the source of Changeover {}}}\n}}\n",
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

namespace {

constexpr std::string_view space = "\u00a0";
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> brackets{
    {{"⌈", "⌉"}, {"⌊", "⌋"}, {"(", ")"}, {"{", "}"}}};

struct Bracketed {
  std::string html;        // without places to break
  std::size_t length = 0;  // of what it replaces; 0: there is no short formula
};

// The brackets that the text begins with, if no words are in them.
Bracketed bracketed(std::string_view html, std::string_view open, std::string_view close) {
  constexpr std::size_t most = 48;
  Bracketed found;
  std::size_t depth = 0;
  std::size_t shown = 0;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < html.size() && shown <= most;) {
    const std::string_view rest = html.substr(i);
    if (html[i] == '<') {
      const std::size_t end = html.find('>', i);
      if (end == std::string_view::npos) {
        return {};
      }
      const std::string_view tag = html.substr(i, end + 1 - i);
      if (tag.starts_with("<a") || tag.starts_with("</a")) {
        return {};
      }
      found.html += tag == "<wbr>" ? "" : tag;
      i = end + 1;
      letters = 0;
      continue;
    }
    if (rest.starts_with(open)) {
      ++depth;
    }
    const bool ends = rest.starts_with(close) && --depth == 0;
    if (html[i] == ' ') {
      found.html += space;
    } else {
      found.html += html[i];
    }
    letters = is_letter(html[i]) ? letters + 1 : 0;
    if (letters > 1) {
      return {};
    }
    ++i;
    ++shown;
    if (ends) {
      found.html += close.substr(1);
      found.length = i + close.size() - 1;
      return found;
    }
  }
  return {};
}

}  // namespace

std::string unbroken(std::string_view html) {
  static constexpr std::array<std::string_view, 6> relations{" ≥ ", " ≤ ", " = ",
                                                             " · ", " / ", " &gt; "};
  std::string out;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_date = [&](std::string_view text) {  // 2026-11-21
    constexpr std::string_view shape = "0000-00-00";
    return text.size() >= shape.size() &&
           std::ranges::equal(text.substr(0, shape.size()), shape, [&](char c, char form) {
             return form == '-' ? c == '-' : is_digit(c);
           });
  };
  for (std::size_t at = 0; at < html.size();) {
    const std::string_view rest = html.substr(at);
    if (is_date(rest) && (at == 0 || !is_word(html[at - 1]))) {
      out += fmt::format("<span>{}</span>", rest.substr(0, 10));
      at += 10;
      continue;
    }
    if (html[at] == '<') {
      const std::size_t end = std::min(html.find('>', at), html.size() - 1);
      out += html.substr(at, end + 1 - at);
      at = end + 1;
      continue;
    }
    Bracketed found;
    for (const auto& [open, close] : brackets) {
      if (rest.starts_with(open)) {
        found = bracketed(rest, open, close);
      }
    }
    const auto relation = std::ranges::find_if(
        relations, [&](std::string_view each) { return rest.starts_with(each); });
    if (found.length > 0) {
      out += found.html;
      at += found.length;
    } else if (relation != relations.end()) {
      out += space;
      out += relation->substr(1, relation->size() - 2);
      out += space;
      at += relation->size();
    } else if (is_digit(html[at]) && rest.size() > 1 && rest[1] >= 'b' && rest[1] <= 'z' &&
               (rest.size() == 2 || !is_word(rest[2])) &&
               (rest.size() < 3 || rest[2] != '.' || rest.size() < 4 || rest[3] == ' ') &&
               (at == 0 || !(is_word(html[at - 1]) || html[at - 1] == '.'))) {
      out += fmt::format("{}<i>{}</i>", rest[0], rest[1]);
      at += 2;
    } else {
      out += html[at++];
    }
  }
  return out;
}

std::string unbroken_code(std::string_view html) {
  std::string out;
  for (std::size_t at = 0; at <= html.size();) {
    const std::size_t end = std::min(html.find(' ', at), html.size());
    const std::string_view word = html.substr(at, end - at);
    out += word.find('-') == std::string_view::npos ? std::string(word)
                                                    : fmt::format("<span>{}</span>", word);
    out += end < html.size() ? " " : "";
    at = end + 1;
  }
  return out;
}

std::string with_letters_set(std::string_view latex) {
  std::string out;
  bool mathematics = false;
  std::size_t braces = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const char c = latex[i];
    const bool escaped = i > 0 && latex[i - 1] == '\\';
    mathematics ^= c == '$' && !escaped;
    if (!escaped) {
      braces += c == '{' ? 1 : 0;
      braces -= c == '}' && braces > 0 ? 1 : 0;
    }
    const char before = i == 0 ? ' ' : latex[i - 1];
    const char behind = i + 1 < latex.size() ? latex[i + 1] : ' ';
    const bool ends = behind == ' ' || behind == ')' || behind == ';' || behind == ':' ||
                      ((behind == ',' || behind == '.') &&
                       (i + 2 >= latex.size() || latex[i + 2] == ' ' || latex[i + 2] == '\n'));
    const bool letter = c >= 'b' && c <= 'z' && ends && !mathematics && braces == 0;
    const std::size_t digit = out.find_last_not_of(digits);
    const std::size_t from = digit == std::string::npos ? 0 : digit + 1;
    const bool opens = from == 0 || out[from - 1] == ' ' || out[from - 1] == '(';
    if (letter && (before == ' ' || before == '(' || (from < out.size() && opens))) {
      out.insert(from, "$");
      out += c;
      out += '$';
    } else {
      out += c;
    }
  }
  return out;
}

std::vector<StatementPart> statement_parts(std::string_view markdown) {
  std::vector<StatementPart> parts;
  bool open = false;
  for (std::size_t at = 0; at < markdown.size();) {
    const std::size_t end = std::min(markdown.find('\n', at), markdown.size());
    std::string line(markdown.substr(at, end - at));
    at = end + 1;
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) {
      open = false;
      continue;
    }
    const bool formula = first >= 4;
    std::erase(line, '`');
    const std::string text = line.substr(first);
    if (open && parts.back().formula == formula) {
      parts.back().text += " " + text;
    } else {
      parts.push_back({text, formula});
    }
    open = true;
  }
  return parts;
}

}  // namespace changeover::cli
