// A part that stays keeps its place: read off the sheets themselves, column by column, also across
// replans.
#include "plan/sheet/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/job_request.hpp"
#include "damage.hpp"
#include "io/scan/json_events.hpp"
#include "io/scan/row_reader.hpp"
#include "random_jobs.hpp"
#include "replacing_jobs.hpp"

namespace changeover::places_test {
namespace {

using test::some_number;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A sheet as a reader sees it: by row, the part in each column that is headed slot_N.
struct SeenSheet {
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] std::map<std::string, std::string> columns_by_part(std::size_t row) const {
    std::map<std::string, std::string> found;
    for (std::size_t c = 0; c < heads.size(); ++c) {
      if (!rows[row][c].empty()) {
        EXPECT_TRUE(found.emplace(rows[row][c], heads[c]).second) << rows[row][c] << " twice";
      }
    }
    return found;
  }
};

SeenSheet seen(const std::string& csv) {
  const auto input = input_from_text(csv, "f");
  RowReader reader(*input);
  SeenSheet sheet;
  std::vector<std::size_t> columns;
  for (std::optional<Row> header; const auto row = reader.next();) {
    if (!header) {
      header = row;
      for (std::size_t i = 0; i < row->size(); ++i) {
        if ((*row)[i].text.starts_with("slot_")) {
          columns.push_back(i);
          sheet.heads.push_back((*row)[i].text);
        }
      }
      continue;
    }
    auto& parts = sheet.rows.emplace_back();
    for (const std::size_t i : columns) {
      parts.push_back((*row)[i].text);
    }
  }
  return sheet;
}

// For each stay one column, and only columns of the part's slot. Returns how many stays there are.
std::size_t check_stays(const Job& job, const SeenSheet& sheet, std::string_view what) {
  EXPECT_EQ(std::set<std::string>(sheet.heads.begin(), sheet.heads.end()).size(),
            sheet.heads.size());
  std::size_t stays = 0;
  std::map<std::string, std::string> before;
  for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
    const auto now = sheet.columns_by_part(row);
    for (const auto& [part, column] : now) {
      const auto was = before.find(part);
      if (was != before.end()) {
        EXPECT_EQ(was->second, column) << what << ": " << part << " in row " << row + 1;
        ++stays;
      }
      const auto x = static_cast<std::size_t>(std::find(job.names.begin(), job.names.end(), part) -
                                              job.names.begin());
      const std::uint32_t slot = job.slots.empty() ? no_slot : job.slot_of.at(x);
      EXPECT_EQ(column.find(' ') == std::string::npos ? "" : column.substr(column.find(' ') + 1),
                slot == no_slot ? "" : job.slots[slot].name);
    }
    before = now;
  }
  return stays;
}

Job some_job(std::uint64_t seed) {
  Job job = seed % 3 == 0   ? test::random_job(seed, 7)
            : seed % 3 == 1 ? test::random_job_with_slots(seed, 7)
                            : test::replacing(test::random_job_with_slots(seed, 6), seed);
  for (std::string& name : job.names) {
    name = "p" + name;
  }
  return job;
}

RunPlan some_plan(const Job& job) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.steps = 200, .attempts = 1, .design_moves = 0, .states = 0}, control);
}

TEST(Places, AStayHasOneColumn) {
  std::size_t stays = 0;
  for (std::uint64_t seed = 1; seed <= 240; ++seed) {
    const Job job = some_job(seed);
    const RunPlan plan = some_plan(job);
    const std::string csv = written(SheetDocument{.job = &job, .plan = &plan}, "csv");
    stays += check_stays(job, seen(csv), csv);
  }
  EXPECT_GT(stays, 500U);
}

TEST(Places, AStayHasOneColumnOnEveryBench) {
  Job job = make_job(9, 4, Amount{1}, Amount{1});
  for (std::size_t i = 0; i < 9; ++i) {
    job.names[i] = "p" + job.names[i];
  }
  set_slots(job, {"a", "a", "a", "b", "b", "b", "", "", ""}, {{"a", 0, 2}, {"b", 1, 2}});
  RunControl control({.threads = 1});
  const BenchPlan plan = make_bench_plan(job, {.benches = 3, .plan = {.steps = 500}}, control);
  const PlacedSheets all =
      placed({{&job, &plan.sheets[0]}, {&job, &plan.sheets[1]}, {&job, &plan.sheets[2]}});
  EXPECT_EQ(all.places.size(), 2U + 2U + 3U);
  SeenSheet sheet = seen(written(BenchDocument{.job = &job, .plan = &plan}, "csv"));
  std::size_t first = 0;
  for (const RunSheet& list : plan.sheets) {
    SeenSheet of_bench{.heads = sheet.heads, .rows = {}};
    for (std::size_t i = 0; i < list.steps.size(); ++i) {
      of_bench.rows.push_back(sheet.rows.at(first + i));
    }
    check_stays(job, of_bench, "bench");
    first += list.steps.size();
  }
}

// What replaces another part by the count of the costs is in its place, if places of that slot
// allow it.
TEST(Places, WhatReplacesAPartTakesItsPlace) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job = test::replacing(test::random_job(seed, 7), seed);
    const RunPlan plan = some_plan(job);
    const PlacedSheets all = placed({{&job, &plan.sheet}});
    for (std::size_t i = 0; i < plan.sheet.steps.size(); ++i) {
      const MountedParts& before = i == 0 ? all.sheets[0].before : all.sheets[0].steps[i - 1];
      for (const auto& [out, in] : plan.sheet.steps[i].replaced) {
        EXPECT_EQ(std::ranges::find(before, out) - before.begin(),
                  std::ranges::find(all.sheets[0].steps[i], in) - all.sheets[0].steps[i].begin());
      }
    }
  }
}

TEST(Places, APartThatComesBackTakesItsOldPlaceIfItIsFree) {
  const Job job = make_job(4, 3, Amount{1}, Amount{1});
  const RunSheet sheet = run_sheet(job, {{0, 1, 2}, {2}, {1, 2}, {0, 1, 2}});
  const PlacedSheets all = placed({{&job, &sheet}});
  EXPECT_EQ(all.sheets[0].steps[2], (MountedParts{std::nullopt, 1U, 2U}));
  EXPECT_EQ(all.sheets[0].steps[3], (MountedParts{0U, 1U, 2U}));
}

TEST(Places, AreFoundAgainByTheirNumbers) {
  Job job = make_job(5, 3, Amount{1}, Amount{1});
  job.start = {3, 1};
  job.places = {{.number = 7, .part = 1U}, {.number = 2}};
  const RunSheet sheet = run_sheet(job, {{1, 3, 4}});
  const PlacedSheets all = placed({{&job, &sheet}});
  std::vector<std::uint64_t> numbers;
  for (const MountedPlace& place : all.places) {
    numbers.push_back(place.number);
  }
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 2, 7}));
  EXPECT_EQ(all.sheets[0].before.back(), 1U);
  EXPECT_EQ(all.sheets[0].steps[0].back(), 1U);
}

// Every mutation of where parts are is noticed.
RC_GTEST_PROP(PlacesProperty, TheCountFindsWhatIsWrong, ()) {
  const Job job = some_job(some_number(10'000));
  const RunPlan plan = some_plan(job);
  RC_PRE(!plan.sheet.steps.empty());
  PlacedSheets all = placed({{&job, &plan.sheet}});
  RC_ASSERT(place_faults({{&job, &plan.sheet}}, all).empty());
  const std::size_t step = some_number(plan.sheet.steps.size() - 1);
  MountedParts& parts = all.sheets[0].steps[step];
  const std::size_t place = some_number(parts.size() - 1);
  const std::size_t other = some_number(parts.size() - 1);
  RC_PRE(place != other && (parts[place] || parts[other]));
  switch (some_number(3)) {
    case 0:  // a part gets lost
      RC_PRE(parts[place].has_value());
      parts[place].reset();
      break;
    case 1:  // it is in two places
      RC_PRE(parts[place].has_value());
      parts[other] = parts[place];
      break;
    case 2:  // another part
      parts[place] = static_cast<Element>(
          (parts[place].value_or(0) + 1 + some_number(job.parts() - 2)) % job.parts());
      break;
    default: {  // two places are exchanged; noticed where something stays, or of two slots
      const auto stays = [&](std::size_t i) {
        const auto is_at = [&](const MountedParts& row) {
          return parts[i] && std::ranges::find(row, parts[i]) != row.end();
        };
        return is_at(step == 0 ? all.sheets[0].before : all.sheets[0].steps[step - 1]) ||
               (step + 1 < plan.sheet.steps.size() && is_at(all.sheets[0].steps[step + 1]));
      };
      RC_PRE(all.places[place].slot != all.places[other].slot || stays(place) || stays(other));
      std::swap(parts[place], parts[other]);
    }
  }
  RC_ASSERT(!place_faults({{&job, &plan.sheet}}, all).empty());
}

// A sheet is filled in up to some row, and the rest is replanned: what is mounted keeps its
// column.
TEST(Places, AReplanGoesOnWhereTheSheetEnds) {
  std::size_t kept = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Job job = some_job(seed);
    job.replace_costs.clear();
    JobRequest request{.at_once = job.at_once, .test_cost = "2", .steps = 200};
    request.parts.rows.emplace();
    for (Element x = 0; x < job.parts(); ++x) {
      request.parts.rows->push_back(
          {{job.names[x], to_string(job.change_costs[x]),
            job.slots.empty() || job.slot_of[x] == no_slot ? "" : job.slots[job.slot_of[x]].name}});
    }
    for (const Slot& slot : job.slots) {
      request.slots.rows = request.slots.rows.value_or(std::vector<ListRow>{});
      request.slots.rows->push_back({{slot.name, std::to_string(slot.least),
                                      std::to_string(std::min<std::uint64_t>(slot.most, 99))}});
    }
    const auto csv_of = [&] {
      const CheckedJobRequest asked = checked_job(request, Door::document);
      RunControl control({.threads = 1});
      return written(asked, answer_to(asked, control), "csv");
    };
    std::string csv;
    try {
      csv = csv_of();
    } catch (const BadInput&) {
      continue;  // no two parts can meet
    }
    const SeenSheet before = seen(csv);
    if (before.rows.size() < 2) {
      continue;
    }
    const std::size_t rows = 1 + seed % (before.rows.size() - 1);
    std::size_t at = csv.find('\n') + 1;
    std::string sheet = csv.substr(0, at);
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t end = csv.find('\n', at);
      sheet += csv.substr(at, end - at) + "pass\n";
      at = end + 1;
    }
    request.done.text = sheet + csv.substr(at);
    csv = csv_of();
    const SeenSheet after = seen(csv);
    check_stays(job, after, csv);
    if (after.rows.empty()) {
      continue;
    }
    const auto mounted = before.columns_by_part(rows - 1);
    for (const auto& [part, column] : after.columns_by_part(0)) {
      if (const auto was = mounted.find(part); was != mounted.end()) {
        EXPECT_EQ(was->second, column) << seed << "\n" << *request.done.text << "\n" << csv;
        ++kept;
      }
    }
  }
  EXPECT_GT(kept, 50U);
}

// Tests that were done are sent as they were answered, place by place, with nothing where a place
// was empty.
TEST(Places, AreKeptInDocuments) {
  JobRequest request{.at_once = 3, .test_cost = "1", .change_cost = "1"};
  request.parts.rows = {{{{"A"}}, {{"B"}}, {{"C"}}, {{"D"}}, {{"E"}}}};
  request.done.rows = {{{.fields = {"", "C", "A"}, .result = "pass"}}};
  const CheckedJobRequest asked = checked_job(request, Door::document);
  ASSERT_EQ(asked->job->places.size(), 3U);
  EXPECT_EQ(asked->job->places[1].part, 2U);
  RunControl control({.threads = 1});
  const PlanAnswer answer = answer_to(asked, control);
  const std::string json = written(asked, answer, "json");
  EXPECT_THAT(json, HasSubstr(R"("places":[{"number":1,"slot":null},{"number":2,)"));
  const PlacedSheets all = placed({{&*asked->job, &answer.plan->sheet}});
  EXPECT_EQ(all.sheets[0].before, (MountedParts{std::nullopt, 2U, 0U}));
}

TEST(Places, JobsWithPlacesThatCannotBeAreRefused) {
  Job job = make_job(4, 2, Amount{1}, Amount{1});
  job.start = {0};
  const auto fault = [&](std::vector<MountedPlace> places) {
    job.places = std::move(places);
    const auto found = defects(job);
    return found.empty() ? std::string() : found.front();
  };
  EXPECT_THAT(fault({{.number = 1, .part = 0U}, {.number = 2}}), IsEmpty());
  EXPECT_THAT(fault({{.number = 1}, {.number = 1}}), HasSubstr("the number 1"));
  EXPECT_THAT(fault({{.number = 0}}), HasSubstr("count them from 1"));
  EXPECT_THAT(fault({{.number = 1, .slot = 0}}), HasSubstr("in a slot that there is not"));
  EXPECT_THAT(fault({{.number = 1, .part = 1U}}), HasSubstr("not mounted at the start"));
  EXPECT_THAT(fault({{.number = 1, .part = 9U}}), HasSubstr("not mounted at the start"));
  EXPECT_THAT(fault({{.number = 1, .part = 0U}, {.number = 2, .part = 0U}}),
              HasSubstr("it is in another"));
}

}  // namespace
}  // namespace changeover::places_test
