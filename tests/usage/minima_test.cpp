// changeover minima, as its users see it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "run_program.hpp"

namespace changeover::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string small = "$changeover minima --v 7 --k-to 4 --quiet";

TEST(Minima, WritesNoFileThatNobodyAskedFor) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(small, folder.path()).code, 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_EQ(run(small + " --time 1s", folder.path()).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.file("minima.csv")));
  EXPECT_EQ(run(small + " --data mine.csv", folder.path()).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.file("mine.csv")));
}

TEST(Minima, ShowsOnlyWhatIsAskedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(small + " --data mine.csv", folder.path()).code, 0);
  const Outcome all =
      run("$changeover minima --v 7 --k-to 4 --data mine.csv --json", folder.path());
  EXPECT_THAT(all.out, HasSubstr("\"v\":7"));
  const Outcome few = run("$changeover minima --v 5 --data mine.csv --json", folder.path());
  EXPECT_EQ(few.code, 0);
  EXPECT_THAT(few.out, HasSubstr("\"v\":5"));
  EXPECT_THAT(few.out, Not(HasSubstr("\"v\":7")));
}

TEST(Minima, IsOfOneProcessAtATimeAndNeverItsOwnInput) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(small + " --data mine.csv", folder.path()).code, 0);
  const std::string before = slurp(folder.file("mine.csv"));
  const Outcome same = run(small + " --data mine.csv -o ./mine.csv", folder.path());
  EXPECT_EQ(same.code, 2);
  EXPECT_EQ(slurp(folder.file("mine.csv")), before);
  const Outcome second =
      run("$changeover minima --v 16 --data mine.csv --time 4s --quiet >/dev/null & "
          "for i in $(seq 100); do [[ -e mine.csv.lock ]] && break; sleep 0.02; done; " +
              small + " --data mine.csv; code=$?; kill $!; wait; exit $code",
          folder.path());
  EXPECT_EQ(second.code, 4);
  EXPECT_THAT(second.err, HasSubstr("another process works with it"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("mine.csv.lock")));
}

TEST(Minima, RefusesWhatItCannotMean) {
  const TemporaryFolder folder;
  const Outcome strength = run("$changeover minima --strength 9", folder.path());
  EXPECT_EQ(strength.code, 2);
  EXPECT_THAT(strength.err, HasSubstr("--strength 9 is out of range"));
  std::filesystem::create_symlink("loop", folder.file("loop"));
  const Outcome loop = run("$changeover minima --data loop", folder.path());
  EXPECT_EQ(loop.code, 4);
  EXPECT_THAT(loop.err, HasSubstr("loop: "));
}

}  // namespace
}  // namespace changeover::test
