#include "plan/request/done/done_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/hidden_tests.hpp"
#include "plan/job/setups/results.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "plan/job/setups/step_numbers.hpp"
#include "plan/request/asked_benches.hpp"
#include "plan/request/done/done_places.hpp"
#include "plan/request/done/lost_columns.hpp"
#include "plan/request/workbook/bench_tabs.hpp"
#include "plan/request/workbook/sheets_agree.hpp"

namespace changeover {
namespace {

constexpr std::size_t unread_shown = 10;

Block in_order(Block setup) {
  std::ranges::sort(setup);
  return setup;
}

void note_unread(const DoneOptions& options, const DoneWords& words, ReadJob& answer) {
  if (answer.unread == 0 || options.for_diagnosis) {
    return;
  }
  const UnreadResult& one = answer.first_unread.front();
  answer.notes.push_back(
      fmt::format("{}: the result {} is not understood{}; its pairs {}; write pass or fail",
                  one.place, shown(one.text),
                  answer.unread == 1 ? ""
                                     : fmt::format(", nor {} {}", answer.unread == 2 ? "is" : "are",
                                                   count_of(answer.unread - 1, "other")),
                  fmt::format("count as tested{} {}",
                              options.failed == FailedTests::trusted ? ", by" : " only with",
                              words.trust_failed)));
}

// Removes first set-ups that are already done.
void drop_first(const std::vector<Block>& done, std::vector<Block>& first) {
  std::map<Block, std::vector<std::size_t>> places;  // of each set-up, the last one first
  for (std::size_t i = first.size(); i-- > 0;) {
    places[in_order(first[i])].push_back(i);
  }
  std::vector<bool> is_done(first.size());
  for (const Block& setup : done) {
    const auto found = places.find(in_order(setup));
    if (found != places.end() && !found->second.empty()) {
      is_done[found->second.back()] = true;
      found->second.pop_back();
    }
  }
  std::size_t next = 0;
  std::erase_if(first, [&](const Block&) { return is_done[next++]; });
}

// Renumbers the parts of the set-ups in a list; those that broke are gone.
void leave_out(const DoneOptions& options, DoneList& list) {
  const PartsLeft& left = *options.left;
  for (DoneRow& row : list.rows) {
    for (const Element x : row.setup) {
      if (left(Block{x}).empty()) {
        row.gone.push_back(options.names->at(x));
        if (options.all_values != nullptr && out_of_range(*options.all_values, Block{x})) {
          row.hidden_by = row.gone.back();
        }
      }
    }
    row.lacks = row.lacks || !row.gone.empty();
    row.setup = left(row.setup);
    for (std::optional<Element>& part : row.in_place) {
      const Block one = part ? left(Block{*part}) : Block();
      part = one.empty() ? std::nullopt : std::optional(one.front());
    }
  }
}

// Removes tests from a job, list by list.
class DoneTaker {
 public:
  DoneTaker(const DoneOptions& options, const DoneWords& words, Job& job,
            std::vector<Bench>& benches)
      : options_(&options),
        words_(&words),
        job_(&job),
        benches_(&benches),
        on_bench_(benches.size()) {}

  ReadJob take(const std::vector<std::unique_ptr<Input>>& inputs) {
    name_ = inputs.back()->name();
    answer_.done_from = name_;
    read(inputs);
    for (std::size_t i = 0; i < list_.rows.size(); ++i) {
      add(i);
    }
    say_notes();
    go_on();
    return std::move(answer_);
  }

 private:
  void read(const std::vector<std::unique_ptr<Input>>& inputs) {
    std::vector<DoneList> lists;
    for (const auto& input : inputs) {
      lists.push_back(options_->all_values != nullptr
                          ? read_done(*input, *options_->all_values)
                          : read_done(*input, *options_->names, most_at_once(*job_, *benches_)));
    }
    if (!options_->all_parts_known) {
      take_benches_of_tabs(inputs, *benches_, lists, list_.notes);
      make_agree(inputs, lists, list_.notes);
    }
    std::vector<std::size_t> begins;  // of the rows of run sheets
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (lists.size() > 1 && !is_of_earlier_tests(*inputs[i])) {
        begins.push_back(list_.rows.size());
      }
      append_done(list_, std::move(lists[i]), job_->model != nullptr);
    }
    if (put_sheets_in_order(list_.rows, begins)) {
      list_.notes.push_back(
          name_ + ": its sheets are not in the order of their steps; the tests are taken in it");
    }
    leave_out(*options_, list_);
    note_lost_columns(list_, *job_, !benches_->empty(), name_);
    all_ = list_.rows.size();
    has_results_ = list_.has_results();
    if (options_->first.value_or(0) > all_) {
      throw BadOption(fmt::format("{} {}: {} has only {}; give a smaller number",
                                  words_->done_first, *options_->first, name_,
                                  count_of(all_, "set-up")));
    }
    if (options_->all_parts_known && !list_.gone.empty()) {
      const PartFinder finder = options_->all_values != nullptr ? PartFinder(*options_->all_values)
                                                                : PartFinder(*options_->names);
      throw BadInput(fmt::format("{}: {}", name_, finder.complaint(list_.gone.front())));
    }
  }

  // The bench of a test; nullopt if unknown.
  std::optional<std::size_t> bench_of(const std::string& word) {
    if (word.empty() && benches_->size() == 1) {
      return 0;
    }
    const auto found = find_bench(*benches_, word);
    if (!benches_->empty() && !found) {
      if (std::ranges::find(no_benches_, word) == no_benches_.end()) {
        no_benches_.push_back(word);
      }
    }
    return found;
  }

  // The most parts that fit, now.
  [[nodiscard]] std::uint64_t room_of(std::optional<std::size_t> bench) const {
    return bench ? (*benches_)[*bench].at_once.value_or(job_->at_once)
                 : most_at_once(*job_, *benches_);
  }

  // Parts of the last test that do not fit any more.
  void note_what_is_out(const Block& setup, const Block& start) {
    if (setup.size() > start.size() && !start.empty()) {
      std::vector<std::string> out;
      for (const Element x : setup) {
        if (!contains(start, x)) {
          out.push_back(job_->names[x]);
        }
      }
      answer_.notes.push_back(
          fmt::format("{}: {} of the last test had no room any more, and {} as taken out", name_,
                      joined(out, shown), out.size() == 1 ? "counts" : "count"));
    }
  }

  void add(std::size_t i) {
    const DoneRow& row = list_.rows[i];
    const TestResult result = result_of(row.result);
    const bool counts =
        options_->first ? i < *options_->first : !has_results_ || result != TestResult::none;
    const auto bench = bench_of(row.bench);
    if (!counts || result == TestResult::not_run) {
      not_run_ += counts ? 1U : 0U;
      if (bench) {
        (*benches_)[*bench].rest.push_back(row.setup);
      } else if (benches_->empty()) {
        answer_.rest.push_back(row.setup);
      }
      return;
    }
    if (row.setup.size() > room_of(bench)) {
      first_large_ = first_large_.value_or(i);
      ++large_;
    }
    const bool is_hidden = hidden_.take(*job_, row);
    answer_.done.push_back({row.setup, result, is_hidden});
    record_test(answer_.record, list_.places, row, *job_,
                bench ? name_of(*benches_, *bench) : row.bench);
    last_ = i;
    if (bench) {
      on_bench_[*bench].push_back(i);
    } else {
      ++on_none_;
    }
    if (result == TestResult::fail && row.lacks) {
      ++failed_with_gone_;  // a removed part may be at fault
    } else if ((result == TestResult::pass || result == TestResult::fail) && !is_hidden) {
      answer_.results.push_back({row.setup, result == TestResult::fail});
    } else if (result == TestResult::unread && answer_.unread++ < unread_shown) {
      answer_.first_unread.push_back({row.unread, row.result});
    }
  }

  void say_notes() {
    std::vector<std::string>& notes = answer_.notes;
    notes.insert(notes.end(), list_.notes.begin(), list_.notes.end());
    if (failed_with_gone_ > 0) {
      answer_.left_out = fmt::format(
          "{}: {} failed with a part that is gone, which may be to blame: a diagnosis leaves {} "
          "out",
          name_, count_of(failed_with_gone_, "test"), failed_with_gone_ == 1 ? "it" : "them");
      notes.push_back(answer_.left_out);
    }
    if (std::string note = hidden_.said(name_); !note.empty()) {
      answer_.left_out = note;
      notes.push_back(std::move(note));
    }
    note_unread(*options_, *words_, answer_);
    if (large_ > 0 && !options_->for_diagnosis) {
      const DoneRow& row = list_.rows[*first_large_];
      notes.push_back(fmt::format(
          "{}: {} had more parts than fit at once now, as that in row {} with {}; {} as done, and "
          "only new tests keep to the room",
          name_, count_of(large_, "test"), row.line, row.setup.size(),
          large_ == 1 ? "it counts" : "they count"));
    }
    if (!list_.gone.empty()) {
      notes.push_back(gone_note(name_, list_.gone,
                                job_->model != nullptr ? GoneFrom::model : GoneFrom::parts_list));
    }
    for (const std::string& bench : no_benches_) {
      notes.push_back(
          bench.empty()
              ? fmt::format("{}: tests that name no bench count, but nothing says what is mounted "
                            "where; add a column bench",
                            name_)
              : fmt::format("{}: {} is not one of the benches; what was tested there counts, and "
                            "the rest of its sheet is replanned",
                            name_, shown(bench)));
    }
    if (not_run_ > 0) {
      notes.push_back(fmt::format("{}: {} not run, by the column result, and {} not done", name_,
                                  count_of(not_run_, "test was", "tests were"),
                                  not_run_ == 1 ? "is" : "are"));
    }
    if (!options_->first && has_results_ && answer_.done.size() < all_) {
      notes.push_back(fmt::format(
          "{}: {} of {} {}", name_, answer_.done.size(), count_of(all_, "test"),
          answer_.done.size() == 1 ? "has a result and is done" : "have a result and are done"));
    }
  }

  // Sets the start of the job, and of each bench, after the tests that were done.
  void go_on() {
    if (benches_->empty()) {
      std::vector<Block> setups = each_of<Block>(answer_.done, &DoneTest::setup);
      take_first_off(setups, job_->first);
      const bool starts_after_it = job_->start.empty();
      mark_tested(*job_, answer_.done, options_->failed);
      for (const DoneRecord::Test& test : answer_.record.tests) {
        job_->last_step = std::max(job_->last_step, test.step.value_or(0));
      }
      if (last_) {
        job_->places = places_after(list_, *last_, *job_, job_->at_once);
        if (starts_after_it) {
          note_what_is_out(list_.rows[*last_].setup, job_->start);
        }
      }
      return;
    }
    Job whole = *job_;
    whole.at_once = most_at_once(*job_, *benches_);
    mark_tested(whole, answer_.done, options_->failed);
    whole.at_once = job_->at_once;
    whole.start = job_->start;
    whole.tests_done = on_none_;
    for (std::size_t b = 0; b < benches_->size(); ++b) {
      Bench& bench = (*benches_)[b];
      if (on_bench_[b].empty()) {
        continue;
      }
      const std::vector<Block> setups = each_of<Block>(
          on_bench_[b], [&](const std::size_t test) { return list_.rows[test].setup; });
      bench.tests_done = setups.size();
      for (const std::size_t test : on_bench_[b]) {
        bench.last_step = std::max(bench.last_step, list_.rows[test].step.value_or(0));
      }
      std::vector<Block> first = bench.first.value_or(job_->first);
      take_first_off(setups, first);
      bench.first = std::move(first);
      const std::vector<bool> barred = barred_parts(*job_, bench);
      Block start = setups.back();
      std::erase_if(start, [&](Element x) { return barred[x]; });
      bench.start = what_stays(*job_, start, room_of(b));
      note_what_is_out(start, *bench.start);
    }
    *job_ = std::move(whole);
    drop_overdrawn(*job_, *benches_, answer_.notes);
    for (std::size_t b = 0; b < benches_->size(); ++b) {
      if (!on_bench_[b].empty()) {
        Job there = *job_;
        there.start = *(*benches_)[b].start;
        (*benches_)[b].places = places_after(list_, on_bench_[b].back(), there, room_of(b));
      }
    }
  }

  void take_first_off(const std::vector<Block>& done, std::vector<Block>& first) {
    const std::size_t before = first.size();
    drop_first(done, first);
    if (first.size() < before) {
      answer_.notes.push_back(fmt::format("{}: {} of {} done already", words_->first_tests,
                                          before - first.size(), count_of(before, "set-up")));
    }
  }

  const DoneOptions* options_;
  const DoneWords* words_;
  Job* job_;
  std::vector<Bench>* benches_;
  std::string name_;
  DoneList list_;
  std::vector<std::string> no_benches_;             // named by tests; "" for none
  std::vector<std::vector<std::size_t>> on_bench_;  // by bench: its tests
  std::optional<std::size_t> last_;
  std::uint64_t on_none_ = 0;
  std::uint64_t all_ = 0;
  std::uint64_t failed_with_gone_ = 0;
  std::uint64_t not_run_ = 0;
  std::uint64_t large_ = 0;  // tests with more parts than fit now
  std::optional<std::size_t> first_large_;
  bool has_results_ = false;
  HiddenTests hidden_;
  ReadJob answer_;
};

}  // namespace

ReadJob take_done(const std::vector<std::unique_ptr<Input>>& inputs, const DoneOptions& options,
                  const DoneWords& words, Job& job, std::vector<Bench>& benches) {
  return DoneTaker(options, words, job, benches).take(inputs);
}

}  // namespace changeover
