// Results that are lost, changed or claimed falsely, and those who want the same file at the same
// time.
#include "changeover/loadorder/all_pairs.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::job_results_test {
namespace {

constexpr std::uint64_t items = 12;
constexpr std::uint64_t bytes = items * items * sizeof(std::uint64_t);

/// A number for each pair, in a table.
class Table final : public JobResults {
 public:
  explicit Table(const std::string& path) : path_(path), file_(path) {}

  [[nodiscard]] std::string describe() const override { return path_; }
  void open(const ResultsClaim& claim) override { file_.open(bytes, claim); }
  Checksum checksum(const StepPairs& done) override {
    Sha256 hash;
    for (const auto& [x, y] : done.pairs) {
      std::uint64_t value = 0;
      file_.read(&value, sizeof value, place(x, y));
      hash.add(&value, sizeof value);
    }
    return hash.finish();
  }
  void sync() override { file_.sync(); }

  void put(const PairWork& work) {
    std::uint64_t value = 1;
    for (const ItemView& view : {work.first, work.second}) {
      value = value * 1000 + std::to_integer<std::uint64_t>(view.bytes[0]);
    }
    file_.write(&value, sizeof value, place(work.first.item, work.second.item));
  }

 private:
  static std::uint64_t place(Element x, Element y) {
    return (x * items + y) * sizeof(std::uint64_t);
  }

  std::string path_;
  ResultFile file_;
};

/// A job whose data, journal and results are in their own folder.
struct Work {
  TemporaryFolder folder;
  LoadOrder order = plan_load_order(items, 4);
  AllPairsOptions options;

  Work() {
    spit(data(), "abcdefghijkl");
    options.journal = folder.file("journal");
  }

  [[nodiscard]] std::string data() const { return folder.file("data"); }
  [[nodiscard]] std::string results() const { return folder.file("results"); }

  AllPairsReport run() {
    FileItems file(data(), 1);
    Table table(results());
    options.results = &table;
    return all_pairs(
        file, order, [&](const PairWork& work) { table.put(work); }, options);
  }

  [[nodiscard]] std::uint64_t steps() const { return order.facts().steps; }
};

std::vector<std::string> lines_of_file(const std::string& path) {
  std::istringstream text(slurp(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

TEST(JobResults, AreFoundAgainOrComputedAgainWhateverWasDoneToThem) {
  Work work;
  ASSERT_TRUE(work.run().finished);
  const std::string right = slurp(work.results());
  const AllPairsReport again = work.run();
  EXPECT_EQ(again.steps_resumed, work.steps());
  EXPECT_EQ(again.steps_lost, 0U);
  EXPECT_EQ(again.loads, 0U);

  std::string changed = right;
  changed[5 * sizeof(std::uint64_t)] ^= 1;
  const std::string longer = right + "and more";
  for (const std::string& found :
       {std::string(), right.substr(0, 100), std::string(right.size(), '\0'), changed, longer}) {
    spit(work.results(), found);
    const AllPairsReport report = work.run();
    EXPECT_TRUE(report.finished);
    EXPECT_EQ(report.steps_resumed + report.steps_lost, work.steps());
    EXPECT_EQ(report.steps_lost > 0, found != longer);
    EXPECT_EQ(slurp(work.results()), right);
    if (found == changed) {
      EXPECT_EQ(report.steps_lost, 1U);
      EXPECT_LE(report.loads, 8U);  // what is in memory then, and no more
    }
  }
  std::filesystem::remove(work.results());
  EXPECT_EQ(work.run().steps_lost, work.steps());
  EXPECT_EQ(slurp(work.results()), right);
}

TEST(JobResults, OfScatteredLostStepsAreComputedAgainWithoutTheOthers) {
  Work work;
  work.run();
  const std::string right = slurp(work.results());
  for (std::size_t apart : {3U, 7U, 20U}) {
    std::string changed = right;
    for (std::size_t i = 0; i < items; ++i) {
      char& byte = changed[(i * items + i) * sizeof(std::uint64_t)];
      byte = static_cast<char>(byte ^ (i % apart == 0 ? 1 : 0));
    }
    spit(work.results(), changed);
    const AllPairsReport report = work.run();
    EXPECT_GT(report.steps_lost, 0U);
    EXPECT_GT(report.steps_resumed, 0U);
    EXPECT_LE(report.most_in_memory, 4U);
    EXPECT_EQ(slurp(work.results()), right);
    EXPECT_EQ(work.run().steps_resumed, work.steps());  // the second line of a step counts
  }
}

TEST(JobResults, AreNotTouchedByAJobThatIsRefused) {
  Work work;
  work.run();
  const std::string right = slurp(work.results());
  const std::string journal = slurp(work.options.journal);
  work.options.job = "another";
  EXPECT_THROW(work.run(), BadInput);
  work.options.job = "";
  spit(work.data(), "abcdefghijkz");
  try {
    work.run();
    ADD_FAILURE() << "results of other data were taken";
  } catch (const BadInput& fault) {
    EXPECT_NE(std::string(fault.what()).find("time and contents of the data"), std::string::npos);
  }
  EXPECT_EQ(slurp(work.results()), right);
  EXPECT_EQ(slurp(work.options.journal), journal);
}

TEST(JobResults, OfDataThatChangedWhileTheyWereReadAreAFault) {
  Work work;
  work.options.on_step_done = [&](std::uint64_t step) {
    if (step == 3) {
      // In place: a file that is created again is empty for a moment, and another thread may read
      // then.
      std::fstream(work.data(), std::ios::in | std::ios::out | std::ios::binary).seekp(11).put('z');
    }
  };
  EXPECT_REFUSAL(work.run(), BadInput,
                 ": has changed while it was read, so the results are of neither; start again");
  work.options.on_step_done = nullptr;
  EXPECT_THROW(work.run(), BadInput);  // the journal is of the data before
  std::filesystem::remove(work.options.journal);
  EXPECT_TRUE(work.run().finished);
}

TEST(JobResults, ThatAreRemovedWhileTheyAreWrittenAreAFault) {
  Work work;
  work.options.on_step_done = [&](std::uint64_t step) {
    if (step == 3) {
      std::filesystem::remove(work.results());
    }
  };
  EXPECT_REFUSAL(work.run(), MissingResource,
                 ": was removed, replaced or resized while it was written; start again");
  work.options.journal = "";
  EXPECT_REFUSAL(work.run(), MissingResource,
                 ": was removed, replaced or resized while it was written; start again");
}

TEST(JobResults, OfDataWhoseTimeWasSetBackAreNotTaken) {
  Work work;
  work.run();
  struct stat before {};
  ASSERT_EQ(::stat(work.data().c_str(), &before), 0);
  spit(work.data(), "abcdefghijkz");
  const timespec times[2] = {before.st_atim, before.st_mtim};
  ASSERT_EQ(::utimensat(AT_FDCWD, work.data().c_str(), times, 0), 0);
  EXPECT_THROW(work.run(), BadInput);
}

TEST(JobResults, OfAFunctionAreThoseOfItsFingerprint) {
  const TemporaryFolder folder;
  const LoadOrder order = plan_load_order(items, 4);
  const auto run = [&](const std::string& fingerprint) {
    CallbackItems source(
        items, 1,
        [](Element item, std::span<std::byte> buffer) -> std::size_t {
          buffer[0] = static_cast<std::byte>(item);
          return 1;
        },
        "a function", fingerprint);
    Table table(folder.file("results"));
    AllPairsOptions options;
    options.journal = folder.file("journal");
    options.results = &table;
    return all_pairs(
               source, order, [&](const PairWork& work) { table.put(work); }, options)
        .steps_resumed;
  };
  EXPECT_EQ(run("version 1"), 0U);
  EXPECT_EQ(run("version 1"), order.facts().steps);
  EXPECT_THROW(run("version 2"), BadInput);
}

// The journal as its description says, for whatever steps and checksums.
std::string forged(const std::string& head, const std::vector<std::string>& records) {
  std::string text = head + "\n";
  Checksum chain = sha256(text);
  for (const std::string& record : records) {
    Sha256 hash;
    hash.add(chain);
    hash.add(record);
    chain = hash.finish();
    text += record + " " + to_hex(chain).substr(0, 32) + "\n";
  }
  return text;
}

TEST(Journal, ThatIsForgedClaimsNothingThatItsChecksumsDoNotCarry) {
  Work work;
  work.run();
  const std::string right = slurp(work.results());
  const std::vector<std::string> lines = lines_of_file(work.options.journal);
  std::vector<std::string> records;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    records.push_back(lines[i].substr(0, lines[i].rfind(' ')));
  }
  // The description above is right, or nothing below is tried.
  ASSERT_EQ(forged(lines[0], records), slurp(work.options.journal));
  std::vector<std::vector<std::string>> forgeries;
  std::vector<std::string> none;
  std::vector<std::string> without;
  for (std::size_t i = 0; i < records.size(); ++i) {
    none.push_back("step " + std::to_string(i + 1) + " " + to_hex(sha256("nothing")));
    without.push_back("step " + std::to_string(i + 1) + " -");
  }
  forgeries = {none, without, {records.rbegin(), records.rend()}};
  for (const std::string& found : {right, std::string(right.size(), '\0'), std::string()}) {
    for (const auto& forgery : forgeries) {
      spit(work.options.journal, forged(lines[0], forgery));
      spit(work.results(), found);
      const AllPairsReport report = work.run();
      EXPECT_TRUE(report.finished);
      EXPECT_EQ(slurp(work.results()), right);
      // Only true checksums of results that are there are believed; their order does not matter.
      const bool is_true = forgery == forgeries[2] && found == right;
      EXPECT_EQ(report.steps_resumed, is_true ? work.steps() : 0U);
    }
  }
  for (const std::string& record : {std::string("step 0 -"), "step 999 " + to_hex(sha256("")),
                                    std::string("step 18446744073709551616 -")}) {
    spit(work.options.journal, forged(lines[0], {record}));
    EXPECT_NE(work.run().note, "");
    EXPECT_EQ(slurp(work.results()), right);
  }
}

void edit_and_run(int edits) {
  Work work;
  work.run();
  const std::string right = slurp(work.results());
  const std::string journal = slurp(work.options.journal);
  std::uint32_t state = static_cast<std::uint32_t>(edits);
  int refused = 0;
  for (int i = 0; i < edits; ++i) {
    state = state * 1664525 + 1013904223;
    const std::size_t at = (state >> 8) % journal.size();
    std::string edited = journal;
    switch (i % 4) {
      case 0:
        edited[at] = static_cast<char>(edited[at] ^ 1);
        break;
      case 1:
        edited.erase(at, 1 + static_cast<std::size_t>(i % 50));
        break;
      case 2:
        edited.insert(at, journal.substr(journal.size() / 2, 105));
        break;
      default:
        edited.resize(at);
        break;
    }
    spit(work.options.journal, edited);
    spit(work.results(), std::string(bytes, '\0'));
    try {
      const AllPairsReport report = work.run();
      EXPECT_TRUE(report.finished);
      EXPECT_EQ(report.steps_resumed, 0U);
      EXPECT_EQ(slurp(work.results()), right) << i;
    } catch (const BadInput& fault) {
      ++refused;
      EXPECT_EQ(slurp(work.options.journal), edited);
      EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_LT(refused, edits / 2);
}

TEST(Journal, ThatIsEditedAnywhereIsBelievedUpToThereAtMost) { edit_and_run(32); }

TEST(Journal, ThatIsEditedAnywhereIsBelievedUpToThereAtMostSlow) { edit_and_run(400); }

TEST(Journal, IsRefusedBeforeMuchOfAnotherFileIsRead) {
  Work work;
  const int file = ::open(work.options.journal.c_str(), O_CREAT | O_WRONLY, 0666);
  ASSERT_EQ(::ftruncate(file, off_t{1} << 40), 0);
  ::close(file);
  EXPECT_THROW(work.run(), BadInput);
  EXPECT_FALSE(std::filesystem::exists(work.results()));
  for (const std::string& device : {std::string("/dev/null"), work.folder.path().string()}) {
    work.options.journal = device;
    EXPECT_THROW(work.run(), Error);
  }
}

TEST(Journal, GoesAwayAgainIfTheJobCannotBegin) {
  Work work;
  std::filesystem::create_directory(work.results());
  EXPECT_REFUSAL(work.run(), Error, "cannot be opened for writing");
  EXPECT_FALSE(std::filesystem::exists(work.options.journal));
}

ResultsClaim claim(const std::string& job, std::uint64_t index = 0, std::uint64_t of = 1) {
  return {sha256(job), {index, of}};
}

TEST(ResultFile, BelongsToOneJobAndToOneProcessOfEachShare) {
  const TemporaryFolder folder;
  const std::string path = folder.file("results");
  {
    ResultFile first(path);
    first.open(1000, claim("a", 0, 3));
    first.write("x", 1, 999);
    ResultFile second(path);
    second.open(1000, claim("a", 2, 3));
    const std::string another = ": another job writes its results there; wait until it finishes";
    for (const auto& [other, words] : std::vector<std::pair<ResultsClaim, std::string>>{
             {claim("b", 1, 3), another},
             {claim("b"), another},
             {claim("a", 0, 3),
              ": another process computes share 0 of 3 of this job; wait until it finishes"}}) {
      ResultFile refused(path);
      EXPECT_REFUSAL(refused.open(10, other), MissingResource, words);
      EXPECT_EQ(std::filesystem::file_size(path), 1000U);
    }
    ResultFile third(path);
    third.open(1000, claim("a", 1, 3));
    char last = ' ';
    third.read(&last, 1, 999);
    EXPECT_EQ(last, 'x');
    EXPECT_REFUSAL(third.read(&last, 1, 1000), MissingResource,
                   ": has become shorter while it was written; leave it alone");
  }
  ResultFile next(path);
  next.open(10, claim("b"));
  EXPECT_EQ(std::filesystem::file_size(path), 10U);
}

TEST(ResultFile, IsNeverGivenToTwoJobsThatComeAtOnce) {
  const TemporaryFolder folder;
  const std::string path = folder.file("results");
  for (int round = 0; round < 20; ++round) {
    std::vector<pid_t> children;
    for (int job = 0; job < 4; ++job) {
      const pid_t child = ::fork();
      if (child == 0) {
        ResultFile file(path);
        try {
          file.open(8, claim(std::to_string(job)));
        } catch (const MissingResource&) {
          ::_exit(0);
        }
        // No other process writes while this one does.
        bool alone = true;
        for (int i = 0; i < 20; ++i) {
          int seen = 0;
          file.write(&job, sizeof job, 0);
          ::usleep(100);
          file.read(&seen, sizeof seen, 0);
          alone &= seen == job;
        }
        ::_exit(alone ? 0 : 1);
      }
      children.push_back(child);
    }
    for (const pid_t child : children) {
      int status = 0;
      ::waitpid(child, &status, 0);
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
  }
}

TEST(ResultFile, ThatDoesNotFitLeavesTheOldOneAsItWas) {
  const TemporaryFolder folder;
  const std::string path = folder.file("results");
  const auto open_limited = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{10'000, 10'000};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ResultFile file(path);
      try {
        file.open(20'000, claim("a"));
      } catch (const MissingResource&) {
        ::_exit(4);
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  EXPECT_EQ(open_limited(), 4);
  EXPECT_FALSE(std::filesystem::exists(path));
  spit(path, "precious");
  EXPECT_EQ(open_limited(), 4);
  EXPECT_EQ(slurp(path), "precious");
  ResultFile file(path);
  EXPECT_REFUSAL(file.open(UINT64_MAX, claim("a")), MissingResource,
                 "bytes of results; compute fewer");
  EXPECT_REFUSAL(ResultFile("/dev/null").open(1, claim("a")), BadInput,
                 ": is not a regular file, so results cannot be written into it; name another");
}

TEST(JobThreads, ThatCannotBeStartedAreOneFaultAndNoAbort) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer needs more address space than a limit leaves";
#endif
  const pid_t child = ::fork();
  if (child == 0) {
    // Room for some stacks, not for a thousand.
    const rlimit limit{rlim_t{1} << 30, rlim_t{1} << 30};
    ::setrlimit(RLIMIT_AS, &limit);
    CallbackItems source(5, 16, [](Element, std::span<std::byte>) -> std::size_t { return 16; });
    int faults = 0;
    for (const bool readers : {false, true}) {
      AllPairsOptions options;
      (readers ? options.readers : options.threads) = 4000;
      try {
        all_pairs(
            source, plan_load_order(5, 3), [](const PairWork&) {}, options);
      } catch (const MissingResource& fault) {
        faults += std::string(fault.what()).find("use fewer") != std::string::npos ? 1 : 0;
      } catch (const std::bad_alloc&) {
        ++faults;
      }
    }
    ::_exit(faults == 2 ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  CallbackItems source(5, 16, [](Element, std::span<std::byte>) -> std::size_t { return 16; });
  for (const unsigned many : {most_job_threads + 1, UINT_MAX}) {
    AllPairsOptions options;
    options.threads = many;
    EXPECT_REFUSAL(all_pairs(
                       source, plan_load_order(5, 3), [](const PairWork&) {}, options),
                   BadInput, std::to_string(many) + " threads are too many; give at most 4096");
    options.threads = 1;
    options.readers = many;
    EXPECT_REFUSAL(all_pairs(
                       source, plan_load_order(5, 3), [](const PairWork&) {}, options),
                   BadInput, std::to_string(many) + " readers are too many; give at most 4096");
  }
}

}  // namespace
}  // namespace changeover::test::job_results_test
