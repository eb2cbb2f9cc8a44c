// A list of set-ups as a run sheet: what to take out and put in at each step, what it tests and costs.
//
//     RunSheet sheet = run_sheet(job, setups);
//     sheet.does_the_job();                        // all needed pairs, no forbidden one, room for all
//     sheet.steps[3].put_in;  to_string(sheet.cost);
//
// This is the referee of all plans: it reads the job and the set-ups, counts in the plainest way, and
// shares nothing with what made them. Contract: whatever the lists hold, faults are listed in `faults`
// and never thrown, but for an element that is no part.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

struct RunStep {
  Block take_out;  ///< increasing, like the others
  Block put_in;
  Block setup;
  std::vector<std::pair<Element, Element>> new_pairs;  ///< needed pairs that meet here first
  std::vector<Triple> new_triples;                     ///< likewise
  std::vector<std::pair<Element, Element>>
      replaced;  ///< if the job asks what is replaced: a part out and the one in its place, by the first;
                 ///< parts put in that are in none went to empty places
  Amount cost;  ///< of this step
  Amount cost_so_far;
  Amount weight_so_far;  ///< of needed pairs that have met, if the job weighs them
};

struct RunSheet {
  std::vector<RunStep> steps;
  std::uint64_t changes = 0;  ///< introductions
  Amount change_cost;         ///< of all introductions
  Amount cost;                ///< of everything
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;  ///< of the needed ones
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  Amount weight_needed;  ///< of all needed pairs, if the job weighs them
  Amount weight_tested;
  std::vector<std::string>
      faults;  ///< broken constraints, slots and what must come first included, but not missing pairs

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
  /// The number of introductions of every step after the first, if they agree, there is such a step and
  /// all set-ups are full: the list is then an m-change list.
  [[nodiscard]] std::optional<std::uint64_t> constant_change() const;
};

/// Counts everything. @throws BadInput if an element is not below job.parts();
/// ImpossibleParameters if the cost overflows. O(v² + introductions · room), and what assigning the parts put in to those taken
/// out takes if the job asks what is replaced.
[[nodiscard]] RunSheet run_sheet(const Job& job, const std::vector<Block>& setups);

}  // namespace changeover
