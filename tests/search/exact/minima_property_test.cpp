// Tables of minima at random: read as they were written; damaged, a table or one line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>

#include "changeover/search/exact.hpp"
#include "damage.hpp"

namespace changeover::minima_property_test {
namespace {

using test::some_number;

// Hundredths of a second, which is what a table says.
double some_seconds() { return static_cast<double>(some_number(1'000'000)) / 100; }

std::vector<MinimaRow> some_rows() {
  std::map<std::array<std::uint64_t, 5>, MinimaRow> rows;  // in the order of a table
  for (std::uint64_t count = some_number(25); count > 0; --count) {
    MinimaRow row;
    Parameters& p = row.parameters;
    p.k = 2 + some_number(3);
    p.v = p.k + some_number(5);
    p.change = 1 + some_number(p.k - 1);
    p.kind = some_number(1) == 0 ? Kind::linear : Kind::circular;
    p.strength = p.k > 3 && some_number(2) == 0 ? 3 : 2;
    row.start = 1 + some_number(20);
    row.lower = row.start + some_number(2);
    if (some_number(4) > 0) {
      row.upper = row.lower + some_number(2);
      row.by = *rc::gen::element<std::string>("SAT", "cut", "cyclic-paper");
    }
    row.seconds = some_seconds();
    row.solve_seconds = some_seconds();
    row.check_seconds = some_seconds();
    row.proof_bytes = some_number(1'000'000'000'000);
    row.proof_steps = some_number(1'000'000'000);
    row.limit = some_number(1'000'000);
    rows.insert({{p.strength, p.change, p.kind == Kind::linear ? 0U : 1U, p.k, p.v}, row});
  }
  std::vector<MinimaRow> list;
  for (const auto& [place, row] : rows) {
    list.push_back(row);
  }
  return list;
}

std::string written(const std::vector<MinimaRow>& rows) {
  StringSink sink;
  write_minima(rows, sink);
  return sink.take();
}

std::vector<MinimaRow> read(const std::string& text) {
  return read_minima(*input_from_text(text, "f"));
}

RC_GTEST_PROP(MinimaProperty, TablesAreReadAsTheyWereWritten, ()) {
  const std::vector<MinimaRow> rows = some_rows();
  RC_ASSERT((read(written(rows)) == rows));
}

RC_GTEST_PROP(MinimaProperty, DamagedTheyAreRefusedOrTables,
              (const std::vector<test::Damage>& damages)) {
  const std::string good = written(some_rows());
  for (const test::Damage& damage : damages) {
    std::vector<MinimaRow> rows;
    if (!test::accepted("f:", [&] { rows = read(damage.of(good)); })) {
      continue;
    }
    std::map<Parameters, int> times;
    for (const MinimaRow& row : rows) {
      check(row.parameters);
      RC_ASSERT(++times[row.parameters] == 1);
      RC_ASSERT(row.start <= row.lower);
      RC_ASSERT((!row.upper || row.lower <= *row.upper));
      RC_ASSERT(is_printable(row.by));
      for (const double seconds : {row.seconds, row.solve_seconds, row.check_seconds}) {
        RC_ASSERT((std::isfinite(seconds) && seconds >= 0));
      }
    }
    RC_ASSERT(written(read(written(rows))) == written(rows));
  }
}

}  // namespace
}  // namespace changeover::minima_property_test
