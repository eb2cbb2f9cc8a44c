#include "changeover/proof/proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "message_of.hpp"
#include "proof_texts.hpp"

namespace changeover::drat_test {
namespace {

using namespace test;
using testing::HasSubstr;

TEST(Drat, VerifiesAProofByUnitPropagation) {
  const ProofVerdict verdict = check_text(eight, "1 2 0\n1 0\n2 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.clauses, 8U);
  EXPECT_EQ(verdict.variables, 4U);
  EXPECT_EQ(verdict.by_resolvents, 0U);
  EXPECT_GT(verdict.propagations, 0U);
}

TEST(Drat, VerifiesAStepByResolvents) {
  const ProofVerdict verdict = check_text(eight, "-1 0\n2 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.by_resolvents, 1U);
}

TEST(Drat, RefusesAFlippedLiteral) {
  const std::string cnf = "p cnf 3 4\n1 2 0\n1 -2 3 0\n-1 2 3 0\n-1 -2 0\n";
  EXPECT_FALSE(check_text(cnf, "0\n").verified());
  const ProofVerdict verdict = check_text(
      "p cnf 3 6\n1 2 3 0\n1 2 -3 0\n1 -2 3 0\n1 -2 -3 0\n-1 2 0\n-1 -2 3 0\n", "1 2 0\n1 0\n0\n");
  EXPECT_FALSE(verdict.verified());
  EXPECT_EQ(verdict.outcome, ProofVerdict::Outcome::refuted);
  EXPECT_EQ(verdict.line, 3U);
  EXPECT_THAT(verdict.reason, HasSubstr("empty clause"));
}

TEST(Drat, SaysWhichLineDoesNotFollow) {
  const ProofVerdict verdict =
      check_text("p cnf 3 3\n1 2 0\n-1 -3 0\n-2 3 0\n", "c a comment\n1 2 3 0\n\n-2 -3 0\n0\n");
  EXPECT_FALSE(verdict.verified());
  EXPECT_EQ(verdict.line, 4U);
  EXPECT_THAT(verdict.reason, HasSubstr("-2 -3 0"));
}

TEST(Drat, RefusesAProofThatEndsEarly) {
  const ProofVerdict verdict = check_text(eight, "1 2 0\n");
  EXPECT_FALSE(verdict.verified());
  EXPECT_THAT(verdict.reason, HasSubstr("without a contradiction"));
}

TEST(Drat, NeedsNoProofWhereUnitPropagationSuffices) {
  EXPECT_TRUE(check_text("p cnf 2 3\n1 0\n-1 2 0\n-2 0\n", "").verified());
  EXPECT_TRUE(check_text("p cnf 0 1\n0\n", "").verified());
}

TEST(Drat, NeverVerifiesAFormulaWithoutClauses) {
  EXPECT_FALSE(check_text("p cnf 0 0\n", "").verified());
  EXPECT_FALSE(check_text("p cnf 2 0\n", "1 0\n-1 0\n0\n").verified());
}

// 5 ⟺ 6 and 7, one clause after another: each follows by resolvents on its first literal only.
TEST(Drat, AllowsDefinitionsOfNewVariables) {
  const std::string definition = "5 -6 -7 0\n-5 6 0\n-5 7 0\n";
  const ProofVerdict verdict = check_text(eight, definition + "1 2 0\n1 0\n2 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.by_resolvents, 3U);
  // The same clause written with another literal first does not follow.
  const ProofVerdict other = check_text(eight, "6 7 0\n5 -6 -7 0\n-6 5 0\n");
  EXPECT_FALSE(other.verified());
  EXPECT_EQ(other.line, 3U);
}

TEST(Drat, IgnoresTheDeletionOfUnitClauses) {
  const ProofVerdict verdict = check_text(needs_unit, "1 0\nd 1 0\n3 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.ignored_deletions, 1U);
  // A clause that fixed a literal is unit as well: 1 2 5 does once −2 and −5 are there.
  const ProofVerdict longer =
      check_text("p cnf 5 7\n1 2 5 0\n-2 0\n-5 0\n-1 3 4 0\n-1 3 -4 0\n-1 -3 4 0\n-1 -3 -4 0\n",
                 "d 5 1 2 0\n3 0\n0\n");
  EXPECT_TRUE(longer.verified()) << longer.reason;
  EXPECT_EQ(longer.ignored_deletions, 1U);
}

TEST(Drat, ObeysOtherDeletions) {
  const ProofVerdict verdict = check_text(needs_unit, "1 0\nd 4 -1 3 0\n3 0\n0\n");
  EXPECT_FALSE(verdict.verified());
  EXPECT_EQ(verdict.deleted, 1U);
  EXPECT_EQ(verdict.line, 3U);
}

TEST(Drat, DeletesOneOfSeveralCopies) {
  const std::string twice =
      "p cnf 4 7\n1 2 0\n1 -2 0\n-1 3 4 0\n-1 3 4 0\n-1 3 -4 0\n-1 -3 4 0\n-1 -3 -4 0\n";
  EXPECT_TRUE(check_text(twice, "d 4 3 -1 0\n1 0\n3 0\n").verified());
  EXPECT_FALSE(check_text(twice, "d 4 3 -1 0\nd 3 -1 4 0\n1 0\n3 0\n").verified());
}

TEST(Drat, CountsTheDeletionOfWhatIsNotThere) {
  const ProofVerdict verdict = check_text(eight, "d 1 2 3 4 0\nd 99 0\n1 2 0\n1 0\n2 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.ignored_deletions, 2U);
}

TEST(Drat, TakesRepeatedLiteralsAndTautologiesForWhatTheySay) {
  EXPECT_TRUE(check_text(eight, "1 2 1 0\n7 -7 0\n1 1 0\n2 0\n0\n").verified());
  EXPECT_TRUE(check_text("p cnf 2 4\n1 1 0\n2 -2 0\n-1 2 2 0\n-2 -1 -2 0\n", "").verified());
}

TEST(Drat, ReadsBinaryProofs) {
  const auto step = binary_step;
  const ProofOptions binary{.format = ProofFormat::binary};
  const std::string proof = step('a', {300, -98, -99}) + step('a', {1, 2}) +
                            step('d', {300, -98, -99}) + step('a', {1}) + step('a', {2}) +
                            step('a', {});
  const ProofVerdict verdict = check_text(eight, proof, binary);
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.by_resolvents, 1U);
  EXPECT_EQ(verdict.deleted, 1U);
  EXPECT_EQ(check_text(eight, step('a', {2, 3}), binary).line, 1U);
  EXPECT_THAT(refusal(eight, "x", binary), HasSubstr("a.drat:1: expected 'a' or 'd', found 'x'"));
  EXPECT_THAT(refusal(eight, step('a', {1, 2}) + "a\x03", binary), HasSubstr("a.drat:2:"));
  EXPECT_THAT(refusal(eight, std::string("a\x01\0", 3), binary),
              HasSubstr("the number 1 is not a literal"));
  EXPECT_THAT(refusal(eight, "a\xff\xff\xff\xff\xff\xff\xff", binary), HasSubstr("exceeds"));
}

TEST(Drat, RefusesMalformedFormulasInOneLine) {
  EXPECT_THAT(refusal("", ""), HasSubstr("a.cnf:1: expected the header"));
  EXPECT_THAT(refusal("c x\n\nq cnf 1 1\n1 0\n", ""), HasSubstr("a.cnf:3: expected the header"));
  EXPECT_THAT(refusal("p dnf 1 1\n1 0\n", ""), HasSubstr("header"));
  EXPECT_THAT(refusal("p cnf 1\n1 0\n", ""), HasSubstr("the number of clauses"));
  EXPECT_THAT(refusal("p cnf -1 1\n", ""), HasSubstr("negative"));
  EXPECT_THAT(refusal("p cnf 1 1 x\n", ""), HasSubstr("end of the line"));
  EXPECT_THAT(refusal("p cnf 2 1\n1 3 0\n", ""),
              HasSubstr("a.cnf:2: a literal's variable exceeds"));
  EXPECT_THAT(refusal("p cnf 2 1\n1 2\n", ""), HasSubstr("not ended by 0"));
  EXPECT_THAT(refusal("p cnf 2 2\n1 2 0\n", ""), HasSubstr("says 2 clauses, but there are 1"));
  EXPECT_THAT(refusal("p cnf 2 1\n1 2 0\n-1 0\n", ""), HasSubstr("more clauses than"));
  EXPECT_THAT(refusal("p cnf 2 1\n1 x 0\n", ""), HasSubstr("found 'x'"));
  EXPECT_THAT(refusal("p cnf 2 1\n1- 0\n", ""), HasSubstr("found '-'"));
  EXPECT_THAT(refusal("p cnf 99999999999999999999 1\n", ""), HasSubstr("exceeds"));
  EXPECT_THAT(refusal(std::string("p cnf 1 1\n\0 0\n", 13), ""), HasSubstr("found byte 0"));
}

TEST(Drat, RefusesMalformedProofsInOneLine) {
  EXPECT_THAT(refusal(eight, "1 2 0\nfoo\n"), HasSubstr("a.drat:2: expected a literal's variable"));
  EXPECT_THAT(refusal(eight, "1 2 0\nd1 2 0\n"),
              HasSubstr("a.drat:2: expected a blank after 'd', found '1'"));
  EXPECT_THAT(refusal(eight, "1 2 0\n1"), HasSubstr("not ended by 0"));
  EXPECT_THAT(refusal(eight, "1 99999999 0\n"), HasSubstr("exceeds 4000000"));
  EXPECT_THAT(refusal(eight, "- 0\n"), HasSubstr("a.drat:1:"));
}

TEST(Drat, StopsWhenItIsToldTo) {
  std::string proof;
  for (int i = 0; i < 5000; ++i) {
    proof += "1 2 3 0\n";
  }
  const ProofVerdict verdict = check_text(eight, proof, {.stop = [] { return true; }});
  EXPECT_EQ(verdict.outcome, ProofVerdict::Outcome::stopped);
  EXPECT_FALSE(verdict.verified());
}

// Long before the first step of the proof is read.
TEST(Drat, StopsWhileItReadsTheFormula) {
  std::string formula = "p cnf 3 200000\n";
  for (int i = 0; i < 200'000; ++i) {
    formula += "1 2 3 0\n";
  }
  int asked = 0;
  const ProofVerdict verdict = check_text(formula, "0\n", {.stop = [&] { return ++asked == 3; }});
  EXPECT_EQ(verdict.outcome, ProofVerdict::Outcome::stopped);
  EXPECT_LT(verdict.clauses, 200'000U);
}

TEST(Drat, SaysWhenItsLimitsDoNotSuffice) {
  EXPECT_REFUSAL((void)check_text(eight, "", {.max_literals = 20}), MissingResource,
                 "more than 20 literals at once: raise the checker's limit");
  EXPECT_REFUSAL((void)check_proof_files("/nowhere/a.cnf", "/nowhere/a.drat"), MissingResource,
                 "/nowhere/a.cnf: cannot open; check the path and the permissions");
}

bool satisfiable(int variables, const Clauses& clauses) {
  for (unsigned bits = 0; bits < (1U << variables); ++bits) {
    const auto holds = [&](int x) {
      return ((bits >> (x < 0 ? -x - 1 : x - 1)) & 1U) == (x > 0 ? 1U : 0U);
    };
    if (std::all_of(clauses.begin(), clauses.end(), [&](const Clause& clause) {
          return std::any_of(clause.begin(), clause.end(), holds);
        })) {
      return true;
    }
  }
  return false;
}

// The clauses ¬(x₁ x₂ … xⱼ) in the order in which a search that branches on 1, 2, … refutes them.
void tree(int variables, Clause& prefix, Clauses& proof) {
  if (static_cast<int>(prefix.size()) < variables) {
    for (const int sign : {1, -1}) {
      prefix.push_back(sign * (static_cast<int>(prefix.size()) + 1));
      tree(variables, prefix, proof);
      prefix.pop_back();
    }
  }
  proof.push_back(prefix);
}

constexpr int most_variables = 4;

rc::Gen<Clause> some_clause() {
  return rc::gen::exec([] {
    const int size = *rc::gen::inRange(2, 4);
    Clause clause;
    for (int i = 0; i < size; ++i) {
      clause.push_back(*rc::gen::inRange(1, most_variables + 1) * *rc::gen::element(1, -1));
    }
    return clause;
  });
}

RC_GTEST_PROP(DratProperty, VerifiesTheTreeOfEveryFormulaWithoutSolutionAndOfNoOther, ()) {
  const auto clauses = *rc::gen::container<Clauses>(
      static_cast<std::size_t>(*rc::gen::inRange(4, 30)), some_clause());
  Clauses proof;
  Clause prefix;
  tree(most_variables, prefix, proof);
  const bool has_solution = satisfiable(most_variables, clauses);
  RC_CLASSIFY(!has_solution, "no solution");
  const ProofVerdict verdict = check_text(dimacs(most_variables, clauses), lines(proof));
  RC_ASSERT(verdict.verified() == !has_solution);
}

RC_GTEST_PROP(DratProperty, NeverVerifiesAFormulaThatHasASolution, ()) {
  const auto clauses = *rc::gen::container<Clauses>(
      static_cast<std::size_t>(*rc::gen::inRange(4, 24)), some_clause());
  std::string proof;
  const int steps = *rc::gen::inRange(1, 30);
  for (int i = 0; i < steps; ++i) {
    Clause clause = *some_clause();
    const bool deletes = *rc::gen::inRange(0, 3) == 0;
    if (deletes && *rc::gen::arbitrary<bool>()) {
      clause = *rc::gen::elementOf(clauses);
    } else if (!deletes && *rc::gen::inRange(0, 3) == 0) {
      clause[0] = *rc::gen::inRange(most_variables + 1, most_variables + 3) *
                  *rc::gen::element(1, -1);  // a new variable
    }
    // Steps that do not follow would end the check: leave them out.
    const std::string step = (deletes ? "d " : "") + lines({clause});
    const ProofVerdict verdict = check_text(dimacs(most_variables, clauses), proof + step);
    if (verdict.verified() || verdict.reason.find("ends without") != std::string::npos) {
      proof += step;
    }
  }
  const ProofVerdict verdict = check_text(dimacs(most_variables, clauses), proof);
  RC_CLASSIFY(verdict.verified(), "verified");
  RC_CLASSIFY(verdict.by_resolvents > 0, "by resolvents");
  RC_ASSERT(!verdict.verified() || !satisfiable(most_variables, clauses));
}

// So many clauses come and go that the store is compacted again and again.
TEST(Drat, SurvivesManyDeletions) {
  const int pigeons = 3;
  Clauses clauses;
  const auto in = [](int pigeon, int hole) { return (pigeon - 1) * 2 + hole; };
  for (int p = 1; p <= pigeons; ++p) {
    clauses.push_back({in(p, 1), in(p, 2)});
    for (int q = p + 1; q <= pigeons; ++q) {
      clauses.push_back({-in(p, 1), -in(q, 1)});
      clauses.push_back({-in(p, 2), -in(q, 2)});
    }
  }
  std::string proof;
  for (int round = 0; round < 20'000; ++round) {
    const std::string weak = "1 2 " + std::to_string(7 + round % 500) + " " +
                             std::to_string(-600 - round % 77) + " 1200 0\n";
    proof += weak + (round % 3 == 0 ? "" : "d " + weak);
  }
  const ProofVerdict verdict = check_text(dimacs(6, clauses), proof + "1 0\n0\n");
  EXPECT_TRUE(verdict.verified()) << verdict.line << ": " << verdict.reason;
  EXPECT_EQ(verdict.deleted, 13'333U);
  EXPECT_EQ(verdict.ignored_deletions, 0U);
  Clauses fewer(clauses.begin() + 1, clauses.end());
  EXPECT_FALSE(check_text(dimacs(6, fewer), proof + "1 0\n0\n").verified());
}

}  // namespace
}  // namespace changeover::drat_test
