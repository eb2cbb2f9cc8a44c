// Internal: what an earlier run of a job computed with another number of shares, according to its
// journals.
//
// A run that continues such a run names it by the checksum of those journals, so runs can form a
// chain: each is read with the results of those before it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/run/journal.hpp"

namespace changeover {

/// The shares of a job: stretches of an order with pairs spread evenly, without pairs (and items
/// with themselves) that were computed before.
[[nodiscard]] WorkerSplit shares_of(const LoadOrder& order, std::uint64_t shares,
                                    const std::function<bool(Element, Element)>& computed = {});

/// The text about its shares in the first line of a journal.
[[nodiscard]] std::string name_of_shares(const WorkerSplit& split, const std::string& after);

class EarlierShares {
 public:
  /// A recorded step, and what it computed: smaller item first, items with themselves, sorted.
  struct Done {
    std::uint64_t step = 0;
    std::vector<ItemPair> pairs;
    std::optional<Checksum> results;
  };

  EarlierShares() = default;

  /// Reads the journals of a job, in any order; `fields` identify the job. @throws BadInput if one
  /// is another job's, or continues a run whose journals are not all given; MissingResource if one
  /// cannot be read or is being written
  EarlierShares(const std::vector<std::string>& journals, const std::vector<JournalField>& fields,
                const LoadOrder& order);

  /// The checksum of the journals; empty if there are none.
  [[nodiscard]] const std::string& checksum() const { return checksum_; }
  [[nodiscard]] const std::vector<Done>& steps() const { return steps_; }
  [[nodiscard]] bool computed(Element x, Element y) const;

 private:
  struct Run;
  void read(const Run& run, const std::vector<JournalField>& fields, const LoadOrder& order);

  std::string checksum_;
  std::vector<Done> steps_;
  std::vector<bool> pairs_;  // by place in the list, or among all pairs
  std::vector<bool> items_;
  WantedPairs wanted_;
};

}  // namespace changeover
