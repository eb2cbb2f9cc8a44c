// Removes tests that were done from a job.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"
#include "core/contains.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {
namespace {

bool is_in_doubt(TestResult result) {
  return result == TestResult::fail || result == TestResult::unread;
}

}  // namespace

Meetings::Meetings(std::uint64_t parts, bool triples)
    : parts_(static_cast<std::size_t>(parts)),
      words_((parts_ + 63) / 64),
      together_(words_),
      pairs_(parts_ * words_),
      triples_(triples ? parts_ * parts_ * words_ : 0) {}

void Meetings::look_at(const Job& job, const Block& setup) {
  together_.assign(words_, 0);
  for (const Element x : setup) {
    if (x >= parts_) {
      throw BadInput(
          fmt::format("a test that was done names part {} of {}; name parts that there are",
                      std::uint64_t{x} + 1, parts_));
    }
    if (has(together_, 0, x)) {
      throw BadInput(
          fmt::format("a test that was done has {} twice; name each part once", job.names[x]));
    }
    together_[x / 64] |= std::uint64_t{1} << (x % 64);
  }
}

void Meetings::add(const Job& job, const Block& setup) {
  look_at(job, setup);
  const auto join = [&](Bits& bits, std::size_t row) {
    for (std::size_t w = 0; w < words_; ++w) {
      bits[row * words_ + w] |= together_[w];
    }
  };
  if (const auto hiding = out_of_range(job, setup)) {
    if (!has_two_out_of_range(job, setup)) {
      add_hidden(setup, *hiding);
    }
    return;
  }
  for (const Element x : setup) {
    join(pairs_, x);
    for (std::size_t i = 0; !triples_.empty() && i < setup.size(); ++i) {
      join(triples_, x * parts_ + setup[i]);
    }
  }
}

// Only what is together with this part counts: its pairs and triples.
void Meetings::add_hidden(const Block& setup, Element hiding) {
  const auto set = [&](Bits& bits, std::size_t row, Element column) {
    bits[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
  };
  for (const Element x : setup) {
    set(pairs_, x, hiding);
    set(pairs_, hiding, x);
    for (std::size_t i = 0; !triples_.empty() && i < setup.size(); ++i) {
      const Element y = setup[i];
      set(triples_, x * parts_ + y, hiding);
      set(triples_, x * parts_ + hiding, y);
      set(triples_, hiding * parts_ + x, y);
    }
  }
}

Block what_stays(const Job& job, const Block& setup, std::optional<std::uint64_t> room) {
  Block kept = setup;
  std::uint64_t left = room.value_or(job.at_once);
  if (kept.size() > left) {
    const auto is_needed = [&](Element x) { return contains(job.mounted, x); };
    const auto needed = static_cast<std::uint64_t>(std::ranges::count_if(kept, is_needed));
    left -= std::min(left, needed);
    std::erase_if(kept, [&](Element x) { return !is_needed(x) && (left == 0 || left-- == 0); });
  }
  return kept;
}

void mark_done(Job& job, const std::vector<Block>& setups) {
  std::vector<DoneTest> tests;
  tests.reserve(setups.size());
  for (const Block& setup : setups) {
    tests.push_back({setup, TestResult::done});
  }
  mark_tested(job, tests);
}

void mark_tested(Job& job, const std::vector<DoneTest>& tests, FailedTests failed) {
  const bool triples = !job.triples.empty();
  const bool trusted = failed == FailedTests::trusted;
  Meetings sure(job.parts(), triples);
  Meetings in_doubt(job.parts(), triples);
  const DoneTest* last = nullptr;
  std::uint64_t count = 0;
  for (const DoneTest& test : tests) {
    stop_if_asked();
    if (test.result == TestResult::not_run) {
      continue;
    }
    Meetings& met = is_in_doubt(test.result) ? in_doubt : sure;
    test.hidden ? met.look_at(job, test.setup) : met.add(job, test.setup);
    last = &test;
    ++count;
  }
  std::uint64_t only_in_failed = 0;
  PairSet rest(job.parts());
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (sure.met(x, y)) {
      return;
    }
    const bool doubtful = in_doubt.met(x, y);
    only_in_failed += doubtful && !triples ? 1U : 0U;
    if (!doubtful || !trusted) {
      rest.insert(x, y);
    }
  });
  job.needed = std::move(rest);
  drop_met_triples(job, sure);
  for (const Triple& t : job.triples) {
    only_in_failed += in_doubt.met(t) ? 1U : 0U;
  }
  if (trusted) {
    drop_met_triples(job, in_doubt);
  }
  job.met_only_in_failed += only_in_failed;
  job.trust_failed = trusted;
  job.tests_done += count;
  if (job.start.empty() && last != nullptr) {
    job.start = what_stays(job, last->setup);
  }
}

}  // namespace changeover
