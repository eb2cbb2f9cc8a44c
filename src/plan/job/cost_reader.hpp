// Costs as people write them in lists.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// Costs of one list: with a point, or between semicolons or tabs with a comma, but not with both.
class CostReader {
 public:
  explicit CostReader(const RowReader& reader) : reader_(&reader) {}

  Amount read(const Field& field) {
    std::string text = field.text;
    const bool comma = reader_->separator() != ',' &&
                       std::count(text.begin(), text.end(), ',') == 1 &&
                       text.find('.') == std::string::npos;
    if (comma) {
      const std::size_t at = text.find(',');
      constexpr std::size_t of_thousands = 3;
      if (text.size() - at - 1 == of_thousands && at >= 1 && at <= of_thousands && text[0] != '0') {
        reader_->fail(field, fmt::format("{} may be thousands or a fraction; write {}{} or {}.{}0",
                                         shown(text), text.substr(0, at), text.substr(at + 1),
                                         text.substr(0, at), text.substr(at + 1)));
      }
      text[at] = '.';
    }
    const bool point = !comma && text.find('.') != std::string::npos;
    // A number in a workbook has no sign of its own.
    if (!reader_->is_workbook() && ((comma && points_) || (point && commas_))) {
      reader_->fail(field, "some costs have a decimal comma and some a point; use one of them");
    }
    commas_ = commas_ || comma;
    points_ = points_ || point;
    try {
      return parse_amount(text);
    } catch (const Error& fault) {
      reader_->fail(
          field, comma ? fmt::format("{} is not a cost; write it as 12 or 12,50", shown(field.text))
                       : std::string(fault.what()));
    }
  }

 private:
  const RowReader* reader_;
  bool commas_ = false;
  bool points_ = false;
};

}  // namespace changeover
