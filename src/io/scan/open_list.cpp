// A list is a file, or one sheet of a workbook.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "changeover/io/input.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {
namespace {

// Where "parts.xlsx:Costs" splits into a file and a sheet: at the last colon (names of sheets have
// none), if there is no file of the whole name, but one of the name before the colon.
std::optional<std::size_t> end_of_file(const std::string& path) {
  std::error_code ignored;
  const std::size_t colon = path.rfind(':');
  const bool splits = colon != std::string::npos && colon > 0 && colon + 1 < path.size() &&
                      !std::filesystem::exists(path, ignored) &&
                      std::filesystem::exists(path.substr(0, colon), ignored);
  return splits ? std::optional(colon) : std::nullopt;
}

}  // namespace

std::string list_file(const std::string& path) {
  return path.substr(0, end_of_file(path).value_or(path.size()));
}

std::unique_ptr<Input> open_list(const std::string& path) {
  const auto colon = end_of_file(path);
  return colon ? std::make_unique<SheetInput>(open_input(path.substr(0, *colon)),
                                              path.substr(*colon + 1))
               : open_input(path);
}

}  // namespace changeover
