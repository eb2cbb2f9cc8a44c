// What the cells of a workbook say, as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// A number as a spreadsheet shows it in full: at most 15 digits that count, never with an exponent
/// below 10¹⁵.
[[nodiscard]] std::string number_text(double number);

/// How a number is shown.
enum class NumberStyle : std::uint8_t { number, date };

/// What a number format such as `yyyy-mm-dd` makes of a number. Hours of any length, as [h]:mm,
/// stay numbers.
[[nodiscard]] NumberStyle style_of_format(std::string_view format);
/// The same of a format that spreadsheets know by its number.
[[nodiscard]] NumberStyle style_of_built_in(std::uint64_t format);

/// A day number as 2024-05-01, with a time 2024-05-01 13:30:00, or 13:30:00 alone below one day;
/// the number itself where no calendar has such a day.
[[nodiscard]] std::string date_text(double days, bool from_1904);

/// _x000D_ and the like are characters that XML cannot hold.
[[nodiscard]] std::string without_escapes(std::string_view text);
/// So that a text that looks like one is read as it is: its _ becomes _x005F_.
[[nodiscard]] std::string with_escapes(std::string_view text);

/// The text on one line: blanks for line ends and tabs.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// "B3" for column 1 and row 3.
[[nodiscard]] std::string cell_name(std::uint64_t column, std::uint64_t row);

/// Column and row of "B3": {1, 3}; nothing for another word.
struct CellPlace {
  std::uint64_t column = 0;
  std::uint64_t row = 0;

  bool operator==(const CellPlace&) const = default;
};
[[nodiscard]] std::optional<CellPlace> cell_place(std::string_view name);

inline constexpr std::uint64_t most_sheet_rows = 1'048'576;
inline constexpr std::uint64_t most_sheet_columns = 16'384;

}  // namespace changeover
