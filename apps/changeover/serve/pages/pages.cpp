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

// The files of a folder by their paths in it; links are left out.
std::map<std::string, std::filesystem::path> files_of(const std::string& folder) {
  std::map<std::string, std::filesystem::path> files;
  std::error_code fault;
  for (auto at = std::filesystem::recursive_directory_iterator(folder, fault);
       !fault && at != std::filesystem::recursive_directory_iterator(); at.increment(fault)) {
    if (at->symlink_status(fault).type() == std::filesystem::file_type::regular) {
      files[at->path().lexically_relative(folder).generic_string()] = at->path();
    }
  }
  return files;
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
      throw MissingResource(
          fmt::format("--assets {}: there is no such folder", printable(folder_)));
    }
    return;
  }
  for (const EmbeddedPage& page : embedded_pages()) {
    if (const std::string_view type = type_of_page(page.path); !type.empty()) {
      embedded_[std::string(page.path)] = text_response(std::string(page.bytes), std::string(type));
    }
  }
}

std::optional<Response> Pages::find(const std::string& path) const {
  const std::string wanted = path.empty() ? "index.html" : path;
  if (folder_.empty()) {
    const auto found = embedded_.find(wanted);
    return found == embedded_.end() ? std::nullopt : std::optional(found->second);
  }
  const auto files = files_of(folder_);
  const auto found = files.find(wanted);
  const std::string_view type = type_of_page(wanted);
  if (found == files.end() || type.empty()) {
    return std::nullopt;
  }
  constexpr std::size_t largest_page = std::size_t{64} << 20;
  const auto input = open_input(found->second.string());
  return text_response(read_to_end(*input, largest_page, "it is no page"), std::string(type));
}

std::vector<std::string> Pages::paths() const {
  std::vector<std::string> all;
  if (folder_.empty()) {
    for (const auto& [path, page] : embedded_) {
      all.push_back(path);
    }
  } else {
    for (const auto& [path, file] : files_of(folder_)) {
      if (!type_of_page(path).empty()) {
        all.push_back(path);
      }
    }
  }
  return all;
}

}  // namespace changeover::serve
