// Manual pages, made of what the program knows of its verbs.
//
//     for (const ManualPage& page : manual_pages(program)) {
//       page.name;                                 // "changeover-catalog-show": section 1
//     }
#pragma once

#include <string>
#include <vector>

#include "cli/cli.hpp"

namespace changeover::cli {

struct ManualPage {
  std::string name;  ///< "changeover", "changeover-design", …
  std::string text;  ///< roff with the macros of man(7)
};

/// The program's own page, one for each group and one for each verb.
[[nodiscard]] std::vector<ManualPage> manual_pages(const Program& program);

}  // namespace changeover::cli
