// The proof checker where a small fault of it would hide: signs and lengths of binary proofs, what
// is counted, what deletion may take away, when it asks whether to stop. Most of these were missing
// until planted faults survived.
#include <istream>
#include <set>
#include <streambuf>
#include <utility>

#include "message_of.hpp"
#include "proof_texts.hpp"

namespace changeover::drat_details_test {
namespace {

using namespace test;
using testing::HasSubstr;
using Outcome = ProofVerdict::Outcome;

const ProofOptions binary{.format = ProofFormat::binary};

// ---- Binary proofs ------------------------------------------------------------------------------

TEST(DratBinary, KnowsALiteralFromItsNegation) {
  // 1 follows, −1 does not; 3 and then −3 do.
  EXPECT_TRUE(check_text(needs_unit,
                         binary_step('a', {1}) + binary_step('a', {3}) + binary_step('a', {}),
                         binary)
                  .verified());
  const ProofVerdict verdict = check_text(needs_unit, binary_step('a', {-1}), binary);
  EXPECT_EQ(verdict.outcome, Outcome::refuted);
  EXPECT_EQ(verdict.line, 1U);
  EXPECT_THAT(verdict.reason, HasSubstr("the clause -1 0 does not follow"));
}

TEST(DratBinary, ReadsNumbersOfAnyLength) {
  for (const int x : {1, 31, 32, 63, 64, 100, 8191, 8192, 100'000}) {
    for (const int sign : {1, -1}) {
      // Nothing has −1: that clause does not follow, and is shown as it was read.
      const std::string shown = "1 " + std::to_string(sign * (x + 1)) + " 0";
      const ProofVerdict verdict =
          check_text("p cnf 1 1\n-1 0\n", binary_step('a', {1, sign * (x + 1)}), binary);
      EXPECT_EQ(verdict.outcome, Outcome::refuted);
      EXPECT_THAT(verdict.reason, HasSubstr("the clause " + shown + " does not follow"));
    }
  }
  const ProofOptions few{.format = ProofFormat::binary, .max_variable = 64};
  EXPECT_EQ(check_text(eight, binary_step('a', {64, 2}) + binary_step('a', {-64, 3}), few).added,
            2U);
  EXPECT_THAT(refusal(eight, binary_step('a', {65, 2}), few),
              HasSubstr("a.drat:1: a literal's variable exceeds 64"));
  EXPECT_THAT(refusal(eight, binary_step('a', {64, 2}) + binary_step('d', {-65}), few),
              HasSubstr("a.drat:2: a lit"));
}

TEST(DratBinary, ReadsSixBytesForANumberAndNoMore) {
  using namespace std::string_literals;
  // 10 is the literal 5, which is new; the longer forms say the same.
  for (const std::string& number : {"\x0a"s, "\x8a\x00"s, "\x8a\x80\x80\x80\x80\x00"s}) {
    const ProofVerdict verdict = check_text(eight, "a" + number + "\0"s, binary);
    EXPECT_EQ(verdict.added, 1U);
    EXPECT_EQ(verdict.line, 1U) << "the steps that were read";
    EXPECT_THAT(verdict.reason, HasSubstr("without a contradiction"));
  }
  EXPECT_THAT(refusal(eight, "a\x8a\x80\x80\x80\x80\x80\x00\x00"s, binary), HasSubstr("exceeds"));
  EXPECT_THAT(refusal(eight, "a"s, binary),
              HasSubstr("a.drat:1: the last clause is not ended by 0: the file seems cut off"));
  EXPECT_THAT(refusal(eight, "a\x0a"s, binary),
              HasSubstr("a.drat:1: the last clause is not ended by 0"));
  EXPECT_THAT(refusal(eight, "a\x8a"s, binary),
              HasSubstr("a.drat:1: the last clause is not ended by 0"));
}

TEST(DratBinary, EndsAtTheNumberOfItsSteps) {
  const std::string proof =
      binary_step('a', {1, 2}) + binary_step('a', {1, 2, 9}) + binary_step('d', {1, 2, 9});
  const ProofVerdict verdict = check_text(eight, proof, binary);
  EXPECT_EQ(verdict.outcome, Outcome::refuted);
  EXPECT_EQ(verdict.line, 3U);
  EXPECT_EQ(check_text(eight, "1 2 0\n1 2 9 0\n\n").line, 4U);
}

// ---- Text ---------------------------------------------------------------------------------------

TEST(DratText, TakesBlanksCommentsAndLinesAsTheyCome) {
  EXPECT_TRUE(
      check_text(
          "c a\n\n \nc b\n\n\np \tcnf\t2  3 \t\r\n1\t0\r\nc x\n\nc y\n-1\n2 0\n\n\n-2 0\nc the end",
          "")
          .verified());
  EXPECT_TRUE(
      check_text(eight, "c x\n\nc y\n\n1\n2 0\r\n1\t0\nd \n1\n2 0\n2 0\n\n\nc z\n0\nc").verified());
  EXPECT_TRUE(check_text("\n \n\np cnf 1 2\n1 0\n-1 0\n", "").verified());
  EXPECT_EQ(check_text("p cnf 0 0", "").outcome, Outcome::refuted);
  EXPECT_EQ(check_text("p cnf 3 0\nc only a comment", "c only a comment").outcome,
            Outcome::refuted);
}

TEST(DratText, ShowsWhatItFound) {
  EXPECT_THAT(refusal("", ""),
              HasSubstr("expected the header 'p cnf VARIABLES CLAUSES', found the end"));
  EXPECT_THAT(refusal("p c nf 1 1\n", ""), HasSubstr("found byte 32"));
  EXPECT_THAT(refusal("p \ncnf 1 1\n1 0\n", ""), HasSubstr("found byte 10"));
  EXPECT_THAT(refusal("!", ""), HasSubstr("found '!'"));
  EXPECT_THAT(refusal("~", ""), HasSubstr("found '~'"));
  EXPECT_THAT(refusal("\x7f", ""), HasSubstr("found byte 127"));
  EXPECT_THAT(refusal("\x80", ""), HasSubstr("found byte 128"));
  EXPECT_THAT(refusal("p cnf 1 -1\n", ""), HasSubstr("the header has a negative number"));
  EXPECT_THAT(refusal("p cnf 1 1 1\n", ""), HasSubstr("expected the end of the line, found '1'"));
  EXPECT_THAT(refusal("p cnf 4 1\n4 -4 5 0\n", ""),
              HasSubstr("a.cnf:2: a literal's variable exceeds 4"));
  EXPECT_THAT(refusal("p cnf 3 1\n1 2\n3", ""),
              HasSubstr("a.cnf:3: the last clause is not ended by 0"));
}

// A file whose disk fails after some bytes.
class FailingBuffer final : public std::streambuf {
 public:
  explicit FailingBuffer(std::string bytes) : bytes_(std::move(bytes)) {
    setg(bytes_.data(), bytes_.data(), bytes_.data() + bytes_.size());
  }

 protected:
  int_type underflow() override { throw std::ios_base::failure("input/output error"); }

 private:
  std::string bytes_;
};

// What was read so far may look whole: it is not judged.
TEST(DratText, AFileThatCannotBeReadIsNoShortOne) {
  FailingBuffer half("p cnf 1 2\n1 0\n-1 0\n");
  std::istream formula(&half);
  std::istringstream none;
  try {
    (void)check_proof(formula, "a.cnf", none, "a.drat", {});
    ADD_FAILURE() << "a failed disk is no end";
  } catch (const MissingResource& fault) {
    EXPECT_STREQ(fault.what(), "a.cnf: cannot read; check the file and the disk");
  }
}

TEST(DratText, ShowsEightLiteralsOfAClause) {
  const auto shown = [](const std::string& clause) {
    return check_text("p cnf 20 1\n-1 0\n", clause + " 0\n").reason;
  };
  EXPECT_THAT(shown("1 2 3 4 5 6 7 8"), HasSubstr("the clause 1 2 3 4 5 6 7 8 0 does not follow"));
  EXPECT_THAT(shown("1 2 3 4 5 6 7 8 9"),
              HasSubstr("the clause 1 2 3 4 5 6 7 8 ... 0 does not follow"));
  EXPECT_THAT(shown("1 5 -3 2"), HasSubstr("the clause 1 2 -3 5 0 does not follow"));
  EXPECT_THAT(shown("1 5 -3 2"), HasSubstr("resolution on 1"));
}

// ---- Counting -----------------------------------------------------------------------------------

TEST(DratCounts, AreExact) {
  const ProofVerdict verdict = check_text(eight, "1 2 0\n7 -7 0\n1 0\n2 0\n0\n");
  EXPECT_TRUE(verdict.verified());
  EXPECT_EQ(verdict.added, 4U);  // the contradiction is there once 2 is
  EXPECT_EQ(verdict.line, 4U);
  EXPECT_EQ(verdict.deleted, 0U);
  EXPECT_EQ(verdict.ignored_deletions, 0U);
  EXPECT_EQ(check_text("p cnf 3 2\n1 0\n-1 2 0\n", "").propagations, 2U);
  EXPECT_EQ(check_text("p cnf 3 1\n1 2 0\n", "").propagations, 0U);
  const ProofVerdict nothing = check_text("p cnf 0 0\n", "");
  EXPECT_EQ(
      nothing.added + nothing.deleted + nothing.by_resolvents + nothing.variables + nothing.clauses,
      0U);
  EXPECT_EQ(check_text("p cnf 2 2\n1 0\n-1 0\n", "").line, 0U);
}

TEST(DratCounts, ClausesAfterAContradictionToo) {
  EXPECT_EQ(check_text("p cnf 2 4\n1 0\n-1 0\n2 -2 0\n1 2 0\n", "").clauses, 4U);
}

// ---- Deletion -----------------------------------------------------------------------------------

TEST(DratDeletion, FindsAClauseHoweverItIsWritten) {
  const auto counts = [](const std::string& cnf, const std::string& proof) {
    const ProofVerdict verdict = check_text(cnf, proof);
    return std::pair(verdict.deleted, verdict.ignored_deletions);
  };
  using Counts = std::pair<std::uint64_t, std::uint64_t>;
  EXPECT_EQ(counts("p cnf 4 1\n1 2 0\n", "d 1 2 0\n"), Counts(1, 0));
  EXPECT_EQ(counts("p cnf 4 1\n1 2 0\n", "d 2 1 2 0\n"), Counts(1, 0));
  EXPECT_EQ(counts("p cnf 4 1\n1 2 1 0\n", "d 2 1 0\nd 2 1 0\n"), Counts(1, 1));
  EXPECT_EQ(counts("p cnf 4 1\n1 2 -1 0\n", "d 1 2 -1 0\nd 1 2 0\nd 0\n"), Counts(0, 3));
  EXPECT_EQ(counts("p cnf 4 2\n1 2 -3 0\n1 2 3 0\n", "d 3 1 2 0\nd 3 1 2 0\nd -3 2 1 0\n"),
            Counts(2, 1));
  EXPECT_EQ(counts("p cnf 4 1\n1 2 3 0\n", "d 1 2 0\nd 1 2 4 0\nd 1 2 3 4 0\n"), Counts(0, 3));
}

// Nothing has been laid out for such a variable yet.
TEST(DratDeletion, OfAVariableThatNothingHasIsIgnored) {
  const ProofVerdict verdict = check_text(eight, "d 3999999 -3999998 0\n0\n");
  EXPECT_EQ(verdict.ignored_deletions, 1U);
  EXPECT_EQ(verdict.deleted, 0U);
}

TEST(DratDeletion, LeavesUnitsAndWhatFixedALiteral) {
  EXPECT_EQ(check_text("p cnf 3 3\n1 0\n1 0\n2 3 0\n", "d 1 0\n").ignored_deletions, 1U);
  // 1 is what is left of the clause when it comes.
  EXPECT_EQ(check_text("p cnf 5 3\n-2 0\n-5 0\n1 2 5 0\n", "d 1 2 5 0\n").ignored_deletions, 1U);
  // Not needed: 1 was there before.
  EXPECT_EQ(check_text("p cnf 5 4\n1 0\n-2 0\n-5 0\n1 2 5 0\n", "d 1 2 5 0\n").deleted, 1U);
}

TEST(DratDeletion, ForgetsWhatWasOnlyAssumed) {
  // Each step propagates through clauses, and none of them has fixed anything after it.
  const std::string all =
      "d 1 2 -3 0\nd -1 -2 3 0\nd 2 3 -4 0\nd -2 -3 4 0\nd -1 -3 -4 0\nd 1 3 4 0\nd -1 2 4 0\n"
      "d 1 -2 -4 0\n";
  const ProofVerdict steps = check_text(eight, "1 2 0\n" + all + "d 1 2 0\n");
  EXPECT_EQ(steps.deleted, 9U);
  EXPECT_EQ(steps.ignored_deletions, 0U);
  const ProofVerdict resolvents =
      check_text(eight, "5 -6 -7 0\n-5 6 0\n-5 7 0\n" + all + "d 6 -5 0\nd 7 -5 0\n");
  EXPECT_EQ(resolvents.by_resolvents, 3U);
  EXPECT_EQ(resolvents.deleted, 10U);
}

TEST(DratDeletion, FindsEachOfThousandsOfClauses) {
  Clauses clauses;
  for (int i = 0; i < 5000; ++i) {
    clauses.push_back({1 + i, 6000 - (i % 7), -7000 - i});
  }
  std::string proof;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    const Clause& clause = clauses[(i * 37) % clauses.size()];
    proof += "d " + lines({{clause[2], clause[0], clause[1]}});
  }
  const ProofVerdict once = check_text(dimacs(12'000, clauses), proof);
  EXPECT_EQ(once.deleted, 5000U);
  EXPECT_EQ(once.ignored_deletions, 0U);
  const ProofVerdict verdict = check_text(dimacs(12'000, clauses), proof + proof);
  EXPECT_EQ(verdict.deleted, 5000U);
  EXPECT_EQ(verdict.ignored_deletions, 5000U);
}

// What one resolvent assumed is forgotten before the next: −2 makes 3 true, and then the second
// would follow.
TEST(DratResolvents, AreTriedEachByItself) {
  const ProofVerdict verdict =
      check_text("p cnf 4 5\n-1 2 0\n-1 3 0\n1 2 3 0\n1 2 4 0\n1 2 -4 0\n", "1 0\n");
  EXPECT_EQ(verdict.outcome, Outcome::refuted);
  EXPECT_EQ(verdict.line, 1U);
  EXPECT_EQ(verdict.added, 0U);
  // Deleted clauses have no say: without the second one, 1 follows.
  EXPECT_EQ(check_text("p cnf 4 5\n-1 2 0\n-1 3 0\n1 2 3 0\n1 2 4 0\n1 2 -4 0\n", "d -1 3 0\n1 0\n")
                .by_resolvents,
            1U);
}

// ---- Limits and stopping ------------------------------------------------------------------------

TEST(DratLimits, AreMetExactly) {
  // Eight clauses of three literals, three words more for each.
  EXPECT_NO_THROW((void)check_text(eight, "", {.max_literals = 48}));
  EXPECT_REFUSAL((void)check_text(eight, "", {.max_literals = 47}), MissingResource,
                 "more than 47 literals at once: raise the checker's limit");
  std::string proof;
  for (int i = 0; i < 30; ++i) {
    proof += "1 2 0\nd 1 2 0\n";
  }
  EXPECT_EQ(check_text(eight, proof, {.max_literals = 53}).deleted, 30U);
  EXPECT_REFUSAL((void)check_text(eight, "1 2 0\n1 2 5 0\n", {.max_literals = 53}), MissingResource,
                 "more than 53 literals at once: raise the checker's limit");
  // So may one clause be, of the formula or the proof.
  EXPECT_THAT(refusal("p cnf 4 0\n", "1 2 3 4 0\n", {.max_literals = 3}),
              HasSubstr("a.drat:1: a clause has more than 3 literals"));
  EXPECT_THAT(refusal("p cnf 4 1\n1 2 3 4 0\n", "", {.max_literals = 3}),
              HasSubstr("a.cnf:2: a clause has more than 3 literals"));
  EXPECT_EQ(check_text("p cnf 4 0\n", "1 2 3 0\n", {.max_literals = 6}).added, 1U);
  EXPECT_EQ(check_text("p cnf 1 0\n", "9 0\n", {.max_variable = 9}).added, 1U);
  EXPECT_THAT(refusal("p cnf 1 0\n", "10 0\n", {.max_variable = 9}), HasSubstr("exceeds 9"));
}

/// How often a check asks whether to stop, if it is never told to.
int asked(const std::string& cnf, const std::string& proof) {
  int times = 0;
  const ProofVerdict verdict = check_text(cnf, proof, {.stop = [&] {
                                            ++times;
                                            return false;
                                          }});
  EXPECT_NE(verdict.outcome, Outcome::stopped);
  return times;
}

std::string repeated(const std::string& step, int times) {
  std::string proof;
  for (int i = 0; i < times; ++i) {
    proof += step;
  }
  return proof;
}

TEST(DratStop, IsAskedForEach1024Steps) {
  const std::string step = "d 9 0\n";  // nothing to look at
  const int before = asked(eight, repeated(step, 1023));
  EXPECT_EQ(asked(eight, repeated(step, 1)), before);
  EXPECT_EQ(asked(eight, repeated(step, 1024)), before + 1);
  EXPECT_EQ(asked(eight, repeated(step, 2047)), before + 1);
  EXPECT_EQ(asked(eight, repeated(step, 2048)), before + 2);
  // Told at any of these times, it says which step it was at: none yet, one of those, the last.
  std::set<std::uint64_t> stopped_at;
  for (int at = 1; at <= before + 2; ++at) {
    int times = 0;
    const ProofVerdict verdict =
        check_text(eight, repeated(step, 3000), {.stop = [&] { return ++times == at; }});
    EXPECT_EQ(verdict.outcome, Outcome::stopped);
    EXPECT_THAT(verdict.reason, HasSubstr("the check was stopped"));
    stopped_at.insert(verdict.line);
  }
  EXPECT_THAT(stopped_at, testing::ElementsAre(0, 1024, 2048, 3000));
}

TEST(DratStop, IsAskedForEachMillionLooks) {
  Clauses many;
  Clauses apart;
  for (int i = 0; i < 2000; ++i) {
    many.push_back({1, 1000 + i});
    apart.push_back({2, 1000 + i});
  }
  const std::string step = "1 3 0\n";  // takes a look at all that has 1
  const int here = asked(dimacs(4000, many), repeated(step, 1000));
  const int there = asked(dimacs(4000, apart), repeated("4 3 0\n", 100));
  EXPECT_GE(here, there + 2);
  EXPECT_LE(here, there + 20);
}

}  // namespace
}  // namespace changeover::drat_details_test
