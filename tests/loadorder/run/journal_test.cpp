#include "loadorder/run/journal.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
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
    // A line that ends there and continues differently belongs to another program, and stays.
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

TEST(Journal, SaysWhatIsAnother) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  const auto job = [](const std::string& name, const std::string& shares) {
    return std::vector<JournalField>{{"job", name}, {"order", "a; b"}, {"shares", shares}};
  };
  const auto complaint = [&](const std::vector<JournalField>& fields) -> std::string {
    return message_of([&] { Journal(path, fields, 20); });
  };
  { Journal(path, job("sums", "4"), 20).begin(); }
  EXPECT_EQ(complaint(job("sums", "4")), "");
  EXPECT_NE(complaint(job("sum", "4")).find("differs in: job; name another file"),
            std::string::npos);
  // One that begins like the other, both ways round: shares that were cut by another rule.
  EXPECT_NE(
      complaint(job("sums", "4, even in loads"))
          .find("differs in: shares, there '4', now '4, even in loads'; name another file, or "
                "remove this one to restart from the beginning"),
      std::string::npos)
      << complaint(job("sums", "4, even in loads"));
  { Journal(folder.file("even"), job("sums", "4, even in loads"), 20).begin(); }
  try {
    Journal(folder.file("even"), job("sums", "4"), 20);
    ADD_FAILURE() << "it is of other shares";
  } catch (const BadInput& fault) {
    EXPECT_NE(std::string(fault.what()).find("differs in: shares, there '4"), std::string::npos)
        << fault.what();
  }
}

}  // namespace
}  // namespace changeover::test::journal_test
