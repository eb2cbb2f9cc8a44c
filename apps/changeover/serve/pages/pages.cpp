#include "serve/pages/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "core/printable.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

// The file of that path below a folder: by names only, without links, and never out of it.
std::optional<fs::path> file_at(const fs::path& folder, std::string_view path) {
  fs::path at = folder;
  for (;;) {
    const std::size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    if (name.empty() || name == "." || name == "..") {
      return std::nullopt;
    }
    at /= name;
    std::error_code ignored;
    const fs::file_type type = fs::symlink_status(at, ignored).type();
    if (slash == std::string_view::npos) {
      return type == fs::file_type::regular ? std::optional(at) : std::nullopt;
    }
    if (type != fs::file_type::directory) {
      return std::nullopt;
    }
    path.remove_prefix(slash + 1);
  }
}

Response page_response(std::string bytes, std::string_view type) {
  const bool is_page = type.starts_with("text/html");
  std::string policy = is_page ? content_policy(bytes) + "; frame-ancestors 'none'" : "";
  Response response = text_response(std::move(bytes), std::string(type));
  if (is_page) {
    response.headers.emplace_back("Content-Security-Policy", std::move(policy));
  }
  return response;
}

}  // namespace

std::string_view type_of_page(std::string_view path) {
  using Type = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Type, 10> types{{{".html", "text/html; charset=utf-8"},
                                               {".js", "text/javascript; charset=utf-8"},
                                               {".css", "text/css; charset=utf-8"},
                                               {".svg", "image/svg+xml"},
                                               {".png", "image/png"},
                                               {".ico", "image/x-icon"},
                                               {".json", "application/json; charset=utf-8"},
                                               {".webmanifest", "application/manifest+json"},
                                               {".woff2", "font/woff2"},
                                               {".txt", "text/plain; charset=utf-8"}}};
  const auto* const found =
      std::ranges::find_if(types, [&](const Type& type) { return path.ends_with(type.first); });
  return found == types.end() ? std::string_view() : found->second;
}

Pages::Pages(std::string folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder_, ignored)) {
      throw MissingResource(fmt::format(
          "--assets {}: there is no such folder; name that of the pages", printable(folder_)));
    }
    return;
  }
  for (const EmbeddedPage& page : embedded_pages()) {
    if (const std::string_view type = type_of_page(page.path); !type.empty()) {
      embedded_[std::string(page.path)] = page_response(std::string(page.bytes), type);
    }
  }
}

std::optional<Response> Pages::find(const std::string& path) const {
  const std::string wanted = path.empty() ? "index.html" : path;
  if (folder_.empty()) {
    const auto found = embedded_.find(wanted);
    return found == embedded_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::string_view type = type_of_page(wanted);
  const auto file = type.empty() ? std::nullopt : file_at(folder_, wanted);
  if (!file) {
    return std::nullopt;
  }
  constexpr std::size_t largest_page = std::size_t{64} << 20;
  const auto input = open_input(file->string());
  return page_response(read_to_end(*input, largest_page, "it is not a page"), type);
}

std::vector<std::string> Pages::paths() const {
  std::vector<std::string> all;
  if (folder_.empty()) {
    for (const auto& [path, page] : embedded_) {
      all.push_back(path);
    }
    return all;
  }
  constexpr std::size_t most_files = 10'000;
  std::error_code fault;
  for (auto at = fs::recursive_directory_iterator(folder_, fault);
       !fault && at != fs::recursive_directory_iterator(); at.increment(fault)) {
    const std::string path = at->path().lexically_relative(folder_).generic_string();
    if (!type_of_page(path).empty() && file_at(folder_, path)) {
      all.push_back(path);
    }
    if (all.size() > most_files) {
      throw MissingResource(fmt::format(
          "--assets {}: there are more than {} files; name the folder of the pages alone",
          printable(folder_), most_files));
    }
  }
  return all;
}

}  // namespace changeover::serve
