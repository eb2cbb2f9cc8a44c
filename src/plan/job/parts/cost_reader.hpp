// Reads costs as people write them in lists.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// The costs of one list: with a decimal point or (between semicolons or tabs) a decimal comma, but
/// not both. A currency or a unit of time may stand beside the number, the same for all costs that
/// have one: "12.50 €", "15 min". Or all are clock times, "0:15", which are minutes.
class CostReader {
 public:
  explicit CostReader(const RowReader& reader) : reader_(&reader) {}

  /// Whether a field looks like a cost.
  [[nodiscard]] static bool is_like_a_cost(std::string_view text);

  /// @throws BadInput with the place of the field.
  [[nodiscard]] Amount read(const Field& field);

  /// The unit of the costs so far, if they have one.
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
  std::string sign_;  // the sign beside the numbers
  CostUnit unit_ = CostUnit::none;
};

}  // namespace changeover
