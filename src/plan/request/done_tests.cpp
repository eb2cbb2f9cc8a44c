#include "plan/request/done_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {
namespace {

constexpr std::size_t few = 10;

Block in_order(Block setup) {
  std::sort(setup.begin(), setup.end());
  return setup;
}

void note_unread(const DoneOptions& options, const DoneWords& words, AskedJob& answer) {
  if (answer.unread == 0 || options.for_diagnosis) {
    return;
  }
  const UnreadResult& one = answer.first_unread.front();
  answer.notes.push_back(
      fmt::format("{}: the result {} is not understood{}; its pairs {}; write pass or fail",
                  one.place, shown(one.text),
                  answer.unread == 1 ? "" : fmt::format(", nor are {} others", answer.unread - 1),
                  fmt::format("count as tested{} {}",
                              options.failed == FailedTests::trusted ? ", by" : " only with",
                              words.trust_failed)));
}

void note_gone(const std::string& name, const std::vector<std::string>& gone,
               std::vector<std::string>& notes) {
  std::string names;
  for (std::size_t i = 0; i < std::min(few, gone.size()); ++i) {
    names += (i == 0 ? "" : ", ") + gone[i];
  }
  if (gone.size() > few) {
    names += fmt::format(" and {} more", gone.size() - few);
  }
  if (!gone.empty()) {
    notes.push_back(fmt::format("{}: no longer in the parts list, and left out: {}", name, names));
  }
}

// Those of the first tests that were done are not to be run again.
void drop_first(const std::vector<DoneTest>& done, Job& job) {
  std::map<Block, std::vector<std::size_t>> places;  // of each set-up, the last one first
  for (std::size_t i = job.first.size(); i-- > 0;) {
    places[in_order(job.first[i])].push_back(i);
  }
  std::vector<bool> is_done(job.first.size());
  for (const DoneTest& test : done) {
    const auto found = places.find(in_order(test.setup));
    if (found != places.end() && !found->second.empty()) {
      is_done[found->second.back()] = true;
      found->second.pop_back();
    }
  }
  std::size_t next = 0;
  std::erase_if(job.first, [&](const Block&) { return is_done[next++]; });
}

}  // namespace

AskedJob take_done(Input& input, const DoneOptions& options, const DoneWords& words, Job& job) {
  const DoneList list = read_done(input, job.names, job.at_once);
  const std::size_t all = list.setups.size();
  if (options.first.value_or(0) > all) {
    throw BadOption(fmt::format("{} {}: {} has {}", words.done_first, *options.first, input.name(),
                                count_of(all, "set-up")));
  }
  if (options.all_parts_known && !list.gone.empty()) {
    throw BadInput(
        fmt::format("{}: {}", input.name(), PartFinder(job.names).complaint(list.gone.front())));
  }
  AskedJob answer;
  answer.done_from = input.name();
  const bool has_results = list.has_results();
  std::vector<DoneTest>& done = answer.done;
  std::uint64_t failed_with_gone = 0;
  std::uint64_t not_run = 0;
  for (std::size_t i = 0; i < all; ++i) {
    const TestResult result = result_of(list.results[i]);
    const bool counts =
        options.first ? i < *options.first : !has_results || result != TestResult::none;
    if (!counts || result == TestResult::not_run) {
      not_run += counts ? 1U : 0U;
      answer.rest.push_back(list.setups[i]);
      continue;
    }
    done.push_back({list.setups[i], result});
    if (result == TestResult::fail && list.lacks[i]) {
      ++failed_with_gone;  // what is gone may be to blame: nothing else is
    } else if (result == TestResult::pass || result == TestResult::fail) {
      answer.results.push_back({list.setups[i], result == TestResult::fail});
    } else if (result == TestResult::unread && answer.unread++ < few) {
      answer.first_unread.push_back({list.unread[i], list.results[i]});
    }
  }
  if (failed_with_gone > 0) {
    answer.notes.push_back(fmt::format(
        "{}: {} failed with a part that is gone, which may be to blame: a diagnosis leaves {} out",
        input.name(), count_of(failed_with_gone, "test"), failed_with_gone == 1 ? "it" : "them"));
  }
  note_unread(options, words, answer);
  note_gone(input.name(), list.gone, answer.notes);
  if (not_run > 0) {
    answer.notes.push_back(fmt::format("{}: {} not run, by the column result, and {} not done",
                                       input.name(), count_of(not_run, "test was", "tests were"),
                                       not_run == 1 ? "is" : "are"));
  }
  if (!options.first && has_results && done.size() < all) {
    answer.notes.push_back(fmt::format("{}: {} of {} tests have a result and are done",
                                       input.name(), done.size(), all));
  }
  const std::size_t first = job.first.size();
  drop_first(done, job);
  if (job.first.size() < first) {
    answer.notes.push_back(fmt::format("{}: {} of {} done already", words.first_tests,
                                       first - job.first.size(), count_of(first, "set-up")));
  }
  mark_tested(job, done, options.failed);
  return answer;
}

}  // namespace changeover
