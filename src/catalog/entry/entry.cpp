#include "changeover/catalog/entry.hpp"

namespace changeover {

std::string CatalogEntry::label() const { return design_label(parameters, b, checksum); }

std::string_view CatalogEntry::status() const {
  if (!retracted.empty()) {
    return "retracted";
  }
  return b == lower_bound ? "minimum" : "best-known";
}

bool CatalogEntry::carries_blocks() const {
  return recipe.construction == "literal" || recipe.construction == "developed";
}

}  // namespace changeover
