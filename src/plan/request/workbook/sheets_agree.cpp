#include "plan/request/workbook/sheets_agree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/setups/first_noted.hpp"
#include "plan/job/setups/results.hpp"
#include "plan/request/workbook/run_workbook.hpp"

namespace changeover {
namespace {

using Key = std::pair<std::string, std::uint64_t>;  // bench and step

struct KnownTest {
  std::size_t list = 0;
  std::size_t row = 0;
};

const SheetInput* sheet_of(const Input& input) { return dynamic_cast<const SheetInput*>(&input); }

// "run.xlsx:Done", or the file.
std::string name_of_list(const Input& input) {
  const SheetInput* const sheet = sheet_of(input);
  return sheet == nullptr ? input.name() : input.name() + ":" + sheet->sheet();
}

std::string at(const Input& input, const DoneRow& row) {
  return fmt::format("{}: row {}", name_of_list(input), row.line);
}

bool counts(const DoneRow& row) { return row.step && was_run(row.result); }

bool have_same_parts(const DoneRow& one, const DoneRow& other) {
  const auto sorted = [](auto parts) {
    std::ranges::sort(parts);
    return parts;
  };
  return sorted(one.setup) == sorted(other.setup) && sorted(one.gone) == sorted(other.gone);
}

void refuse_list_of_another_job(const Input& input, const DoneList& list) {
  const bool has_none = !list.rows.empty() && std::ranges::all_of(list.rows, [](const auto& row) {
    return row.setup.empty();
  });
  if (has_none) {
    throw BadInput(fmt::format(
        "{}: none of its parts is in the parts list; give the tests of this job{}",
        name_of_list(input), sheet_of(input) == nullptr ? "" : ", or delete the sheet"));
  }
}

// Tests without a number may be copies of one row, or one test that was done again.
void note_alike(const Input& input, const DoneList& list, std::vector<std::string>& notes) {
  using Test = std::pair<std::vector<std::string>, Block>;
  std::map<Test, std::uint64_t> lines;  // by bench, result, notes and what is gone; and the parts
  const bool has_results = list.has_results();
  FirstNoted copies;
  for (const DoneRow& row : list.rows) {
    if (row.step || (has_results && !was_run(row.result))) {
      continue;
    }
    Test test{row.gone, row.setup};
    std::ranges::sort(test.first);
    std::ranges::sort(test.second);
    test.first.insert(test.first.end(), {lower_case(row.bench), row.result, row.notes});
    const auto [known, is_new] = lines.emplace(std::move(test), row.line);
    if (!is_new) {
      copies.add([&] { return fmt::format("rows {} and {} are alike", known->second, row.line); });
    }
  }
  if (copies) {
    notes.push_back(fmt::format("{}: {}{}", name_of_list(input), copies.said("other case"),
                                copies.count() == 1 ? ", and both count; delete one if it is a copy"
                                                    : "; all count: delete what is a copy"));
  }
}

class Agreement {
 public:
  Agreement(const std::vector<std::unique_ptr<Input>>& inputs, std::vector<DoneList>& lists,
            std::vector<std::string>& notes)
      : inputs_(&inputs), lists_(&lists), notes_(&notes), earlier_(inputs.size()) {}

  void make() {
    for (std::size_t i = 0; i < lists_->size(); ++i) {
      std::map<Key, KnownTest> here;
      for (std::size_t k = 0; k < lists_->at(i).rows.size(); ++k) {
        const DoneRow& row = lists_->at(i).rows[k];
        if (!counts(row)) {
          continue;
        }
        const Key key{lower_case(row.bench), *row.step};
        const auto known = known_.find(key);
        if (known != known_.end()) {
          compare(known->second, {i, k});
        }
        const auto [first, is_new] = here.emplace(key, KnownTest{i, k});
        if (!is_new && is_repeated(row_of(first->second), row)) {
          repeated_.push_back({i, k});
        }
      }
      known_.merge(here);
    }
    join_copies();
    note_doubles();
    note_repeated();
    drop();
  }

 private:
  [[nodiscard]] const DoneRow& row_of(const KnownTest& test) const {
    return lists_->at(test.list).rows[test.row];
  }
  [[nodiscard]] Input& input_of(const KnownTest& test) const { return *inputs_->at(test.list); }
  // Read once: sheets are long.
  [[nodiscard]] bool is_of_earlier_tests(std::size_t list) {
    if (!earlier_[list]) {
      earlier_[list] = changeover::is_of_earlier_tests(*inputs_->at(list));
    }
    return *earlier_[list];
  }

  void compare(const KnownTest& before, const KnownTest& now) {
    const DoneRow& one = row_of(before);
    const DoneRow& other = row_of(now);
    if (!have_same_parts(one, other)) {
      differ(before, now);
    } else if (result_of(one.result) != result_of(other.result)) {
      throw BadInput(
          fmt::format("{}: step {} has the result {}, but {} in row {} of {}; correct "
                      "one, or delete that row",
                      at(input_of(now), other), *other.step, shown(other.result), shown(one.result),
                      one.line, name_of_list(input_of(before))));
    } else {
      doubles_.push_back(before);
    }
  }

  // Two run sheets may not have the same numbers.
  void differ(const KnownTest& before, const KnownTest& now) {
    const DoneRow& one = row_of(before);
    const DoneRow& other = row_of(now);
    const std::string what =
        fmt::format("{}: step {} has other parts than in row {} of {}", at(input_of(now), other),
                    *other.step, one.line, name_of_list(input_of(before)));
    if (!is_of_earlier_tests(before.list) && !is_of_earlier_tests(now.list)) {
      throw BadInput(what +
                     "; if both were done, delete the column step of one sheet, else its results");
    }
    if (!some_differ_) {
      notes_->push_back(what + "; both count, as two tests");
    }
    some_differ_ = true;
  }

  // A step without a result on one copy of a run sheet is that of the other copy.
  void join_copies() {
    std::map<Key, KnownTest> waiting;
    for (std::size_t i = 0; i < lists_->size(); ++i) {
      for (std::size_t k = 0; k < lists_->at(i).rows.size(); ++k) {
        const DoneRow& row = lists_->at(i).rows[k];
        if (!row.step || !row.result.empty()) {
          continue;
        }
        const Key key{lower_case(row.bench), *row.step};
        const auto known = known_.find(key);
        const KnownTest other = known != known_.end()
                                    ? known->second
                                    : waiting.emplace(key, KnownTest{i, k}).first->second;
        if (other.list != i && have_same_parts(row_of(other), row) &&
            !is_of_earlier_tests(other.list) && !is_of_earlier_tests(i)) {
          joined_.push_back({i, k});
        }
      }
    }
  }

  // They count where they were planned, which is the later list.
  void note_doubles() {
    if (doubles_.empty()) {
      return;
    }
    notes_->push_back(fmt::format("{}: {} on another sheet, too, with the same result; {} once",
                                  name_of_list(input_of(doubles_.front())),
                                  count_of(doubles_.size(), "test is", "tests are"),
                                  doubles_.size() == 1 ? "it counts" : "they count"));
  }

  // As where a sheet was copied below itself.
  static bool is_repeated(const DoneRow& one, const DoneRow& other) {
    return have_same_parts(one, other) && result_of(one.result) == result_of(other.result);
  }

  void note_repeated() {
    if (repeated_.empty()) {
      return;
    }
    const DoneRow& row = row_of(repeated_.front());
    notes_->push_back(fmt::format(
        "{}: step {} is on the sheet before, with the same parts and result{}; give {} another "
        "number to count both",
        at(input_of(repeated_.front()), row), *row.step,
        repeated_.size() == 1 ? " and counts once"
                              : fmt::format(", as are {}, which all count once",
                                            count_of(repeated_.size() - 1, "other test")),
        repeated_.size() == 1 ? "it" : "them"));
  }

  void drop() {
    std::vector<std::vector<bool>> dropped;
    for (const DoneList& list : *lists_) {
      dropped.emplace_back(list.rows.size(), false);
    }
    for (const auto* tests : {&doubles_, &joined_, &repeated_}) {
      for (const KnownTest& test : *tests) {
        dropped[test.list][test.row] = true;
      }
    }
    for (std::size_t i = 0; i < lists_->size(); ++i) {
      std::size_t next = 0;
      std::erase_if(lists_->at(i).rows,
                    [&](const DoneRow&) { return static_cast<bool>(dropped[i][next++]); });
    }
  }

  const std::vector<std::unique_ptr<Input>>* inputs_;
  std::vector<DoneList>* lists_;
  std::vector<std::string>* notes_;
  std::vector<std::optional<bool>> earlier_;  // by list, once it was asked
  std::map<Key, KnownTest> known_;
  std::vector<KnownTest> doubles_;
  std::vector<KnownTest> joined_;    // without a result, and on another sheet, too
  std::vector<KnownTest> repeated_;  // on the same sheet before
  bool some_differ_ = false;
};

}  // namespace

bool is_of_earlier_tests(Input& input) {
  const SheetInput* const sheet = sheet_of(input);
  if (sheet == nullptr || lower_case(sheet->sheet()) == lower_case(done_sheet)) {
    return sheet != nullptr;
  }
  try {
    WorkbookSheet rows(input.rewind() ? read_to_end(input) : "", input.name(), sheet->sheet());
    const auto head = head_row(rows);
    return head && shape_of(head->heads) == SheetShape::done;
  } catch (const BadInput&) {
    return false;
  }
}

void make_agree(const std::vector<std::unique_ptr<Input>>& inputs, std::vector<DoneList>& lists,
                std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < lists.size(); ++i) {
    refuse_list_of_another_job(*inputs[i], lists[i]);
    note_alike(*inputs[i], lists[i], notes);
  }
  Agreement(inputs, lists, notes).make();
}

void note_lost_steps(const std::string& book, std::uint64_t last_step,
                     const std::vector<DoneList>& lists, std::vector<std::string>& notes) {
  std::set<std::uint64_t> there;
  for (const DoneList& list : lists) {
    for (const DoneRow& row : list.rows) {
      if (row.step && *row.step > last_step) {
        there.insert(*row.step);
      }
    }
  }
  std::vector<std::string> gaps;
  std::uint64_t lost = 0;
  std::uint64_t next = last_step + 1;
  for (const std::uint64_t step : there) {
    if (step > next) {
      gaps.push_back(step == next + 1 ? fmt::format("{}", next)
                                      : fmt::format("{} to {}", next, step - 1));
      lost += step - next;
    }
    next = step + 1;
  }
  if (gaps.empty()) {
    return;
  }
  constexpr std::size_t few = 10;
  std::string steps = joined(gaps | std::views::take(few));
  if (gaps.size() > few) {
    steps += fmt::format(" and {} more", count_of(gaps.size() - few, "place"));
  }
  const bool is_one = lost == 1;
  notes.push_back(fmt::format("{}: no sheet has tests with {} {}; if {} done, put {} back", book,
                              is_one ? "step" : "steps", steps, is_one ? "it was" : "they were",
                              is_one ? "it" : "them"));
}

}  // namespace changeover
