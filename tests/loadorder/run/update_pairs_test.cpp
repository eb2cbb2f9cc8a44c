// Items that change, killed at every write: the result is that of a run without a crash, byte for
// byte.
#include "changeover/loadorder/all_pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::update_pairs_test {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t item_bytes = 24;

std::string content(std::uint64_t items) {
  std::string text;
  for (std::uint64_t i = 0; i < items * item_bytes; ++i) {
    text.push_back(static_cast<char>(i * i + 17 * i));
  }
  return text;
}

/// Depends on how often and in which order it is applied.
void mix(std::span<std::byte> a, std::span<std::byte> b, std::uint64_t step) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto x = std::to_integer<unsigned>(a[i]);
    const auto y = std::to_integer<unsigned>(b[i]);
    a[i] = static_cast<std::byte>(5 * x + 3 * y + 1);
    b[i] = static_cast<std::byte>(7 * y + x + step);
  }
}

PairUpdater mixer() {
  return [](const PairUpdate& pair) { mix(pair.first.bytes, pair.second.bytes, pair.step); };
}

/// In memory: no executor, no files.
std::string expected(const LoadOrder& order, std::string data, const ComputeRules& how = {}) {
  StepWork work(order.stream(), order.rules(how));
  for (Step step; work.next(step);) {
    for (const auto& [x, y] : step.compute) {
      const auto all = std::as_writable_bytes(std::span(data));
      mix(all.subspan(x * item_bytes, item_bytes), all.subspan(y * item_bytes, item_bytes),
          step.number);
    }
  }
  return data;
}

UpdateOptions options_in(const TemporaryFolder& folder, std::uint64_t checkpoint_every = 3) {
  UpdateOptions options;
  options.data = folder.file("data");
  options.item_bytes = item_bytes;
  options.journal = folder.file("journal");
  options.checkpoint_every = checkpoint_every;
  return options;
}

TEST(UpdatePairs, RefusesNoStepBetweenCheckpoints) {
  const TemporaryFolder folder;
  spit(folder.file("data"), content(12));
  const LoadOrder order = plan_load_order(12, 4);
  EXPECT_THROW(update_pairs(order, mixer(), options_in(folder, 0)), BadInput);
}

TEST(UpdatePairs, GivesWhatIsComputedInMemory) {
  for (const auto& [items, room, workers] :
       {std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>{12, 4, 1},
        {12, 4, 2},
        {30, 5, 3},
        {16, 2, 8}}) {
    const LoadOrder order = plan_disjoint_order(items, room, workers);
    for (const std::uint64_t every : {1U, 4U, 1000U}) {
      const TemporaryFolder folder;
      spit(folder.file("data"), content(items));
      UpdateOptions options = options_in(folder, every);
      options.work = {.ordered = every == 4, .self = false, .shuffle = every};
      const UpdateReport report = update_pairs(order, mixer(), options);
      EXPECT_TRUE(report.finished);
      EXPECT_TRUE(slurp(folder.file("data")) == expected(order, content(items), options.work));
      EXPECT_EQ(report.updates, items * (items - 1) / (every == 4 ? 1 : 2));
      EXPECT_EQ(report.loads, order.facts().loads);
      EXPECT_LE(report.stores, report.loads);
      EXPECT_FALSE(std::filesystem::exists(folder.file("data.versions")));
      // Again: nothing is left to do.
      const UpdateReport again = update_pairs(order, mixer(), options);
      EXPECT_EQ(again.updates, 0U);
      EXPECT_TRUE(slurp(folder.file("data")) == expected(order, content(items), options.work));
    }
  }
}

// Runs the job in a process that kills itself before its n-th write. Whether it came to its end.
bool run_until(const LoadOrder& order, UpdateOptions options, int n) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::atomic<int> left = n;
    options.before_write = [&left] {
      if (--left == 0) {
        ::kill(::getpid(), SIGKILL);
      }
    };
    try {
      ::_exit(update_pairs(order, mixer(), options).finished ? 0 : 1);
    } catch (const std::exception&) {
      ::_exit(2);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << n;
  return !WIFSIGNALED(status);
}

TEST(UpdatePairs, KilledBeforeAnyWriteGoesOnToTheSameResult) {
  const LoadOrder order = plan_disjoint_order(8, 2, 2);
  const std::string right = expected(order, content(8));
  bool finished = false;
  int n = 1;
  for (; !finished; ++n) {
    const TemporaryFolder folder;
    spit(folder.file("data"), content(8));
    finished = run_until(order, options_in(folder), n);
    // Twice: the second crash is in what the first left.
    if (!finished && !run_until(order, options_in(folder), 1 + n % 7)) {
      EXPECT_TRUE(update_pairs(order, mixer(), options_in(folder)).finished);
    }
    ASSERT_TRUE(slurp(folder.file("data")) == right) << "killed before write " << n;
  }
  EXPECT_GT(n, 40);
}

TEST(UpdatePairs, KilledAtAnyMomentGoesOnToTheSameResult) {
  const LoadOrder order = plan_disjoint_order(24, 4, 2);
  const std::string right = expected(order, content(24));
  const TemporaryFolder folder;
  spit(folder.file("data"), content(24));
  int kills = 0;
  bool finished = false;
  for (std::uint32_t round = 0; round < 200 && !finished; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      try {
        ::_exit(update_pairs(order, mixer(), options_in(folder, 1)).finished ? 0 : 1);
      } catch (const std::exception&) {
        ::_exit(2);
      }
    }
    ::usleep(2000 + round * 7919 % 23000);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    finished = !WIFSIGNALED(status);
    kills += finished ? 0 : 1;
    if (finished) {
      EXPECT_EQ(WEXITSTATUS(status), 0);
    }
  }
  if (!finished) {
    EXPECT_TRUE(update_pairs(order, mixer(), options_in(folder, 1)).finished);
  }
  EXPECT_GE(kills, 1);
  EXPECT_TRUE(slurp(folder.file("data")) == right);
}

TEST(UpdatePairs, WithoutTheJournalWhatIsHalfChangedIsRefusedUnchanged) {
  const LoadOrder order = plan_disjoint_order(12, 3, 2);
  const TemporaryFolder folder;
  spit(folder.file("data"), content(12));
  ASSERT_FALSE(run_until(order, options_in(folder), 60));
  const std::string data = slurp(folder.file("data"));
  const std::string versions = slurp(folder.file("data.versions"));
  const std::string journal = slurp(folder.file("journal"));
  const auto refused = [&](const UpdateOptions& options, const std::string& says) {
    try {
      update_pairs(order, mixer(), options);
      ADD_FAILURE() << says;
    } catch (const BadInput& fault) {
      EXPECT_NE(std::string(fault.what()).find(says), std::string::npos) << fault.what();
    }
    EXPECT_EQ(slurp(folder.file("data")), data);
  };
  UpdateOptions other = options_in(folder);
  other.journal = folder.file("another");
  refused(other,
          " may be half changed; bring the journal back, or restore the data and remove this file");
  EXPECT_FALSE(std::filesystem::exists(folder.file("another")));
  other = options_in(folder);
  other.work.shuffle = 5;
  refused(other, "is the journal of another job");
  other = options_in(folder);
  other.job = "other";
  refused(other, "is the journal of another job");
  std::filesystem::rename(folder.file("data.versions"), folder.file("away"));
  refused(options_in(folder), "data.versions: is not there");
  std::filesystem::rename(folder.file("away"), folder.file("data.versions"));
  // A bit of what was committed, in one of the two files.
  std::size_t seen = 0;
  for (std::size_t at = 0; at < data.size(); at += item_bytes) {
    std::string wrong = data;
    wrong[at] = static_cast<char>(wrong[at] ^ 1);
    std::string wrong_version = versions;
    wrong_version[at] = static_cast<char>(wrong_version[at] ^ 1);
    spit(folder.file("data"), wrong);
    spit(folder.file("data.versions"), wrong_version);
    EXPECT_REFUSAL(
        update_pairs(order, mixer(), options_in(folder)), BadInput,
        ": something else has changed it; restore both, or restart from the original data")
        << at;
    EXPECT_EQ(slurp(folder.file("data")), wrong);
    ++seen;
  }
  EXPECT_EQ(seen, 12U);
  spit(folder.file("data"), data);
  spit(folder.file("data.versions"), versions);
  EXPECT_EQ(slurp(folder.file("journal")), journal);
  EXPECT_TRUE(update_pairs(order, mixer(), options_in(folder)).finished);
  EXPECT_TRUE(slurp(folder.file("data")) == expected(order, content(12)));
}

TEST(UpdatePairs, ADamagedJournalOrSecondFileIsRefusedUnchanged) {
  const LoadOrder order = plan_disjoint_order(12, 3, 2);
  const TemporaryFolder folder;
  spit(folder.file("data"), content(12));
  ASSERT_FALSE(run_until(order, options_in(folder, 1), 90));
  const std::string data = slurp(folder.file("data"));
  const std::string versions = slurp(folder.file("data.versions"));
  const std::string journal = slurp(folder.file("journal"));
  const auto refused = [&](const std::string& a_journal, const std::string& a_version,
                           const testing::Matcher<std::string>& said) {
    spit(folder.file("journal"), a_journal);
    spit(folder.file("data.versions"), a_version);
    EXPECT_THAT(message_of([&] { update_pairs(order, mixer(), options_in(folder, 1)); }), said);
    EXPECT_TRUE(slurp(folder.file("data")) == data);
    EXPECT_TRUE(slurp(folder.file("data.versions")) == a_version);
    EXPECT_EQ(slurp(folder.file("journal")), a_journal);
  };
  // A digit of each line, the last of which says where the items are.
  std::size_t lines = 0;
  for (std::size_t end = journal.find('\n', journal.find('\n') + 1); end != std::string::npos;
       end = journal.find('\n', end + 1)) {
    std::string wrong = journal;
    wrong[end - 1] = wrong[end - 1] == '0' ? '1' : '0';
    refused(
        wrong, versions,
        testing::AnyOf(
            HasSubstr("; restore both, or restart from the original data"),
            HasSubstr(
                " may be half changed; bring the journal back, or restore the data and remove both")));
    ++lines;
  }
  EXPECT_GE(lines, 2U);
  const auto size =
      HasSubstr("; restore both, or restore the data and remove this file and the journal");
  refused(journal, versions.substr(0, versions.size() - 1), size);
  refused(journal, versions + "x", size);
  std::filesystem::remove(folder.file("data.versions"));
  EXPECT_REFUSAL(update_pairs(order, mixer(), options_in(folder, 1)), BadInput,
                 " cannot go on; restore both, or restore the data and remove the journal");
  spit(folder.file("journal"), journal);
  spit(folder.file("data.versions"), versions);
  EXPECT_TRUE(update_pairs(order, mixer(), options_in(folder, 1)).finished);
  EXPECT_TRUE(slurp(folder.file("data")) == expected(order, content(12)));
}

TEST(UpdatePairs, StopsWithACheckpointWhenItIsCancelled) {
  const LoadOrder order = plan_disjoint_order(20, 4, 2);
  const TemporaryFolder folder;
  spit(folder.file("data"), content(20));
  std::atomic<bool> cancelled = false;
  UpdateOptions options = options_in(folder, 1000);
  options.cancelled = &cancelled;
  std::atomic<int> updates = 0;
  const UpdateReport report = update_pairs(
      order,
      [&](const PairUpdate& pair) {
        mix(pair.first.bytes, pair.second.bytes, pair.step);
        cancelled = ++updates > 60;
      },
      options);
  EXPECT_FALSE(report.finished);
  cancelled = false;
  const UpdateReport rest = update_pairs(order, mixer(), options);
  EXPECT_TRUE(rest.finished);
  EXPECT_EQ(rest.steps_resumed, report.steps_done);
  EXPECT_EQ(rest.updates + report.updates, 190U);
  EXPECT_TRUE(slurp(folder.file("data")) == expected(order, content(20)));
}

TEST(UpdatePairs, RefusesWhatIsWrongAndEndsWithWhatIsThrown) {
  const LoadOrder order = plan_disjoint_order(12, 3, 2);
  const TemporaryFolder folder;
  UpdateOptions options = options_in(folder);
  EXPECT_REFUSAL(update_pairs(order, mixer(), options), BadInput,
                 ": is not there, or not a regular file; name the file of the items");
  spit(folder.file("data"), content(11));
  EXPECT_THROW(update_pairs(order, mixer(), options), BadInput);
  spit(folder.file("data"), content(12));
  // An order that misses a step.
  LoadOrderFacts facts = order.facts();
  const LoadOrder idle(facts, [] { return plan_load_order(3, 3).stream(); });
  EXPECT_THROW(update_pairs(idle, mixer(), options), BadInput);
  EXPECT_THROW(update_pairs(
                   order,
                   [](const PairUpdate& pair) {
                     if (pair.first.item == 5) {
                       throw std::runtime_error("no");
                     }
                   },
                   options),
               std::runtime_error);
  options.journal.clear();
  EXPECT_THROW(update_pairs(order, mixer(), options), BadInput);
}

TEST(UpdatePairs, RefusesAJournalThatIsNoFile) {
  const LoadOrder order = plan_disjoint_order(12, 3, 2);
  const TemporaryFolder folder;
  spit(folder.file("data"), content(12));
  UpdateOptions options = options_in(folder);
  for (const std::string& path :
       {std::string("/dev/full"), std::string("/dev/null"), std::string(folder.path())}) {
    options.journal = path;
    EXPECT_REFUSAL(update_pairs(order, mixer(), options), BadInput,
                   path + ": is not a regular file, so it cannot be a journal; name another");
  }
  EXPECT_EQ(slurp(folder.file("data")), content(12));
  options.journal = folder.file("data") + "/below";
  EXPECT_REFUSAL(update_pairs(order, mixer(), options), MissingResource,
                 ": the journal cannot be opened");
}

}  // namespace
}  // namespace changeover::test::update_pairs_test
