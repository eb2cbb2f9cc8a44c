#include <gtest/gtest.h>

#include <string>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "run_program.hpp"

namespace changeover::input_test {
namespace {

TEST(Input, OfANameWithAZeroByteIsNotTheFileBeforeIt) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("parts.csv");
  OutputFile file(path);
  file.write("a\nb\n");
  file.commit();
  EXPECT_EQ(read_to_end(*open_input(path), 100, ""), "a\nb\n");
  EXPECT_THROW(open_input(path + std::string(1, '\0') + ".old"), MissingResource);
}

}  // namespace
}  // namespace changeover::input_test
