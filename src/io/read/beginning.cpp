#include "io/read/beginning.hpp"

#include <algorithm>
#include <array>

#include "core/words.hpp"

namespace changeover {
namespace {

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

}  // namespace

bool is_of_name(char c) { return is_alphanumeric(c) || c == '_'; }

void skip_comments(std::string_view& text) {
  for (skip_blanks(text); text.starts_with('#'); skip_blanks(text)) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

bool skip_prompt(std::string_view& text) {
  constexpr std::array<std::string_view, 3> prompts = {"gap>", "sage:", ">>>"};
  for (const std::string_view prompt : prompts) {
    if (text.starts_with(prompt)) {
      text.remove_prefix(prompt.size());
      skip_blanks(text);
      return true;
    }
  }
  return false;
}

bool skip_assignment(std::string_view& text) {
  const auto end = std::ranges::find_if_not(text, is_of_name);
  std::string_view rest = text.substr(static_cast<std::size_t>(end - text.begin()));
  if (rest.size() == text.size()) {
    return false;
  }
  skip_blanks(rest);
  for (const std::string_view sign : {":=", "="}) {
    if (rest.starts_with(sign)) {
      rest.remove_prefix(sign.size());
      skip_blanks(rest);
      text = rest;
      return true;
    }
  }
  return false;
}

}  // namespace changeover
