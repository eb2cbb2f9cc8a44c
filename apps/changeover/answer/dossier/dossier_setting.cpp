#include "answer/dossier/dossier_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/words.hpp"

namespace changeover::cli {
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
  const auto is_date = [&](std::string_view text) {  // 2026-11-21
    constexpr std::string_view shape = "0000-00-00";
    return text.size() >= shape.size() &&
           std::ranges::equal(text.substr(0, shape.size()), shape, [&](char c, char form) {
             return form == '-' ? c == '-' : is_digit(c);
           });
  };
  for (std::size_t at = 0; at < html.size();) {
    const std::string_view rest = html.substr(at);
    if (is_date(rest) && (at == 0 || !is_alphanumeric(html[at - 1]))) {
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
               (rest.size() == 2 || !is_alphanumeric(rest[2])) &&
               (rest.size() < 3 || rest[2] != '.' || rest.size() < 4 || rest[3] == ' ') &&
               (at == 0 || !(is_alphanumeric(html[at - 1]) || html[at - 1] == '.'))) {
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
    const std::size_t digit = out.find_last_not_of("0123456789");
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
