#include "changeover/search/exact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "changeover/core/error.hpp"
#include "oracle_minima.hpp"

namespace changeover::minima_table_test {
namespace {

using testing::HasSubstr;

const MinimaRange small{.k_from = 2, .k_to = 4, .v_to = 9};

std::vector<MinimaRow> filled(std::vector<MinimaRow> rows, const MinimaRange& range,
                              std::size_t* calls = nullptr) {
  RunControl control({});
  MinimumOptions options;
  options.exact.conflicts_per_step = 20'000;
  fill_minima(range, rows, options, control, [&](const MinimaRow&) {
    if (calls != nullptr) {
      ++*calls;
    }
  });
  return rows;
}

std::string as_csv(const std::vector<MinimaRow>& rows) {
  StringSink sink;
  write_minima(rows, sink);
  return sink.text();
}

TEST(MinimaTable, AgreesWithTheKnownMinima) {
  const std::vector<MinimaRow> rows = filled({}, small);
  std::map<Parameters, const MinimaRow*> by_parameters;
  for (const MinimaRow& row : rows) {
    by_parameters[row.parameters] = &row;
    EXPECT_LE(row.start, row.lower);
    EXPECT_TRUE(!row.upper || row.lower <= *row.upper);
    EXPECT_EQ(row.proof_steps > 0, row.lower > row.start) << name(row.parameters);
  }
  std::size_t met = 0;
  for (const auto& [p, b] : test::oracle_minima()) {
    const auto row = by_parameters.find(p);
    if (row != by_parameters.end()) {
      ++met;
      EXPECT_EQ(row->second->lower, b) << name(p);
      EXPECT_EQ(row->second->upper, b) << name(p);
    }
  }
  EXPECT_GT(met, 50U);
}

TEST(MinimaTable, GoesOnWhereItWasStopped) {
  const std::vector<MinimaRow> rows = filled({}, {.k_from = 3, .k_to = 4, .v_to = 8});
  std::size_t calls = 0;
  EXPECT_EQ(filled(rows, {.k_from = 3, .k_to = 4, .v_to = 8}, &calls), rows);
  EXPECT_EQ(calls, 0U);
  std::vector<MinimaRow> fewer(rows.begin() + 3, rows.end());
  EXPECT_EQ(filled(fewer, {.k_from = 3, .k_to = 4, .v_to = 8}, &calls).size(), rows.size());
  EXPECT_EQ(calls, 3U);
}

TEST(MinimaTable, IsReadAsItWasWritten) {
  const std::string text = as_csv(filled({}, small));
  const auto input = input_from_text(text);
  EXPECT_EQ(as_csv(read_minima(*input)), text);
}

TEST(MinimaTable, RefusesRowsThatAreNone) {
  const auto refusal = [](const std::string& text) {
    try {
      (void)read_minima(*input_from_text(text, "a.csv"));
    } catch (const BadInput& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  const std::string head = as_csv({});
  EXPECT_THAT(refusal("v,k\n"), HasSubstr("a.csv:1: the first line is not"));
  EXPECT_THAT(refusal(head + "2,1\n"), HasSubstr("a.csv:2: the row is too short"));
  EXPECT_THAT(refusal(head + "2,1,oval,4,9,1,1,1,x,0,0,0,0,0,0\n"), HasSubstr("the kind must be"));
  EXPECT_THAT(refusal(head + "2,1,linear,4,9,1,1,1,x,0,0,0,0,0,0,7\n"), HasSubstr("too long"));
  EXPECT_THAT(refusal(head + "2,1,linear,4,9x,1,1,1,x,0,0,0,0,0,0\n"), HasSubstr("'9x'"));
  const std::string good = "2,1,linear,4,9,11,12,13,cut,0.50,0,0,0,0,0\n";
  EXPECT_EQ(refusal(head + good), "");
  EXPECT_EQ(refusal(""), "");
  std::string quoted = good;
  quoted.replace(quoted.find("cut"), 3, "\"cut, \"\"twice\"\"\"");
  const auto rows = read_minima(*input_from_text(head + quoted));
  EXPECT_EQ(rows.at(0).by, "cut, \"twice\"");
  EXPECT_EQ(read_minima(*input_from_text(as_csv(rows))), rows);
  EXPECT_THAT(refusal(head + good + good), HasSubstr("a.csv:3: linear SCCD(9,4) occurs twice"));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"9,11,12", "3,11,12"},
                                                        {"11,12", "12,11"},
                                                        {"12,13", "14,13"},
                                                        {"0.50", "nan"},
                                                        {"0.50", "inf"},
                                                        {"0.50", "-1"},
                                                        {"cut", "\x1b[2J"}}) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_THAT(refusal(head + bad), HasSubstr("a.csv:2:")) << bad;
  }
}

TEST(MinimaTable, IsWrittenAsTables) {
  const std::string text = minima_markdown(
      {{.parameters = {.v = 9, .k = 4, .change = 1},
        .start = 11,
        .lower = 12,
        .upper = 12,
        .by = "cut",
        .solve_seconds = 0.02,
        .proof_bytes = 18044,
        .proof_steps = 1442},
       {.parameters = {.v = 10, .k = 4, .change = 1}, .start = 14, .lower = 14, .upper = 15}});
  EXPECT_THAT(text, HasSubstr("### linear single-change covering designs\n"));
  EXPECT_THAT(text, HasSubstr("| 9 | 12 p |\n| 10 | 14..15 |\n"));
  EXPECT_THAT(text, HasSubstr("| linear SCCD(9,4) | 11 | 12 | cut | 0.02 | 0.00 | 18044 | 1442 |"));
  EXPECT_THAT(text, HasSubstr("## Open"));
}

}  // namespace
}  // namespace changeover::minima_table_test
