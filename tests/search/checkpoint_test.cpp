#include "changeover/search/checkpoint.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {
namespace {

class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "changeover-checkpoint-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~CheckpointFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::string path() const { return (folder_ / "state").string(); }

  [[nodiscard]] std::string text() const {
    std::ifstream file(path(), std::ios::binary);
    std::ostringstream all;
    all << file.rdbuf();
    return all.str();
  }

  void put(const std::string& all) const { std::ofstream(path(), std::ios::binary) << all; }

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

  std::filesystem::path folder_;
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
                      .order = 3,
                      .fixed = 1,
                      .extra = 2,
                      .budget = 1000,
                      .spent = 2000,
                      .step = 4,
                      .missed = 9}};
  checkpoint.how = "blocks without symmetry";
  checkpoint.best = Design(asked, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  return checkpoint;
}

TEST_F(CheckpointFile, ReadsWhatItWrote) {
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

TEST_F(CheckpointFile, IsRefusedForOtherParameters) {
  write_checkpoint(example(), path());
  Parameters other = asked;
  other.kind = Kind::linear;
  expect_refused("of another search", other);
  expect_refused("of another search", {.v = 20, .k = 5});
}

TEST_F(CheckpointFile, IsRefusedWhenAnyByteIsDamaged) {
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

TEST_F(CheckpointFile, GoesOnWhereTheSearchWas) {
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

TEST_F(CheckpointFile, SurvivesAKill) {
  const Parameters p{.v = 30, .k = 6, .change = 1};
  std::uint64_t moves = 0;
  for (int round = 0; round < 3; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      try {
        RunControl control({.time = std::chrono::seconds(60), .seed = 3});
        static_cast<void>(improve(
            p, {.checkpoint = path(), .checkpoint_interval = std::chrono::duration<double>(0)},
            control));
      } catch (...) {
        std::_Exit(1);
      }
      std::_Exit(0);
    }
    // Killed as soon as there is more than before, most likely while the file is being written.
    std::uint64_t now = moves;
    for (int wait = 0; wait < 4000 && now <= moves; ++wait) {
      ::usleep(5000);
      if (const auto state = read_checkpoint(path(), p)) {
        now = state->moves;
      }
    }
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
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
}  // namespace changeover
