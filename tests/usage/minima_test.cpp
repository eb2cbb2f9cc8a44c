// changeover minima, as its users see it.
#include <gmock/gmock.h>

#include <filesystem>

#include "cases.hpp"

namespace changeover::test::minima_test {
namespace {

using testing::HasSubstr;

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
  expect({{"$changeover minima --v 7 --k-to 4 --data mine.csv --json", 0, "{\"v\":7,"},
          {"$changeover minima --v 5 --data mine.csv --json", 0, "{\"v\":5,"}},
         folder);
  EXPECT_EQ(
      count(run("$changeover minima --v 5 --data mine.csv --json", folder.path()).out, "{\"v\":7,"),
      0U);
}

TEST(Minima, IsOfOneProcessAtATimeAndNeverItsOwnInput) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(small + " --data mine.csv", folder.path()).code, 0);
  const std::string before = slurp(folder.file("mine.csv"));
  const Outcome same = run(small + " --data mine.csv -o ./mine.csv", folder.path());
  EXPECT_EQ(same.code, 2);
  EXPECT_EQ(slurp(folder.file("mine.csv")), before);
  const Outcome second =
      // The lock is there before it is locked: the system says when it is.
      run("$changeover minima --v 16 --data mine.csv --time 10m --quiet >/dev/null & "
          "for i in $(seq 1200); do [[ -e mine.csv.lock ]] && "
          "grep -q \":$(stat -c %i mine.csv.lock) \" /proc/locks && break; sleep 0.05; done; " +
              small + " --data mine.csv; code=$?; kill $!; wait; exit $code",
          folder.path());
  EXPECT_EQ(second.code, 4);
  EXPECT_THAT(second.err, HasSubstr("another process is using it"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("mine.csv.lock")));
}

}  // namespace
}  // namespace changeover::test::minima_test
