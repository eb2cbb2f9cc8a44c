#include "plan/request/workbook/bench_tabs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/setups/results.hpp"
#include "plan/request/workbook/sheets_agree.hpp"
#include "plan/sheet/benches/bench_words.hpp"

namespace changeover {
namespace {

bool has_result(const DoneRow& row) { return was_run(row.result); }

// A bench that a column names in another case.
void take_benches_in_any_case(const std::vector<Bench>& benches, std::vector<DoneList>& lists) {
  for (DoneList& list : lists) {
    for (DoneRow& row : list.rows) {
      for (std::size_t b = 0; !find_bench(benches, row.bench) && b < benches.size(); ++b) {
        if (lower_case(name_of(benches, b)) == lower_case(row.bench)) {
          row.bench = name_of(benches, b);
        }
      }
    }
  }
}

std::string some_tabs(const std::vector<Bench>& benches) {
  constexpr std::size_t few = 3;
  return joined(bench_sheet_names(benches) | std::views::take(few), " or ", shown);
}

}  // namespace

std::optional<std::size_t> bench_of_tab(const std::vector<Bench>& benches, const std::string& tab) {
  const std::vector<std::string> tabs = bench_sheet_names(benches);
  const auto found = std::ranges::find_if(
      tabs, [&](const std::string& each) { return lower_case(each) == lower_case(tab); });
  return found == tabs.end() ? find_bench(benches, tab)
                             : std::optional(static_cast<std::size_t>(found - tabs.begin()));
}

void take_benches_of_tabs(const std::vector<std::unique_ptr<Input>>& inputs,
                          const std::vector<Bench>& benches, std::vector<DoneList>& lists,
                          std::vector<std::string>& notes) {
  take_benches_in_any_case(benches, lists);
  for (std::size_t i = 0; i < lists.size() && benches.size() > 1; ++i) {
    const auto* const sheet = dynamic_cast<const SheetInput*>(inputs[i].get());
    std::vector<DoneRow>& rows = lists[i].rows;
    const auto names_none = [](const DoneRow& row) { return row.bench.empty(); };
    if (sheet == nullptr || std::ranges::none_of(rows, names_none)) {
      continue;
    }
    const auto bench = bench_of_tab(benches, sheet->sheet());
    const std::string where = sheet->name() + ":" + sheet->sheet();
    const bool is_its_own = bench && std::ranges::all_of(rows, [&](const DoneRow& row) {
                              return row.bench.empty() || find_bench(benches, row.bench) == bench;
                            });
    if (is_its_own) {
      notes.push_back(fmt::format("{}: tests without a bench are those of {}, as the tab says",
                                  where, name_of(benches, *bench)));
      for (DoneRow& row : rows | std::views::filter(names_none)) {
        row.bench = name_of(benches, *bench);
      }
    } else if (std::ranges::all_of(rows, names_none) && std::ranges::any_of(rows, has_result) &&
               !is_of_earlier_tests(*inputs[i])) {
      throw BadInput(
          fmt::format("{}: nothing says on which bench its tests were; name its tab after the "
                      "bench, as {}, or give it a column bench",
                      where, some_tabs(benches)));
    }
  }
}

}  // namespace changeover
