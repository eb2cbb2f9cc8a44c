#include "serve/export/own_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/core/version.hpp"
#include "changeover/io/input.hpp"
#include "changeover/run/control.hpp"
#include "core/printable.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t checksum_digits = 64;
constexpr std::size_t before_name = checksum_digits + 2;
constexpr std::size_t longest_list = std::size_t{256} << 20;

// As often as the scope wants to know: a file of others may have any size.
std::string checksum_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw MissingResource(fmt::format("cannot read {}; allow reading it, or export to a new folder",
                                      printable(path.string())));
  }
  Sha256 hash;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) ||
         file.gcount() > 0) {
    stop_if_asked();
    hash.add(std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
  }
  return to_hex(hash.finish());
}

std::string text_at(const fs::path& path) {
  return read_to_end(*open_input(path.string()), longest_list, "no export wrote it");
}

// Its lines, each with its end.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

// The names that an export announced there; none if it was not killed.
std::set<std::string> announced_in(const fs::path& folder) {
  std::set<std::string> names;
  if (is_file(folder / unfinished_name)) {
    const std::string text = text_at(folder / unfinished_name);
    for (const std::string_view line : lines_of(text)) {
      names.emplace(line.substr(0, line.find('\n')));
    }
  }
  return names;
}

std::set<std::string> folders_above(const std::set<std::string>& names) {
  std::set<std::string> folders;
  for (const std::string& name : names) {
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
      folders.insert(name.substr(0, slash));
    }
  }
  return folders;
}

std::set<std::string> names_of(const OwnFiles::List& list) {
  std::set<std::string> names;
  for (const auto& [name, checksum] : list) {
    names.insert(name);
  }
  return names;
}

// The file and the checksum of a line; nothing for a line that no export wrote.
std::optional<std::pair<std::string, std::string>> listed_in(std::string_view line) {
  if (line.size() <= before_name || line.back() != '\n' ||
      line.substr(checksum_digits, 2) != "  " ||
      line.find_first_not_of("0123456789abcdef") != checksum_digits) {
    return std::nullopt;
  }
  line.remove_suffix(1);
  std::string name(line.substr(before_name));
  return can_be_listed(name)
             ? std::optional(std::pair(std::move(name), std::string(line, 0, checksum_digits)))
             : std::nullopt;
}

}  // namespace

bool is_file(const std::filesystem::path& path) {
  std::error_code none;
  return fs::is_regular_file(fs::symlink_status(path, none));
}

bool can_be_listed(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && name.find('\n') == std::string::npos && path.is_relative() &&
         path.has_filename() && path.lexically_normal() == path &&
         std::ranges::none_of(path, [](const fs::path& part) { return part == ".."; });
}

bool stays_below(const fs::path& folder, const std::string& name) {
  std::error_code none;
  return can_be_listed(name) && std::ranges::all_of(folders_above({name}), [&](const auto& at) {
           return fs::is_directory(fs::symlink_status(folder / at, none));
         });
}

OwnFiles OwnFiles::of(const fs::path& folder) {
  List list;
  if (!is_file(folder / list_name)) {
    return {folder, list};
  }
  const std::string text = text_at(folder / list_name);
  const std::vector<std::string_view> lines = lines_of(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {  // the first: about the program
    auto file = listed_in(lines[i]);
    // An export writes them in order.
    if (!file || (!list.empty() && file->first <= list.rbegin()->first)) {
      throw MissingResource(
          fmt::format("{}:{}: no export wrote this line, so its files are not known by their list; "
                      "export to a new folder",
                      printable((folder / list_name).string()), i + 1));
    }
    list.insert(std::move(*file));
  }
  return {folder, std::move(list)};
}

std::string OwnFiles::text_of(const List& list) {
  std::string text = fmt::format("changeover {}\n", version);
  for (const auto& [name, checksum] : list) {
    text += fmt::format("{}  {}\n", checksum, name);
  }
  return text;
}

std::optional<std::string> OwnFiles::what_else() const {
  std::set<std::string> own = names_of(list_);
  own.insert(list_name);
  const std::set<std::string> folders = folders_above(own);
  std::error_code fault;
  fs::recursive_directory_iterator at(folder_, fault);
  std::string last = ".";
  for (; !fault && at != fs::recursive_directory_iterator(); at.increment(fault)) {
    stop_if_asked();
    const std::string name = last = at->path().lexically_relative(folder_).string();
    const fs::file_status status = at->symlink_status(fault);
    if (fs::is_directory(status)) {
      if (!folders.contains(name)) {
        return name + " is";
      }
      continue;
    }
    const bool is_mark = name == list_name || name == unfinished_name;
    if (!fs::is_regular_file(status) || (!is_mark && !list_.contains(name))) {
      return name + " is";
    }
    if ((name == unfinished_name && !std::ranges::includes(own, announced_in(folder_))) ||
        (!is_mark && checksum_of(at->path()) != list_.at(name))) {
      return name + " was changed and is";
    }
  }
  if (fault) {
    throw MissingResource(
        fmt::format("cannot read {}: {}; allow reading there, or export to a new folder",
                    printable((folder_ / last).lexically_normal().string()), fault.message()));
  }
  return std::nullopt;
}

bool OwnFiles::remove() const noexcept try {
  // Files are removed even if the export was stopped.
  RunControl unlimited{RunControl::Settings()};
  const RunScope scope(unlimited);
  std::error_code ignored;
  const std::set<std::string> announced = announced_in(folder_);
  std::set<std::string> names = names_of(list_);
  names.insert(announced.begin(), announced.end());
  for (const std::string& name : names) {
    if (stays_below(folder_, name) && is_file(folder_ / name) && name != list_name &&
        name != unfinished_name &&
        (announced.contains(name) || checksum_of(folder_ / name) == list_.at(name))) {
      fs::remove(folder_ / name, ignored);
    }
  }
  const std::set<std::string> folders = folders_above(names);
  // The innermost first: a folder sorts before what is in it.
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    if (stays_below(folder_, *folder)) {
      ::rmdir((folder_ / *folder).c_str());
    }
  }
  for (fs::directory_iterator at(folder_, ignored), end; !ignored && at != end;
       at.increment(ignored)) {
    const fs::path name = at->path().filename();
    if (name != list_name && name != unfinished_name) {
      return false;
    }
  }
  fs::remove(folder_ / list_name, ignored);
  fs::remove(folder_ / unfinished_name, ignored);
  return ::rmdir(folder_.c_str()) == 0;
} catch (const std::exception&) {
  return false;
}

}  // namespace changeover::serve
