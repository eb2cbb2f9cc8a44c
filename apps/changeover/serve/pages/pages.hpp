// The files of the pages: in the program, or from a folder while they are being worked on.
//
//     const Pages pages("");                       // those in the program
//     pages.find("assets/app.js");
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "serve/http/message.hpp"

namespace changeover::serve {

struct EmbeddedPage {
  std::string_view path;
  std::string_view bytes;
};

/// What web/dist had when the program was built; generated.
[[nodiscard]] std::vector<EmbeddedPage> embedded_pages();

class Pages {
 public:
  /// `folder` is empty for those in the program. @throws MissingResource if it is no folder.
  explicit Pages(std::string folder);

  /// The file of exactly that path, "" for index.html; nothing if there is none. No path leads out
  /// of the folder: those that there are, are listed, and links are not followed.
  [[nodiscard]] std::optional<Response> find(const std::string& path) const;

  /// All paths.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  std::string folder_;
  std::map<std::string, Response> embedded_;
};

/// "text/css; charset=utf-8" for a path that ends in .css, and so on; empty for what is no part of
/// a page.
[[nodiscard]] std::string_view type_of_page(std::string_view path);

}  // namespace changeover::serve
