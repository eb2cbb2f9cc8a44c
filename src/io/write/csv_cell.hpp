// Cells of CSV that a spreadsheet shows and never computes.
//
//     csv_cell("B-12")         // B-12
//     csv_cell("say \"when\"") // "say ""when""", in quotes
//     csv_cell("=1+1")         // '=1+1
//     csv_cell("-1.5")         // -1.5: a number stays one
//     csv_text("'=1+1")        // =1+1
//
// A spreadsheet takes a cell for a formula if it begins with = + - @ or with some control
// characters, and quotes do not help: a name from an untrusted file could then compute, or fetch,
// something. Such a text gets an apostrophe in front, the spreadsheets' own mark for "this is
// text". To make this reversible, a text of one or more apostrophes before such a beginning gets
// one more; any other text with an apostrophe in front, and every decimal number, stays as it is.
// For every text, csv_text() of the cell without its quotes is the text again.
//
// Not done: a spreadsheet takes a name that looks like a number (007, 1e5) for one.
#pragma once

#include <string>
#include <string_view>

namespace changeover {

/// A text as one cell: the apostrophe where it must be, and quotes if there is a comma, a
/// semicolon, a quote or a control character in it, or a blank at an end.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// The text of a cell without its quotes: removes the apostrophe of csv_cell().
[[nodiscard]] std::string_view csv_text(std::string_view cell);

}  // namespace changeover
