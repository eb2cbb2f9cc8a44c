// Journals at random: read as they were written; damaged, whole lines from the beginning count and
// nothing else does, and what is recorded from there on is read.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>

#include "damage.hpp"
#include "loadorder/run/journal.hpp"
#include "run_program.hpp"

namespace changeover::test::journal_property_test {
namespace {

using Records = std::vector<JournalRecord>;

constexpr std::uint64_t steps = 20;

// A job, and what was recorded of it.
struct Story {
  std::vector<JournalField> job;
  Records records;
};

Records some_records() {
  Records records(some_number(3));
  for (JournalRecord& record : records) {
    record.step = 1 + some_number(steps - 1);
    if (some_number(1) == 1) {
      record.results = sha256(std::to_string(some_number(1000)));
    }
  }
  return records;
}

Story some_story() {
  Story story;
  for (std::uint64_t fields = 1 + some_number(2); fields > 0; --fields) {
    story.job.push_back(
        {some_text({"items", "order", "é"}, 2), some_text({"10", "a name", "; ", "\n", "漢"}, 3)});
  }
  story.records = some_records();
  return story;
}

std::string path() {
  static const TemporaryFolder folder;
  return folder.file("journal");
}

void put(const std::string& text) {
  std::filesystem::remove(path());
  spit(path(), text);
}

bool same(const Records& a, const Records& b) {
  return std::ranges::equal(a, b, [](const JournalRecord& x, const JournalRecord& y) {
    return x.step == y.step && x.results == y.results;
  });
}

void record(const Story& story) {
  Journal journal(path(), story.job, steps);
  journal.begin();
  for (const JournalRecord& each : story.records) {
    journal.record(each);
  }
}

// A line behind others, whose chain is moved on.
std::string line_behind(Checksum& chain, const std::string& step, const std::string& results) {
  const std::string line = "step " + step + " " + results;
  Sha256 hash;
  hash.add(chain);
  hash.add(line);
  chain = hash.finish();
  return line + " " + to_hex(chain).substr(0, 32) + "\n";
}

// The journal as the format says, by code that does not wait for disks.
std::string written(const Story& story) {
  std::string text = "changeover journal 2: ";
  for (const JournalField& field : story.job) {
    text += field.name + " " + field.value + "; ";
  }
  std::ranges::replace(text, '\n', ' ');
  text.back() = '\n';
  Checksum chain = sha256(text);
  for (const JournalRecord& each : story.records) {
    text +=
        line_behind(chain, std::to_string(each.step), each.results ? to_hex(*each.results) : "-");
  }
  return text;
}

RC_GTEST_PROP(JournalProperty, IsReadAsItWasWritten, ()) {
  const Story story = some_story();
  std::filesystem::remove(path());
  record(story);
  RC_ASSERT(slurp(path()) == written(story));
  const Journal journal(path(), story.job, steps);
  RC_ASSERT(same(journal.records(), story.records));
  RC_ASSERT(journal.note().empty());
}

// What is read of a file: nothing if it is refused.
std::optional<Records> read(const Story& story, const std::string& text) {
  put(text);
  std::optional<Records> records;
  accepted(path(), [&] {
    const Journal journal(path(), story.job, steps);
    records = journal.records();
    RC_ASSERT((journal.note().empty() || journal.note().starts_with(path())));
    RC_ASSERT(is_printable(journal.note()));
  });
  RC_ASSERT(slurp(path()) == text);
  return records;
}

RC_GTEST_PROP(JournalProperty, DamagedItHoldsABeginningOrIsRefused,
              (const std::vector<Damage>& damages)) {
  Story story = some_story();
  const std::string good = written(story);
  for (std::size_t i = 0; i < damages.size() && i < 10; ++i) {
    const auto records = read(story, damages[i].of(good));
    if (!records) {
      continue;
    }
    RC_ASSERT(records->size() <= story.records.size());
    RC_ASSERT(same(*records,
                   Records(story.records.begin(),
                           story.records.begin() + static_cast<std::ptrdiff_t>(records->size()))));
  }
}

// Lines of another journal of the same job count for nothing, whole as they are.
RC_GTEST_PROP(JournalProperty, LinesOfAnotherJournalCountForNothing, ()) {
  const Story story = some_story();
  const Story other{story.job, some_records()};
  const std::string mine = written(story);
  const std::string theirs = written(other);
  const std::size_t head = mine.find('\n') + 1;
  const auto records = read(story, mine + theirs.substr(head));
  RC_ASSERT(records.has_value());
  const Records& expected =
      story.records.empty() ? other.records : story.records;  // behind the same first line
  RC_ASSERT(same(*records, expected));
}

RC_GTEST_PROP(JournalProperty, WhatIsRecordedAfterDamageIsRead, (const Damage& damage)) {
  Story story = some_story();
  const auto before = read(story, damage.of(written(story)));
  RC_PRE(before.has_value());
  Story more{story.job, some_records()};
  record(more);
  Records all = *before;
  all.insert(all.end(), more.records.begin(), more.records.end());
  const Journal journal(path(), story.job, steps);
  RC_ASSERT(same(journal.records(), all));
  RC_ASSERT(journal.note().empty());
}

// A line that continues those before it, as a program that knows the format may write: only steps
// of the job
// are taken.
RC_GTEST_PROP(JournalProperty, WithRightChecksumsOnlyStepsOfTheJobCount,
              (const std::vector<Damage>& damages)) {
  const Story story = some_story();
  const std::string head = written({story.job, {}});
  for (std::size_t i = 0; i < damages.size() && i < 10; ++i) {
    const std::string number = damages[i].of("17");
    const std::string results = damages[i].of(some_number(1) == 0 ? "-" : to_hex(sha256(number)));
    const std::string line = "step " + number + " " + results;
    Sha256 hash;
    hash.add(sha256(head));
    hash.add(line);
    const auto records =
        read(story, head + line + " " + to_hex(hash.finish()).substr(0, 32) + "\n");
    RC_ASSERT(records.has_value());
    RC_ASSERT(records->size() <= 1);
    if (!records->empty()) {
      RC_ASSERT(std::to_string(records->front().step) == number);
      RC_ASSERT(records->front().step >= 1);
      RC_ASSERT(records->front().step <= steps);
      RC_ASSERT((records->front().results ? to_hex(*records->front().results) : "-") == results);
    }
  }
}

}  // namespace
}  // namespace changeover::test::journal_property_test
