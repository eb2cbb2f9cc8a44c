// What a dossier says, in one order for all of its forms.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "answer/dossier/dossier.hpp"

namespace changeover::cli {

/// What every form says, in this order; each form says how.
class Form {
 public:
  virtual ~Form() = default;
  virtual void heading(const std::string& words) = 0;
  virtual void paragraph(const std::string& words) = 0;
  /// `depth` is that of a list within lists.
  virtual void item(std::size_t depth, const std::string& words) = 0;
  virtual void end_of_items() = 0;
  virtual void code(const std::string& lines) = 0;
  virtual void facts(const std::vector<DossierFact>& rows) = 0;
  /// Statements of the program's theorems that were cited; some forms only cite them.
  virtual void theorems(const Dossier& dossier) = 0;
  virtual void blocks(const Dossier& dossier) = 0;
  virtual void picture(const Dossier& dossier) = 0;
  virtual void references(const Dossier& dossier) = 0;
};

/// Says all of it.
void write(const Dossier& dossier, Form& form);

[[nodiscard]] std::string title_of(const Dossier& dossier);

/// The blocks, one a line.
[[nodiscard]] std::string lines_of(const Design& design);

/// The keys of the works, and that of the program's theorems if it is cited.
[[nodiscard]] std::vector<std::string> all_keys(const Dossier& dossier);

}  // namespace changeover::cli
