#include "search/local/checkpoint.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/verify/verdict.hpp"
#include "run_program.hpp"

namespace changeover::checkpoint_test {
namespace {

class Checkpoints : public testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("state"); }
  [[nodiscard]] std::string text() const { return test::slurp(path()); }
  void put(const std::string& all) const { test::spit(path(), all); }

  void expect_refused(const std::string& words, const Parameters& p) const {
    const std::string before = text();
    for (const bool searching : {false, true}) {
      try {
        if (searching) {
          RunControl control({});
          static_cast<void>(improve(p, {.moves = 1000, .checkpoint = path()}, control));
        } else {
          static_cast<void>(read_checkpoint(path(), p));
        }
        ADD_FAILURE() << "accepted: " << before;
      } catch (const BadInput& fault) {
        const std::string what = fault.what();
        EXPECT_NE(what.find(words), std::string::npos) << what;
        EXPECT_EQ(what.find(path()), 0U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      }
    }
    EXPECT_EQ(text(), before);
  }

  test::TemporaryFolder folder_;
};

// A search that does something whenever it tells how far it is, or the first time only.
RunControl::Settings doing(const std::function<void()>& act) {
  return {.seed = 7,
          .on_progress = [act](const Progress&) { act(); },
          .progress_interval = std::chrono::duration<double>(0)};
}
RunControl::Settings doing_once(bool& done, const std::function<void()>& act) {
  return doing([&done, act] {
    if (!std::exchange(done, true)) {
      act();
    }
  });
}

// Another process, until it is killed.
class Child {
 public:
  explicit Child(const std::function<void()>& work) : pid_(::fork()) {
    if (pid_ == 0) {
      try {
        work();
      } catch (...) {
        std::_Exit(1);
      }
      std::_Exit(0);
    }
  }
  // Whether it was still at work.
  [[nodiscard]] bool killed() const {
    int status = 0;
    return pid_ > 0 && ::kill(pid_, SIGKILL) == 0 && ::waitpid(pid_, &status, 0) == pid_ &&
           WIFSIGNALED(status);
  }

 private:
  pid_t pid_;
};

const Parameters asked{.v = 6, .k = 4, .change = 2, .kind = Kind::circular};

Checkpoint example() {
  Checkpoint checkpoint;
  checkpoint.parameters = asked;
  checkpoint.seed = 7;
  checkpoint.attempts = 41;
  checkpoint.moves = 123'456'789'012;
  checkpoint.arms = {{.method = SearchArm::Method::free, .budget = 5, .spent = 6, .missed = 2},
                     {.method = SearchArm::Method::imposed,
                      .order = 4,
                      .fixed = 0,
                      .extra = 2,
                      .budget = 1000,
                      .spent = 2000,
                      .step = 4,
                      .missed = 9}};
  checkpoint.how = "blocks without symmetry";
  checkpoint.best =
      verified(Design(asked, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}}));
  return checkpoint;
}

TEST_F(Checkpoints, ReadsWhatItWrote) {
  EXPECT_FALSE(read_checkpoint(path(), asked).has_value());
  const Checkpoint written = example();
  write_checkpoint(written, path());
  const std::string bytes = text();
  const auto read = read_checkpoint(path(), asked);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->seed, written.seed);
  EXPECT_EQ(read->attempts, written.attempts);
  EXPECT_EQ(read->moves, written.moves);
  EXPECT_EQ(read->arms, written.arms);
  EXPECT_EQ(read->how, written.how);
  ASSERT_TRUE(read->best.has_value());
  EXPECT_EQ(read->best->block_count(), 3U);
  write_checkpoint(*read, path());
  EXPECT_EQ(text(), bytes);
}

TEST_F(Checkpoints, IsRefusedForOtherParameters) {
  write_checkpoint(example(), path());
  Parameters other = asked;
  other.kind = Kind::linear;
  expect_refused("belongs to another search", other);
  expect_refused("belongs to another search", {.v = 20, .k = 5});
}

TEST_F(Checkpoints, IsRefusedWhenAnyByteIsDamaged) {
  write_checkpoint(example(), path());
  const std::string good = text();
  for (std::size_t at = 0; at < good.size(); at += 3) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    put(bad);
    EXPECT_THROW(static_cast<void>(read_checkpoint(path(), asked)), BadInput) << at;
  }
  for (std::size_t length = 1; length < good.size(); length += 7) {
    put(good.substr(0, length));
    EXPECT_THROW(static_cast<void>(read_checkpoint(path(), asked)), BadInput) << length;
  }
  put(good.substr(0, good.size() / 2));
  expect_refused("damaged", asked);
  put(good + "more\n");
  expect_refused("damaged", asked);
  put("changeover-checkpoint 2\n");
  expect_refused("another version", asked);
  put("# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n");
  expect_refused("not a checkpoint", asked);
  put("");
  expect_refused("not a checkpoint", asked);
}

// A text with its right last line, as a program that knows the format may write.
std::string with_check(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return text + fmt::format("check {:016x}\n", hash);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    lines.push_back(line);
  }
  return lines;
}

// With word `at` of a line replaced.
std::string with_word(const std::string& line, std::size_t at, const std::string& word) {
  std::istringstream all(line);
  std::string text;
  std::string each;
  for (std::size_t i = 0; all >> each; ++i) {
    text += (i == 0 ? "" : " ") + (i == at ? word : each);
  }
  return text;
}

// What a search with these parameters cannot have is refused, and the search goes well with all
// else.
TEST_F(Checkpoints, HostileNumbersWithARightSumAreRefusedOrHarmless) {
  const Parameters p{.v = 130, .k = 6};
  RunControl first({.seed = 1});
  static_cast<void>(improve(p, {.moves = 1000, .checkpoint = path()}, first));
  std::vector<std::string> lines = lines_of(text());
  lines.pop_back();
  std::istringstream numbers(
      "0 1 2 63 64 65 255 1000003 2147483647 2147483648 4294967295 4294967296 1152921504606846977 "
      "9223372036854775807 9223372036854775808 18446744073709551614 18446744073709551615 -1");
  const std::vector<std::string> words(std::istream_iterator<std::string>(numbers), {});
  std::size_t refused = 0;
  std::size_t harmless = 0;
  std::size_t number = 0;
  for (std::size_t line = 2; line < lines.size() && !lines[line].starts_with("block"); ++line) {
    const std::size_t fields = lines[line].starts_with("arm") ? 8 : 1;
    for (std::size_t field = 1; field <= fields; ++field) {
      for (const std::string& word : words) {
        if (lines[line].starts_with("arm") && line > 12 && number++ % 7 != 0) {
          continue;  // they are like those before
        }
        std::string mutant;
        for (std::size_t i = 0; i < lines.size(); ++i) {
          mutant += (i == line ? with_word(lines[i], field, word) : lines[i]) + "\n";
        }
        put(with_check(mutant));
        try {
          static_cast<void>(read_checkpoint(path(), p));
          ++harmless;
        } catch (const BadInput& fault) {
          ++refused;
          EXPECT_NE(std::string(fault.what()).find("damaged"), std::string::npos);
          continue;
        }
        if (harmless % 4 == 0) {
          RunControl control({.time = std::chrono::seconds(10)});
          const ImproveResult result = improve(p, {.moves = 300, .checkpoint = path()}, control);
          EXPECT_TRUE(verify(result.design.value()).valid()) << lines[line] << ' ' << word;
          EXPECT_EQ(result.checkpoint_fault, "");
        }
      }
    }
  }
  EXPECT_GT(refused, 500U);
  EXPECT_GT(harmless, 200U);
}

TEST_F(Checkpoints, WordsThatATerminalWouldObeyAreRefused) {
  write_checkpoint(example(), path());
  std::string all = text();
  all.resize(all.rfind("check "));
  for (const std::string& how :
       {std::string("\x1b[2J"), std::string(5000, 'x'), std::string("\xff")}) {
    std::string mutant = all;
    mutant.replace(mutant.find("how ") + 4, std::string("blocks without symmetry").size(), how);
    put(with_check(mutant));
    expect_refused("damaged", asked);
  }
}

TEST_F(Checkpoints, MustBeARegularFile) {
  for (const std::string device : {"/dev/zero", "/dev/null"}) {
    EXPECT_THROW(static_cast<void>(read_checkpoint(device, asked)), BadInput) << device;
  }
}

TEST_F(Checkpoints, IsOfOneSearchAtATime) {
  const std::string link = folder_.file("link");
  std::filesystem::create_symlink("state", link);
  {
    const CheckpointFile file(path(), asked);
    for (const std::string& name : {path(), link, folder_.file("./state")}) {
      try {
        const CheckpointFile second(name, asked);
        ADD_FAILURE() << name;
      } catch (const MissingResource& fault) {
        EXPECT_NE(std::string(fault.what()).find("another process"), std::string::npos);
      }
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path() + ".lock"));
  const CheckpointFile again(link, asked);
}

TEST_F(Checkpoints, TheLockOfAKilledSearchBlocksNobody) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const Child child([&] {
    const CheckpointFile file(path(), asked);
    static_cast<void>(::write(pipe[1], "x", 1));
    ::pause();
  });
  char byte = 0;
  ASSERT_EQ(::read(pipe[0], &byte, 1), 1);
  EXPECT_THROW(CheckpointFile(path(), asked), MissingResource);
  ASSERT_TRUE(child.killed());
  ::close(pipe[0]);
  ::close(pipe[1]);
  EXPECT_TRUE(std::filesystem::exists(path() + ".lock"));
  EXPECT_NO_THROW(CheckpointFile(path(), asked));
  EXPECT_FALSE(std::filesystem::exists(path() + ".lock"));
}

TEST_F(Checkpoints, AFileThatOnlyHasTheNameOfTheLockIsSomebodys) {
  for (const std::string& content : {std::string("[package]\n"), std::string(200, 'x')}) {
    std::ofstream(path() + ".lock") << content;
    EXPECT_THROW(CheckpointFile(path(), asked), BadInput);
    std::ifstream kept(path() + ".lock");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), content);
  }
  std::ofstream(path() + ".lock", std::ios::trunc)
      .close();  // It may belong to another program, too.
  EXPECT_NO_THROW(CheckpointFile(path(), asked));
  EXPECT_TRUE(std::filesystem::exists(path() + ".lock"));
}

TEST_F(Checkpoints, IsNeverReplacedByAWorseDesign) {
  const Parameters p{.v = 30, .k = 7, .change = 4};
  const std::string better = folder_.file("better");
  RunControl first({.seed = 1});
  const ImproveResult good = improve(p, {.moves = 600'000, .checkpoint = better}, first);
  RunControl plain({.seed = 7});
  const ImproveResult known = improve(p, {.moves = 10'000}, plain);
  ASSERT_LT(good.design->block_count(), known.design->block_count());
  // Another program puts the better one there while a search that has the worse one is running.
  bool put_there = false;
  RunControl control(doing_once(put_there, [&] { put(test::slurp(better)); }));
  const ImproveResult result = improve(
      p, {.moves = 10'000, .checkpoint = path(), .checkpoint_interval = std::chrono::hours(1)},
      control);
  EXPECT_TRUE(put_there);
  EXPECT_EQ(result.design->block_count(), good.design->block_count());
  EXPECT_EQ(read_checkpoint(path(), p)->best->block_count(), good.design->block_count());
}

TEST_F(Checkpoints, AFileThatIsNoneIsNotReplaced) {
  const Parameters p{.v = 47, .k = 9, .change = 1};
  bool put_there = false;
  RunControl control(doing_once(put_there, [&] {
    std::filesystem::remove(path());
    put("my notes\n");
  }));
  const ImproveResult result = improve(p,
                                       {.moves = 30'000,
                                        .checkpoint = path(),
                                        .checkpoint_interval = std::chrono::duration<double>(0)},
                                       control);
  EXPECT_TRUE(put_there);
  EXPECT_TRUE(verify(result.design.value()).valid());
  EXPECT_NE(result.checkpoint_fault.find("not a checkpoint"), std::string::npos);
  EXPECT_EQ(text(), "my notes\n");
}

TEST_F(Checkpoints, WhatCannotBeWrittenAnyMoreDoesNotEndTheSearch) {
  const Parameters p{.v = 47, .k = 9, .change = 1};
  const std::filesystem::path inner = folder_.path() / "inner";
  std::filesystem::create_directory(inner);
  const std::string state = (inner / "state").string();
  RunControl control(doing([&] { std::filesystem::remove_all(inner); }));
  const ImproveResult result = improve(p,
                                       {.moves = 20'000,
                                        .checkpoint = state,
                                        .checkpoint_interval = std::chrono::duration<double>(0)},
                                       control);
  EXPECT_EQ(result.why_stopped, WhyStopped::step_limit);
  EXPECT_TRUE(verify(result.design.value()).valid());
  EXPECT_EQ(result.checkpoint_fault.find(state), 0U) << result.checkpoint_fault;
  EXPECT_EQ(result.checkpoint_fault.find('\n'), std::string::npos);
}

TEST_F(Checkpoints, ThatCannotBeWrittenFromTheBeginningIsRefused) {
  RunControl control({});
  EXPECT_THROW(static_cast<void>(improve(
                   asked, {.moves = 1000, .checkpoint = folder_.file("no/state")}, control)),
               MissingResource);
}

// A checkpoint keeps blocks only, but what was known before is so in a later run, too.
TEST_F(Checkpoints, TheBestRecipeComesBackAsThat) {
  const Parameters p{.v = 30, .k = 6};
  for (int run = 0; run < 2; ++run) {
    RunControl control({.seed = 1});
    const ImproveResult result = improve(p, {.moves = 1000, .checkpoint = path()}, control);
    ASSERT_TRUE(result.design);
    EXPECT_EQ(result.how, "best recipe");
    EXPECT_TRUE(result.design->design().recipe) << run;
    EXPECT_EQ(result.started_from, result.design->block_count());
  }
}

TEST_F(Checkpoints, GoesOnWhereTheSearchWas) {
  const Parameters p{.v = 47, .k = 9, .change = 1};
  RunControl first({.seed = 6});
  const ImproveResult before = improve(p, {.moves = 600'000, .checkpoint = path()}, first);
  RunControl second({.seed = 99});
  const ImproveResult after = improve(p, {.moves = 600'000, .checkpoint = path()}, second);
  EXPECT_GT(after.moves, before.moves);
  EXPECT_GT(after.attempts, before.attempts);
  EXPECT_LE(after.design->block_count(), before.design->block_count());
  const auto kept = read_checkpoint(path(), p);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->seed, 6U);
  EXPECT_EQ(kept->moves, after.moves);
  EXPECT_EQ(kept->best->block_count(), after.design->block_count());
}

TEST_F(Checkpoints, SurvivesAKill) {
  const Parameters p{.v = 30, .k = 6, .change = 1};
  std::uint64_t moves = 0;
  for (int round = 0; round < 3; ++round) {
    const Child child([&] {
      RunControl control({.time = std::chrono::seconds(60), .seed = 3});
      static_cast<void>(improve(
          p, {.checkpoint = path(), .checkpoint_interval = std::chrono::duration<double>(0)},
          control));
    });
    // Killed as soon as there is more than before, most likely while the file is being written.
    std::uint64_t now = moves;
    for (int wait = 0; wait < 4000 && now <= moves; ++wait) {
      ::usleep(5000);
      if (const auto state = read_checkpoint(path(), p)) {
        now = state->moves;
      }
    }
    ASSERT_TRUE(child.killed());
    const auto state = read_checkpoint(path(), p);
    ASSERT_TRUE(state.has_value());
    ASSERT_GT(state->moves, moves);
    ASSERT_TRUE(verify(state->best.value()).valid());
    moves = state->moves;
  }
  RunControl control({.seed = 3});
  const ImproveResult result = improve(p, {.moves = 10'000, .checkpoint = path()}, control);
  EXPECT_GT(result.moves, moves);
}

}  // namespace
}  // namespace changeover::checkpoint_test
