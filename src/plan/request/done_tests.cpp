#include "plan/request/done_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
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

// Where a place of this number is in a list, or is put now.
std::size_t index_of(std::vector<DonePlace>& places, const DonePlace& place) {
  const auto found = std::ranges::find_if(places, [&](const DonePlace& each) {
    return each.number == place.number && each.slot == place.slot;
  });
  const auto index = static_cast<std::size_t>(found - places.begin());
  if (found == places.end()) {
    places.push_back(place);
  }
  return index;
}

// A list goes on with another: places with the same heads are the same.
void append(DoneList& list, DoneList more) {
  std::vector<std::size_t> indices;
  for (const DonePlace& place : more.places) {
    indices.push_back(index_of(list.places, place));
  }
  const auto in_their_places = [&](auto& rows) {
    for (auto& row : rows) {
      auto placed = row;
      placed.assign(list.places.size(), {});
      for (std::size_t i = 0; i < row.size(); ++i) {
        placed[indices[i]] = std::move(row[i]);
      }
      row = std::move(placed);
    }
  };
  in_their_places(more.in_place);
  in_their_places(more.written);
  for (auto& row : list.in_place) {
    row.resize(list.places.size());
  }
  for (auto& row : list.written) {
    row.resize(list.places.size());
  }
  const auto add = [](auto& all, auto& others) {
    all.insert(all.end(), std::make_move_iterator(others.begin()),
               std::make_move_iterator(others.end()));
  };
  add(list.setups, more.setups);
  add(list.results, more.results);
  for (std::string& name : more.gone) {
    if (std::ranges::find(list.gone, name) == list.gone.end()) {
      list.gone.push_back(std::move(name));
    }
  }
  list.lacks.insert(list.lacks.end(), more.lacks.begin(), more.lacks.end());
  add(list.lines, more.lines);
  add(list.unread, more.unread);
  add(list.in_place, more.in_place);
  add(list.written, more.written);
  add(list.notes, more.notes);
}

// Keeps a test for the sheet of those that were done; without places, in the order in which its
// parts are written.
void record_test(DoneRecord& record, const DoneList& list, std::size_t test, const Job& job) {
  std::vector<DonePlace> places = list.places;
  std::vector<std::string> parts = list.written[test];
  if (places.empty()) {
    for (const Element x : list.setups[test]) {
      places.push_back({.number = places.size() + 1});
      parts.push_back(job.names[x]);
    }
  }
  DoneRecord::Test& kept = record.tests.emplace_back();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t index = index_of(record.places, places[i]);
    kept.parts.resize(std::max(kept.parts.size(), index + 1));
    kept.parts[index] = parts[i];
  }
  kept.result = list.results[test].empty() ? "done" : list.results[test];
  kept.notes = list.notes[test];
}

// The places of the bench as the test says after which the plan goes on, with what is in them.
std::vector<MountedPlace> places_after(const DoneList& list, std::size_t test, const Job& job) {
  const bool slots_are_named =
      std::ranges::any_of(list.places, [](const DonePlace& place) { return !place.slot.empty(); });
  const auto slot_of = [&](Element x) { return job.slots.empty() ? no_slot : job.slot_of[x]; };
  std::vector<MountedPlace> places;
  for (std::size_t i = 0; i < list.places.size(); ++i) {
    const DonePlace& column = list.places[i];
    const auto& part = list.in_place[test].at(i);
    const auto named = std::ranges::find(job.slots, column.slot, &Slot::name);
    const bool is_known = column.slot.empty() ? job.slots.empty() || slots_are_named || part
                                              : named != job.slots.end() || part;
    const bool is_there =
        std::ranges::find(places, column.number, &MountedPlace::number) != places.end();
    if (!is_known || is_there || column.number == 0) {
      continue;  // of a slot that there is no more
    }
    MountedPlace place{.number = column.number};
    if (!column.slot.empty() && named != job.slots.end()) {
      place.slot = static_cast<std::uint32_t>(named - job.slots.begin());
    } else if (part && !(column.slot.empty() && slots_are_named)) {
      place.slot = slot_of(*part);
    }
    if (part && slot_of(*part) == place.slot &&
        std::ranges::find(job.start, *part) != job.start.end()) {
      place.part = part;
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace

AskedJob take_done(const std::vector<std::unique_ptr<Input>>& inputs, const DoneOptions& options,
                   const DoneWords& words, Job& job) {
  DoneList list;
  for (const auto& each : inputs) {
    append(list, read_done(*each, job));
  }
  const Input& input = *inputs.back();
  const std::size_t all = list.setups.size();
  if (options.first.value_or(0) > all) {
    throw BadOption(fmt::format("{} {}: {} has {}", words.done_first, *options.first, input.name(),
                                count_of(all, "set-up")));
  }
  if (options.all_parts_known && !list.gone.empty()) {
    throw BadInput(
        fmt::format("{}: {}", input.name(), PartFinder(job).complaint(list.gone.front())));
  }
  AskedJob answer;
  answer.done_from = input.name();
  const bool has_results = list.has_results();
  std::vector<DoneTest>& done = answer.done;
  std::uint64_t failed_with_gone = 0;
  std::uint64_t not_run = 0;
  std::optional<std::size_t> last;
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
    record_test(answer.record, list, i, job);
    last = i;
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
  if (last) {
    job.places = places_after(list, *last, job);
  }
  return answer;
}

}  // namespace changeover
