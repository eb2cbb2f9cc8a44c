// The counts of all designs, as catalog/classified.txt has them.
#include <algorithm>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "core/lines.hpp"
#include "core/parsed.hpp"

namespace changeover {

std::string_view classified_text();  // made of the file by the build

namespace {

Classified counted(std::string_view line) {
  const auto word = [&line] {
    const std::string_view first = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(first.size() + 1, line.size()));
    return first;
  };
  const auto number = [&word] { return parsed<std::uint64_t>(word()).value_or(0); };
  Classified cell;
  cell.parameters = {.v = number(), .k = number(), .change = number()};
  cell.parameters.kind = word() == "circular" ? Kind::circular : Kind::linear;
  for (std::uint64_t* each : {&cell.b, &cell.standard_forms, &cell.classes, &cell.tight}) {
    *each = number();
  }
  cell.groups = line;
  return cell;
}

}  // namespace

std::span<const Classified> classified_cells() {
  static const std::vector<Classified> cells = [] {
    std::vector<Classified> all;
    for (Lines lines(classified_text()); lines.next();) {
      if (!lines.line().starts_with('#')) {
        all.push_back(counted(lines.line()));
      }
    }
    return all;
  }();
  return cells;
}

std::optional<Classified> classified(const Parameters& p, std::uint64_t b) {
  for (const Classified& each : classified_cells()) {
    if (each.parameters == p && each.b == b) {
      return each;
    }
  }
  return std::nullopt;
}

}  // namespace changeover
