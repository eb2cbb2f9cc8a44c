// The examples of the headers of proof/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::proof_examples_test {
namespace {

class ProofExamples : public InAFolder {};

TEST_F(ProofExamples, Verified) {
  put("a.cnf", "p cnf 2 4\n1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n");
  put("a.drat", "2 0\n0\n");
  std::ifstream cnf("a.cnf"), proof("a.drat");
  ProofVerdict verdict = check_proof(cnf, "a.cnf", proof, "a.drat");
  EXPECT_TRUE(verdict.verified());
}

TEST_F(ProofExamples, Refuted) {
  put("a.cnf", "p cnf 2 3\n1 2 0\n-1 2 0\n1 -2 0\n");
  put("a.drat", "2 0\n0\n");
  std::ifstream cnf("a.cnf"), proof("a.drat");
  ProofVerdict verdict = check_proof(cnf, "a.cnf", proof, "a.drat");
  EXPECT_FALSE(verdict.verified());
  EXPECT_EQ(verdict.line, 2U);
  EXPECT_FALSE(verdict.reason.empty());
}

TEST(CubeExamples, NothingIsLeftOut) {
  EXPECT_TRUE(cubes_cover_everything({{1}, {-1, 2}, {-1, -2}}));
  EXPECT_FALSE(cubes_cover_everything({{1}, {-1, 2}}));
}

}  // namespace
}  // namespace changeover::test::proof_examples_test
