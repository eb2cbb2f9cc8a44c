#include "io/workbook/cell_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "damage.hpp"

namespace changeover::cell_text_test {
namespace {

TEST(CellText, NumbersAreWhatPeopleSee) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(12), "12");
  EXPECT_EQ(number_text(12.5), "12.5");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(number_text(-7.25), "-7.25");
  EXPECT_EQ(number_text(0.000001), "0.000001");
  EXPECT_EQ(number_text(4006381333931.0), "4006381333931");
  EXPECT_EQ(number_text(1e15), "1000000000000000");
  EXPECT_EQ(number_text(1e18), "1000000000000000000");
}

TEST(CellText, FormatsOfDates) {
  for (const char* format : {"yyyy-mm-dd", "d/m/yy", "h:mm AM/PM", "[$-409]d mmm yyyy",
                             "\"on\" dddd", "mm:ss.0", "[Red]yyyy"}) {
    EXPECT_EQ(style_of_format(format), NumberStyle::date) << format;
  }
  for (const char* format :
       {"General", "0.00", "#,##0.00 \"EUR/month\"", "@", "0.00E+00", "[h]:mm", "# ?/?", "0\\d",
        "#,##0_m", "[Red]-0", "[$USD-409] 0.00", "0;yyyy", "", "\"", "[", "\\"}) {
    EXPECT_EQ(style_of_format(format), NumberStyle::number) << format;
  }
  EXPECT_EQ(style_of_built_in(14), NumberStyle::date);
  EXPECT_EQ(style_of_built_in(22), NumberStyle::date);
  EXPECT_EQ(style_of_built_in(46), NumberStyle::number);
  EXPECT_EQ(style_of_built_in(4), NumberStyle::number);
}

TEST(CellText, Dates) {
  EXPECT_EQ(date_text(1, false), "1900-01-01");
  EXPECT_EQ(date_text(59, false), "1900-02-28");
  EXPECT_EQ(date_text(60, false), "1900-02-29");  // as spreadsheets count
  EXPECT_EQ(date_text(61, false), "1900-03-01");
  EXPECT_EQ(date_text(45413, false), "2024-05-01");
  EXPECT_EQ(date_text(45413.5625, false), "2024-05-01 13:30:00");
  EXPECT_EQ(date_text(0.5, false), "12:00:00");
  EXPECT_EQ(date_text(43951, true), "2024-05-01");
  EXPECT_EQ(date_text(0, true), "1904-01-01");
  EXPECT_EQ(date_text(2958465, false), "9999-12-31");
  EXPECT_EQ(date_text(2958466, false), "2958466");
  EXPECT_EQ(date_text(-1, false), "-1");
}

TEST(CellText, Escapes) {
  EXPECT_EQ(without_escapes("a_x000D_b"), "a\rb");
  EXPECT_EQ(without_escapes("_x005F_x000D_"), "_x000D_");
  EXPECT_EQ(without_escapes("_x221E__x00e9_"), "\u221e\u00e9");
  for (const char* text : {"_x", "_x000D", "_xD800_", "_x00G0_", "_x 0D_", "a_x00", "_X000D_"}) {
    EXPECT_EQ(without_escapes(text), text);
  }
  EXPECT_EQ(with_escapes("_x0041__x_"), "_x005F_x0041__x_");
  EXPECT_EQ(on_one_line("a\r\n\tb\nc"), "a b c");
}

RC_GTEST_PROP(CellText, WhatLooksLikeAnEscapeComesBack, ()) {
  const std::string text =
      test::some_text({"_", "x", "_x", "0041", "005F", "D800", "_x000a_", "a"}, 9);
  RC_ASSERT(without_escapes(with_escapes(text)) == text);
}

TEST(CellText, NamesOfCells) {
  EXPECT_EQ(cell_name(0, 1), "A1");
  EXPECT_EQ(cell_name(25, 3), "Z3");
  EXPECT_EQ(cell_name(26, 3), "AA3");
  EXPECT_EQ(cell_name(16'383, 1'048'576), "XFD1048576");
  for (std::uint64_t column = 0; column < most_sheet_columns; ++column) {
    EXPECT_EQ(cell_place(cell_name(column, 7)), (CellPlace{column, 7}));
  }
  for (const char* word :
       {"", "A", "7", "A0", "a1", "XFE1", "A1048577", "A1B", "A-1", "AAAAAAAAAAAAAAAAAAAA1"}) {
    EXPECT_FALSE(cell_place(word)) << word;
  }
}

}  // namespace
}  // namespace changeover::cell_text_test
