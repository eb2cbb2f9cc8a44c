#include "serve/export/citations.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::serve {
namespace {

std::string with(std::string text, const std::string& old, std::string_view wanted) {
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + wanted.size())) {
    text.replace(at, old.size(), wanted);
  }
  return text;
}

// The words that say which design it is, in the order in which they are looked for.
std::vector<std::pair<std::string, std::string>> words_of(const CatalogEntry& entry) {
  const Parameters& p = entry.parameters;
  const std::string kind(to_string(p.kind));
  return {{entry.label(), "<label>"},
          {to_hex(entry.checksum), "<hash>"},
          {fmt::format("{{{} ", kind), "{<kind> "},
          {fmt::format("({},{})", p.v, p.k), "(<v>,<k>)"},
          {fmt::format(" with {} block", entry.b), " with <b> block"}};
}

}  // namespace

std::size_t CitationForms::number(const CatalogEntry& entry, const std::string& text) {
  std::string form = text;
  std::string filled;
  for (const auto& [words, open] : words_of(entry)) {
    form = with(std::move(form), words, open);
  }
  filled = form;
  for (const auto& [words, open] : words_of(entry)) {
    filled = with(std::move(filled), open, words);
  }
  if (filled != text) {
    throw InternalError(entry.label() + ": its citation has no form that is filled with its words");
  }
  const auto [found, is_new] = numbers_.try_emplace(form, forms_.size());
  if (is_new) {
    forms_.push_back(std::move(form));
  }
  return found->second;
}

std::string CitationForms::json() const {
  JsonWriter json;
  json.begin_array();
  for (const std::string& form : forms_) {
    json.value(form);
  }
  return json.end_array().take();
}

}  // namespace changeover::serve
