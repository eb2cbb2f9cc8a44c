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
