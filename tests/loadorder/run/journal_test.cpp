#include "loadorder/run/journal.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "run_program.hpp"

namespace changeover::test::journal_test {
namespace {

TEST(Journal, AFirstLineThatEndsAnywhereIsNewOrAnotherJobs) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  const std::vector<JournalField> job{{"job", "sums"}, {"items", "10"}};
  { Journal(path, job, 20).begin(); }
  const std::string head = slurp(path);
  ASSERT_EQ(head, "changeover journal 2: job sums; items 10;\n");
  for (std::size_t bytes = 0; bytes < head.size(); ++bytes) {
    // A write that was cut off: the journal is begun again.
    spit(path, head.substr(0, bytes));
    EXPECT_NO_THROW(Journal(path, job, 20).begin()) << bytes;
    EXPECT_EQ(slurp(path), head);
    // A line that ends there and goes on otherwise is of somebody else, and stays.
    for (const std::string& rest : {std::string("\n"), "\nstep 1 - x\n" + head}) {
      const std::string other = head.substr(0, bytes) + rest;
      if (other.starts_with(head)) {
        continue;
      }
      spit(path, other);
      EXPECT_THROW(Journal(path, job, 20), BadInput) << bytes;
      EXPECT_EQ(slurp(path), other);
    }
  }
}

}  // namespace
}  // namespace changeover::test::journal_test
