// What tests said: which suspects are cleared, and which tests failed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/plan/diagnosis.hpp"
#include "plan/job/setup_list.hpp"

namespace changeover {

/// A bit for each test that failed and that some suspect explains.
using FailedBits = std::vector<std::uint64_t>;

class Evidence {
 public:
  /// @throws BadInput for a set-up that is none of the job.
  Evidence(const Job& job, const std::vector<TestedSetup>& tests);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] std::uint64_t passed() const { return passed_; }
  [[nodiscard]] std::uint64_t failed() const { return all_failed_; }

  [[nodiscard]] bool is_cleared(const Suspect& suspect) const {
    return met_.met(suspect.one, suspect.other.value_or(suspect.one));
  }
  /// Whether both parts, or the part if they are the same, were in a test that passed.
  [[nodiscard]] bool has_met(Element x, Element y) const { return met_.met(x, y); }
  /// Parts and pairs out of some parts that are not cleared: parts first.
  [[nodiscard]] std::vector<Suspect> suspects_among(const Block& parts) const;

  /// The tests that failed and that some suspect explains, each increasing, and their suspects.
  [[nodiscard]] const std::vector<Block>& failures() const { return failures_; }
  [[nodiscard]] const std::vector<std::vector<Suspect>>& suspects() const { return suspects_; }
  [[nodiscard]] FailedBits all() const;
  /// Those of them that have all of it.
  [[nodiscard]] FailedBits hit_by(const Suspect& suspect) const;
  /// The suspects that all of these tests have.
  [[nodiscard]] std::vector<Suspect> common(const FailedBits& tests) const;

  /// If all these suspects are a part and pairs of it: with whom. Nothing if they are not.
  [[nodiscard]] static std::optional<Block> companions(const std::vector<Suspect>& suspects,
                                                       Element part);
  /// The same of each test that failed and has such suspects only; each increasing.
  [[nodiscard]] std::vector<Block> companions_of(Element part) const;

  /// What failed though all of it is cleared, with a test that passed and had all of it if there is
  /// one; at most so many.
  [[nodiscard]] std::vector<std::pair<Block, Block>> contradictions(std::size_t most) const;

 private:
  const Job* job_;
  std::vector<Block> good_;  // what passed, increasing
  std::vector<Block> inexplicable_;
  Meetings met_;  // in tests that passed
  std::uint64_t passed_ = 0;
  std::uint64_t all_failed_ = 0;
  std::vector<Block> failures_;
  std::vector<std::vector<Suspect>> suspects_;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> with_;  // for each part a row of bits: the failures that it is in
};

/// Whether a set-up, increasing, has all of it.
[[nodiscard]] bool has_all_of(const Block& setup, const Suspect& suspect);

/// The suspects that are proven to be faults; increasing.
[[nodiscard]] std::vector<Suspect> proven_faults(const Evidence& evidence);

/// The smallest explanations that have what is proven, at most max_faults suspects besides; none if
/// there are none so small, or if none was found among 30,000 sets.
struct Explanations {
  std::uint64_t size = 0;  ///< of each; if there are no sets, no smaller set explains all
  std::vector<Explanation> sets;
  bool all = true;
};
[[nodiscard]] Explanations explanations_of(const Evidence& evidence,
                                           const std::vector<Suspect>& proven);

/// The test that splits some explanations best for its cost, from what is mounted at the start of
/// the job; or that proves one of the suspects, none of which is proven yet. Nothing if there is
/// none.
[[nodiscard]] std::optional<NextTest> splitting_test(const Evidence& evidence,
                                                     const std::vector<Explanation>& sets);
[[nodiscard]] std::optional<NextTest> proving_test(const Evidence& evidence,
                                                   const std::vector<Suspect>& suspects);

}  // namespace changeover
