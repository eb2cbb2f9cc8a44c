// Run sheets of jobs at random: what people fill in and hand back is read as it was written;
// damaged, a workbook says the same or is refused, and CSV holds set-ups or is refused.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "changeover/plan/run_plan.hpp"
#include "core/each.hpp"
#include "damage.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "random_jobs.hpp"
#include "some_names.hpp"

namespace changeover::sheet_property_test {
namespace {

using test::Damage;
using test::some_number;

struct Sheet {
  Job job;
  std::vector<Block> setups;  // each increasing
  RunPlan plan;

  void take(std::vector<Block> list) {
    setups = std::move(list);
    plan.sheet = run_sheet(job, setups);
  }
  [[nodiscard]] SheetDocument document() const {
    return {.job = &job, .plan = &plan, .title = "Bench"};
  }
};

std::vector<Block> increasing(std::vector<Block> setups) {
  for (Block& setup : setups) {
    std::ranges::sort(setup);
  }
  return setups;
}

// Some parts of each set-up are in it: the job need not be done.
Sheet some_sheet() {
  Sheet sheet;
  const std::uint64_t seed = some_number(1'000'000);
  const bool slots = some_number(1) == 1;
  sheet.job = slots ? test::random_job_with_slots(seed, 7) : test::random_job(seed, 7);
  Job& job = sheet.job;
  job.names = test::some_names(job.parts());
  for (Slot& slot : job.slots) {
    slot.name = test::some_name() + slot.name;
  }
  std::vector<Block> setups(some_number(5));
  for (Block& setup : setups) {
    for (Element x = 0; x < job.parts(); ++x) {
      if (some_number(1) == 1 && setup.size() < job.room()) {
        setup.push_back(x);
      }
    }
    if (setup.empty()) {
      setup.push_back(static_cast<Element>(some_number(job.parts() - 1)));
    }
  }
  sheet.take(std::move(setups));
  return sheet;
}

std::unique_ptr<Input> workbook_sheet(const std::string& bytes, const std::string& name) {
  return std::make_unique<SheetInput>(input_from_text(bytes, "f.xlsx"), name);
}

RC_GTEST_PROP(SheetProperty, IsReadAsItWasWritten, ()) {
  const Sheet sheet = some_sheet();
  const Job& job = sheet.job;
  const std::string bytes = written(sheet.document(), "xlsx");
  RC_ASSERT(increasing(read_setups(*workbook_sheet(bytes, "Run sheet"), job.names)) ==
            sheet.setups);
  const PartList parts = read_parts(*workbook_sheet(bytes, "Parts"));
  RC_ASSERT(parts.names == job.names);
  for (Element x = 0; x < job.parts(); ++x) {
    RC_ASSERT((parts.change_costs[x] == job.change_costs[x]));
    if (!job.slots.empty()) {
      RC_ASSERT(parts.slots[x] ==
                (job.slot_of[x] == no_slot ? "" : job.slots[job.slot_of[x]].name));
    }
  }
  const std::string csv = written(sheet.document(), "csv");
  RC_LOG() << csv;
  RC_ASSERT(increasing(read_setups(*input_from_text(csv, "f"), job.names)) == sheet.setups);
}

RC_GTEST_PROP(SheetProperty, ResultsAreReadAsTheyWereFilledIn, ()) {
  const Sheet sheet = some_sheet();
  std::vector<std::string> results;
  std::string csv;
  for (const char c : written(sheet.document(), "csv")) {
    if (c == '\n' && csv.find('\n') != std::string::npos) {
      results.push_back(
          *rc::gen::element<std::string>("pass", "fail", "", "=leaks", "unclear, \"wet\"", "-1"));
      csv += csv_cell(results.back());
    }
    csv += c;
  }
  const DoneList done = read_done(*input_from_text(csv, "f"), sheet.job.names);
  RC_ASSERT(increasing(done.setups()) == sheet.setups);
  RC_ASSERT(each_of<std::string>(done.rows, &DoneRow::result) == results);
  RC_ASSERT(done.gone.empty());
  RC_LOG() << csv;
  RC_ASSERT(done.notes.empty());
}

// Without one of its columns of parts, a sheet is refused, or a note says so, or no pair is lost
// that its steps test.
RC_GTEST_PROP(SheetProperty, AColumnOfPartsIsNotLostWithoutAWord, ()) {
  Sheet sheet = some_sheet();
  sheet.job.start.clear();
  sheet.take(sheet.setups);
  const std::string csv = written(sheet.document(), "csv");
  const auto without = [&](std::size_t column) {
    std::string text;
    const auto input = input_from_text(csv, "f");
    RowReader reader(*input);
    while (const auto row = reader.next()) {
      for (std::size_t i = 0; i < row->size(); ++i) {
        text += i == column ? "" : csv_cell(csv_text(row->at(i).text)) + ",";
      }
      text += "pass\n";
    }
    return text;
  };
  const auto input = input_from_text(csv, "f");
  RowReader reader(*input);
  const Row head = *reader.next();
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (!head[i].text.starts_with("slot_")) {
      continue;
    }
    const std::string bad = without(i);
    RC_LOG() << bad;
    DoneList done;
    if (test::accepted("f:", [&] {
          done = read_done(*input_from_text(bad, "f"), sheet.job.names, sheet.job.room());
        })) {
      RC_ASSERT((!done.notes.empty() || increasing(done.setups()) == sheet.setups));
    }
  }
}

RC_GTEST_PROP(SheetProperty, ADamagedWorkbookIsRefusedOrSaysTheSame,
              (const std::array<Damage, 8>& damages)) {
  const Sheet sheet = some_sheet();
  const std::string good = written(sheet.document(), "xlsx");
  for (const Damage& damage : damages) {
    const std::string bytes = damage.of(good);
    std::vector<Block> setups;
    if (begins_like_a_workbook(bytes) && test::accepted("f.xlsx:", [&] {
          setups = read_setups(*workbook_sheet(bytes, "Run sheet"), sheet.job.names);
        })) {
      RC_ASSERT(increasing(setups) == sheet.setups);
    }
  }
}

RC_GTEST_PROP(SheetProperty, DamagedCsvIsRefusedOrHoldsSetUps,
              (const std::vector<Damage>& damages)) {
  Sheet sheet = some_sheet();
  const std::vector<std::string>& names = sheet.job.names;
  const std::string good = written(sheet.document(), "csv");
  for (std::size_t i = 0; i < damages.size() && i < 20; ++i) {
    const std::string bad = damages[i].of(good);
    std::vector<Block> setups;
    if (test::accepted("f:", [&] {
          setups = increasing(read_setups(*input_from_text(bad, "f"), names, sheet.job.room()));
        })) {
      for (const Block& setup : setups) {
        RC_ASSERT_FALSE(setup.empty());
        RC_ASSERT(setup.size() <= sheet.job.room());
        RC_ASSERT(setup.back() < names.size());
        RC_ASSERT(std::ranges::adjacent_find(setup) == setup.end());
      }
      sheet.take(setups);
      const std::string again = written(sheet.document(), "csv");
      RC_ASSERT(increasing(read_setups(*input_from_text(again, "f"), names)) == setups);
    }
    DoneList done;
    if (test::accepted("f:", [&] { done = read_done(*input_from_text(bad, "f"), names); })) {
      for (const DoneRow& row : done.rows) {
        RC_ASSERT((!row.setup.empty() || row.lacks));
        RC_ASSERT((!row.lacks || !done.gone.empty()));
      }
    }
  }
}

}  // namespace
}  // namespace changeover::sheet_property_test
