// Costs as people write them in lists.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// Costs of one list: with a point, or between semicolons or tabs with a comma, but not with both.
/// A sign of a currency or a unit of time may stand beside the number, the same beside all that
/// have one: "12.50 €", "15 min"; or all are times on a clock, "0:15", which are minutes.
class CostReader {
 public:
  explicit CostReader(const RowReader& reader) : reader_(&reader) {}

  /// Whether a field is meant as one.
  [[nodiscard]] static bool is_like_a_cost(std::string_view text);

  /// @throws BadInput with the place of the field.
  [[nodiscard]] Amount read(const Field& field);

  /// What the costs that were read are, if they say so themselves.
  [[nodiscard]] CostUnit unit() const { return unit_; }

 private:
  [[nodiscard]] Amount number(const Field& field, std::string text);
  [[nodiscard]] std::optional<Amount> on_clock(const Field& field, std::string_view text);
  [[nodiscard]] std::string without_sign(const Field& field);

  const RowReader* reader_;
  bool commas_ = false;
  bool points_ = false;
  bool numbers_ = false;
  bool clocks_ = false;
  std::string sign_;  // beside the numbers
  CostUnit unit_ = CostUnit::none;
};

}  // namespace changeover
