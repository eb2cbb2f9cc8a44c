// The search tree of one case: partial designs, block after block.
//
// A node is a list of blocks; its children are the blocks that may follow. Elements that were in
// the same blocks so far (twins) have consecutive numbers; one bit per element marks a twin of the
// element below it. A block is in standard form if it contains the lowest elements of each run of
// twins. Going down copies the masks of missing pairs, 8v bytes; going up costs nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

/// Called while a tree is explored.
class EnumerationVisitor {
 public:
  virtual ~EnumerationVisitor() = default;

  /// The blocks 0, …, depth of a node at the requested depth, as masks; returning false stops.
  virtual bool reached(std::span<const std::uint64_t> blocks) = 0;

  /// Called about every thousand nodes, and where there are none for long; returning false stops.
  /// `nodes` is the number of nodes since the last call.
  virtual bool go_on(std::uint64_t nodes) = 0;

 protected:
  EnumerationVisitor() = default;
  EnumerationVisitor(const EnumerationVisitor&) = default;
  EnumerationVisitor& operator=(const EnumerationVisitor&) = default;
};

class EnumerationTree {
 public:
  /// Keeps references.
  EnumerationTree(const EnumerationCase& own, const DegreeTable& degrees);

  /// The memory of a tree for b blocks.
  [[nodiscard]] static std::uint64_t bytes(std::uint64_t b) {
    return b * (sizeof(Level) + sizeof(Mask));
  }

  /// Visits, from left to right, all nodes at `depth` below the node with these blocks, which
  /// include the first block; the designs are at depth b−1. Returns false if the visitor stopped
  /// it.
  bool explore(std::span<const std::uint64_t> blocks, std::size_t depth,
               EnumerationVisitor& visitor);

 private:
  using Mask = std::uint64_t;

  struct Level {
    Mask block = 0;
    Mask twins = 0;      // x is a twin of x − 1
    Mask first_run = 0;  // in every block so far
    std::int64_t excess = 0;
    std::array<Mask, 64> missing{};
    std::array<std::uint8_t, 64> still{};  // number of missing pairs
    std::array<std::int16_t, 64>
        run_begin{};  // of elements in the block; −1 for before the first block
    std::array<std::int16_t, 64>
        first_end{};  // blocks of the first run that began before the first block
  };

  // Data for choosing the next block, for one node.
  struct Choice {
    std::size_t depth = 0;
    const DegreeTable::Row* row = nullptr;
    std::uint64_t all_out = 0;    // costs of the elements outside, if they remain outside
    std::uint64_t base = 0;       // all_out and the costs of the leaving elements
    std::uint64_t allowance = 0;  // without further excess
    bool lanes_full = false;      // the allowance was capped, so do not subtract from it
    Mask must_leave = 0;
    Mask must_stay = 0;
    Mask stay = 0;
  };

  bool expand(std::size_t depth);
  bool may_go_on();
  bool choose_leaving(Choice& choice, Mask from, Mask leaving, std::size_t more);
  bool introduce(const Choice& choice, Mask from, Mask introduced, std::size_t more,
                 std::int64_t excess);
  bool enter(const Choice& choice, Mask introduced, std::int64_t excess);
  void descend(std::size_t depth, Mask block, std::int64_t excess);
  void follow_runs(std::size_t depth);
  void limit_runs(Choice& choice) const;
  [[nodiscard]] bool runs_begin_well(std::size_t depth) const;
  [[nodiscard]] bool is_design() const;

  [[nodiscard]] std::uint64_t cost(const Choice& choice, std::size_t x, bool in,
                                   std::size_t missing) const;

  const EnumerationCase& own_;
  const DegreeTable& degrees_;
  std::vector<Level> levels_;
  std::vector<Mask> path_;
  std::array<std::size_t, 64> role_offset_{};
  EnumerationVisitor* visitor_ = nullptr;
  std::size_t target_ = 0;
  std::uint64_t nodes_ = 0;  // since the last call of the visitor
  unsigned choices_ = 0;
};

}  // namespace changeover
