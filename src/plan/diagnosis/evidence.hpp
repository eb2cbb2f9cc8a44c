// The evidence from tests: which suspects are cleared, and which tests failed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/plan/diagnosis.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {

/// A bit for each failed test that some suspect explains.
using FailedBits = std::vector<std::uint64_t>;

class Evidence {
 public:
  /// @throws BadInput for a set-up that does not belong to the job.
  Evidence(const Job& job, const std::vector<TestedSetup>& tests);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] std::uint64_t passed() const { return passed_; }
  [[nodiscard]] std::uint64_t failed() const { return all_failed_; }

  [[nodiscard]] bool is_cleared(const Suspect& suspect) const {
    return met_.met(suspect.one, suspect.other.value_or(suspect.one));
  }
  /// Whether both parts (or the part, if they are equal) were in a passed test.
  [[nodiscard]] bool has_met(Element x, Element y) const { return met_.met(x, y); }
  /// The parts and pairs among some parts that are not cleared: parts first.
  [[nodiscard]] std::vector<Suspect> suspects_among(const Block& parts) const;

  /// The failed tests that some suspect explains, each increasing, and their suspects.
  [[nodiscard]] const std::vector<Block>& failures() const { return failures_; }
  [[nodiscard]] const std::vector<std::vector<Suspect>>& suspects() const { return suspects_; }
  [[nodiscard]] FailedBits all() const;
  /// The failed tests that contain the suspect.
  [[nodiscard]] FailedBits hit_by(const Suspect& suspect) const;
  /// The suspects that all of these tests contain.
  [[nodiscard]] std::vector<Suspect> common(const FailedBits& tests) const;

  /// If all these suspects are a part and pairs with it: its partners; otherwise nullopt.
  [[nodiscard]] static std::optional<Block> companions(const std::vector<Suspect>& suspects,
                                                       Element part);
  /// The same for each failed test that has only such suspects; each increasing.
  [[nodiscard]] std::vector<Block> companions_of(Element part) const;

  /// Failed tests in which everything is cleared, each with a passed test that contains it, if
  /// there is one; at most `most`.
  [[nodiscard]] std::vector<std::pair<Block, Block>> contradictions(std::size_t most) const;

 private:
  const Job* job_;
  std::vector<Block> good_;  // passed tests, increasing
  std::vector<Block> inexplicable_;
  Meetings met_;  // in passed tests
  std::uint64_t passed_ = 0;
  std::uint64_t all_failed_ = 0;
  std::vector<Block> failures_;
  std::vector<std::vector<Suspect>> suspects_;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> with_;  // by part: a bit for each failed test that contains it
};

/// Whether an increasing set-up contains the whole suspect.
[[nodiscard]] bool has_all_of(const Block& setup, const Suspect& suspect);

/// The suspects that are proven to be faults, increasing.
[[nodiscard]] std::vector<Suspect> proven_faults(const Evidence& evidence);

/// The smallest explanations that contain the proven faults and at most max_faults further
/// suspects; empty if there are none that small, or none was found among 30,000 sets.
struct Explanations {
  std::uint64_t size = 0;  ///< of each; if there are no sets, no smaller set explains everything
  std::vector<Explanation> sets;
  bool all = true;
};
[[nodiscard]] Explanations explanations_of(const Evidence& evidence,
                                           const std::vector<Suspect>& proven);

/// The test that splits some explanations best for its cost, from what is mounted at the start of
/// the job, or that proves one of the suspects, none of which is proven yet. Nullopt if there is
/// none.
[[nodiscard]] std::optional<NextTest> splitting_test(const Evidence& evidence,
                                                     const std::vector<Explanation>& sets);
[[nodiscard]] std::optional<NextTest> proving_test(const Evidence& evidence,
                                                   const std::vector<Suspect>& suspects);

}  // namespace changeover
