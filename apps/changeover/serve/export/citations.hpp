// BibTeX of the designs of a site: what designs of the same sources have in common is written once.
//
//     CitationForms forms;
//     forms.number(entry, cli::bibtex_of(entry));   // 0: "@misc{changeover-<label>,\n  author…"
//     forms.json();                                 // ["@misc{changeover-<label>,…",…]
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "changeover/catalog/entry.hpp"

namespace changeover::serve {

class CitationForms {
 public:
  /// The number of the form, from 0, that is this text when <label>, <hash>, <kind>, <v>, <k> and
  /// <b> are filled with what the entry says. @throws InternalError if there is no such form
  std::size_t number(const CatalogEntry& entry, const std::string& text);

  /// All forms in their order.
  [[nodiscard]] std::string json() const;

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> forms_;
};

}  // namespace changeover::serve
