// The example all_pairs from outside: alone, in shares and under MPI.
#include <algorithm>
#include <filesystem>

#include "cases.hpp"

namespace changeover::test::all_pairs_example_test {
namespace {

// The lines that are not mpirun's.
std::vector<std::string> own_lines(const std::string& text) {
  std::vector<std::string> lines = lines_of(text);
  std::erase_if(lines, [](const std::string& line) { return line.rfind("all_pairs: ", 0) != 0; });
  return lines;
}

TEST(AllPairsExample, ComputesWhatIsComputedInMemoryAloneAndInShares) {
  const TemporaryFolder folder;
  ASSERT_EQ(run("$all_pairs make v 60 300", folder.path()).code, 0);
  const Outcome alone =
      run("$all_pairs run v 300 --chunk 3 --memory 40K --threads 2 --journal job --check",
          folder.path());
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_NE(alone.out.find("all 3600 entries"), std::string::npos) << alone.out;
  EXPECT_EQ(std::filesystem::file_size(folder.file("v.dist")), 60U * 60U * 8U);
  const std::string gram = slurp(folder.file("v.gram"));
  std::filesystem::remove(folder.file("v.gram"));
  EXPECT_EQ(run("for i in 0 1 2; do $all_pairs run v 300 --chunk 3 --memory 40K "
                "--share $i/3 & done; wait",
                folder.path())
                .code,
            0);
  EXPECT_EQ(slurp(folder.file("v.gram")), gram);
  for (const char* order : {"beta", "hold", "tiles", "exhaustive"}) {
    const Outcome other =
        run(std::string("$all_pairs run v 300 --chunk 3 --memory 40K --check --order ") + order,
            folder.path());
    EXPECT_EQ(other.code, 0) << other.out << other.err;
  }
}

TEST(AllPairsExample, SaysInOneLineWhatIsWrong) {
  const TemporaryFolder folder;
  ASSERT_EQ(run("$all_pairs make v 60 300; head -c 7000 v > short", folder.path()).code, 0);
  expect({{"$all_pairs run short 300", 3, "short"},
          {"$all_pairs run absent 300", 4, "absent"},
          {"$all_pairs run v 300 --memory 1K", 3, "memory"},
          {"$all_pairs run v 0", 2, "DIMENSION and --chunk must be at least 1"},
          {"$all_pairs run v 300 --share 3/3 >/dev/null", 3, "share"},
          {"$all_pairs run v 300 --nonsense", 2, "'--nonsense' is not understood"},
          {"$all_pairs", 2, "usage"}},
         folder);
}

TEST(AllPairsExample, FourProcessesHaveTheBytesOfOne) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const std::string job = "$all_pairs run v 300 --chunk 3 --memory 48K ";
  ASSERT_EQ(run("$all_pairs make v 60 300; " + job, folder.path()).code, 0);
  const std::string gram = slurp(folder.file("v.gram"));
  const std::string distances = slurp(folder.file("v.dist"));
  ASSERT_EQ(gram.size(), 60U * 60U * 8U);
  spit(folder.file("v.gram"), std::string(gram.size() + 100, 'x'));  // nothing of it may stay
  std::filesystem::remove(folder.file("v.dist"));

  const Outcome four = run(mpirun + "-n 4 " + job + "--journal job --check", folder.path());
  EXPECT_EQ(four.code, 0) << four.err;
  EXPECT_EQ(lines_of(four.out).size(), 4U) << four.out;  // one process speaks
  EXPECT_NE(four.out.find("4 processes"), std::string::npos) << four.out;
  EXPECT_EQ(slurp(folder.file("v.gram")), gram);
  EXPECT_EQ(slurp(folder.file("v.dist")), distances);
  // Each has a journal with work in it, and none is left to do.
  for (int i = 0; i < 4; ++i) {
    EXPECT_NE(slurp(folder.file("job." + std::to_string(i))).find("\nstep 2 "), std::string::npos);
  }
  // A run that lost the end of a journal goes on there, and does not touch the rest.
  EXPECT_EQ(run("sed -i '$d' job.2", folder.path()).code, 0);
  const Outcome again = run(mpirun + "-n 4 " + job + "--journal job", folder.path());
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(slurp(folder.file("v.gram")), gram);
  const std::size_t steps = again.out.find(" steps, ");
  const std::size_t of = again.out.find(" of ", again.out.find("one: "));
  ASSERT_NE(steps, std::string::npos) << again.out;
  const std::uint64_t all = std::stoull(again.out.substr(of + 4));
  EXPECT_EQ(std::stoull(again.out.substr(steps + 8)), all - 1) << again.out;
}

TEST(AllPairsExample, AProcessThatIsRefusedKeepsAllOthersFromWriting) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed";
  }
  const std::string two = mpirun + "-n 2 $all_pairs ";
  ASSERT_EQ(run("$all_pairs make v 60 300; " + two +
                    "run v 300 --chunk 3 --memory 48K --journal job; rm job.0",
                folder.path())
                .code,
            0);
  const std::string gram = slurp(folder.file("v.gram"));
  ASSERT_EQ(gram.size(), 60U * 60U * 8U);
  // For process 0 nothing speaks against another job, but the journal of process 1 does.
  const Outcome other = run(two + "run v 600 --chunk 3 --memory 48K --journal job", folder.path());
  EXPECT_EQ(other.code, 3) << other.err;
  ASSERT_EQ(own_lines(other.err).size(), 1U) << other.err;
  EXPECT_NE(own_lines(other.err)[0].find("job.1: is the journal of another job"),
            std::string::npos);
  EXPECT_EQ(slurp(folder.file("v.gram")), gram);
  EXPECT_FALSE(std::filesystem::exists(folder.file("job.0")));
  // Results that were lost are computed again by the process that they belong to.
  spit(folder.file("v.gram"), std::string(gram.size(), '\0'));
  const Outcome again = run(two + "run v 300 --chunk 3 --memory 48K --journal job", folder.path());
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("recorded but not found again"), std::string::npos) << again.out;
  EXPECT_EQ(slurp(folder.file("v.gram")), gram);
}

TEST(AllPairsExample, OneProcessThatFailsEndsAllWithOneLine) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  ASSERT_EQ(run("$all_pairs make v 60 300; mkdir job.2", folder.path()).code, 0);
  for (const auto& [command, code, says] : std::vector<std::tuple<std::string, int, std::string>>{
           {"run v 300 --memory 48K --journal job", 4, "process 2 of 4: job.2: "},
           {"run absent 300 --memory 48K", 4, "absent"},
           {"run v 300 --memory 48K --share 0/2", 2, "mpirun shares by itself"},
           {"run v", 2, "usage"},
           {"make w 6 300", 2, "usage"}}) {
    const Outcome outcome = run(mpirun + "-n 4 $all_pairs " + command, folder.path());
    EXPECT_EQ(outcome.code, code) << command << outcome.err;
    const std::vector<std::string> lines = own_lines(outcome.err);
    ASSERT_EQ(lines.size(), 1U) << command << outcome.err;
    EXPECT_NE(lines[0].find(says), std::string::npos) << lines[0];
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("v.dist")));
}

}  // namespace
}  // namespace changeover::test::all_pairs_example_test
