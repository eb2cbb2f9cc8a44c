#include "search/sat/cnf.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"

namespace changeover::cnf_test {
namespace {

TEST(Cnf, IsWrittenInDimacs) {
  Cnf cnf;
  const Literal a = cnf.new_variable();
  const Literal b = cnf.new_variable();
  cnf.add({a, b});
  cnf.add({-a, -b});
  EXPECT_EQ(cnf.variables(), 2U);
  EXPECT_EQ(cnf.clauses(), 2U);
  StringSink sink;
  write_dimacs(cnf, std::vector<Literal>{-a}, {"one of two"}, sink);
  EXPECT_EQ(sink.text(), "c one of two\np cnf 2 3\n1 2 0\n-1 -2 0\n-1 0\n");
}

TEST(Cnf, RefusesLiteralsOfNoVariable) {
  Cnf cnf;
  EXPECT_THROW(cnf.add({1}), InternalError);
  (void)cnf.new_variable();
  EXPECT_THROW(cnf.add({1, 0}), InternalError);
  EXPECT_THROW(cnf.add({-2}), InternalError);
  cnf.add({});
  EXPECT_EQ(cnf.clauses(), 1U);
}

}  // namespace
}  // namespace changeover::cnf_test
