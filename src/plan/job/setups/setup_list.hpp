// Lists of set-ups with their lines, and checks of a set-up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {

/// Reads set-ups and their results. If `forgiving`, parts of a run sheet that no longer exist are
/// left out. For a model, a first row with names of parameters heads columns of their values.
/// @throws as read_setups() and read_done().
[[nodiscard]] DoneList read_list(Input& input, const PartNames& names, std::uint64_t at_once,
                                 bool forgiving);

/// The text after a forbidden pair in messages: " (why)", or empty.
[[nodiscard]] std::string why_forbidden(const Job& job, Element x, Element y);
/// Reads the set-ups that come first, without checking them; if `gone` is given, unknown names are
/// left out and added to it. @throws as read_setups(), and for no set-up.
[[nodiscard]] DoneList read_first_list(Input& input, const PartNames& names, std::uint64_t at_once,
                                       std::vector<std::string>* gone = nullptr);

/// The set-ups of such a list, with the parts of the job; of a model, completed. `name` is that of
/// the list; messages begin with `bench`, if it is given. @throws as read_first()
[[nodiscard]] std::vector<Block> checked_first(const std::string& name, DoneList list,
                                               const Job& job, const std::string& bench = "");

/// Why no list may contain this set-up (of parts of the job, without repetition), without a place;
/// nullopt if it may.
[[nodiscard]] std::optional<std::string> setup_defect(const Job& job, const Block& setup);

/// What remains mounted of the last set-up that was done if fewer parts fit now: the parts that
/// stay mounted, and then its first ones. `room` is that of the job if it is not given.
[[nodiscard]] Block what_stays(const Job& job, const Block& setup,
                               std::optional<std::uint64_t> room = {});

/// Records which pairs and, on request, which triples of parts were in one set-up. A set-up takes
/// O(k · v/64), with triples O(k² · v/64), so that a long list takes time proportional to its
/// pairs.
class Meetings {
 public:
  Meetings(std::uint64_t parts, bool triples);

  /// Adds a set-up of any size: of one with a value out of range its pairs with that, of one with
  /// two nothing, since either may hide the other. @throws BadInput for a repeated or unknown part;
  /// nothing is added then.
  void add(const Job& job, const Block& setup);
  /// Only throws as add() would.
  void look_at(const Job& job, const Block& setup);
  [[nodiscard]] bool met(Element x, Element y) const { return has(pairs_, x, y); }
  [[nodiscard]] bool met(const Triple& t) const {
    return has(triples_, t[0] * parts_ + t[1], t[2]);
  }

 private:
  using Bits = std::vector<std::uint64_t>;
  void add_hidden(const Block& setup, Element hiding);
  [[nodiscard]] bool has(const Bits& bits, std::size_t row, Element column) const {
    return (bits[row * words_ + column / 64] >> (column % 64) & 1U) != 0;
  }

  std::size_t parts_;
  std::size_t words_;
  Bits together_;  // of the last set-up that was looked at
  Bits pairs_;     // one row per part: the parts that it was with
  Bits triples_;   // one row per pair x, y, at x · parts + y: the parts that it was with
};

/// Removes the triples that have met; the pairs of the others are then needed. Does nothing without
/// triples.
void drop_met_triples(Job& job, const Meetings& meetings);

}  // namespace changeover
