// Lists of set-ups with the lines where they stand, and what is wrong with one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {

/// The set-ups and their results. If `forgiving`, parts of a run sheet that are none any more are
/// left out. Of a model, a first row with names of parameters heads columns of their values.
/// @throws as read_setups() and read_done().
[[nodiscard]] DoneList read_list(Input& input, const PartNames& names, std::uint64_t at_once,
                                 bool forgiving);

/// What stands behind a forbidden pair where it is named: " (why)", or nothing.
[[nodiscard]] std::string why_forbidden(const Job& job, Element x, Element y);
/// The set-ups that come first, whatever they may hold; if `gone` is given, names that are no parts
/// are left out and added to it. @throws as read_setups(), and for no set-up.
[[nodiscard]] DoneList read_first_list(Input& input, const PartNames& names, std::uint64_t at_once,
                                       std::vector<std::string>* gone = nullptr);

/// Why no list may hold this set-up, whose parts are parts of the job, none twice: without a place.
/// Nothing if one may.
[[nodiscard]] std::optional<std::string> setup_defect(const Job& job, const Block& setup);

/// Which pairs and, if asked for, which triples of parts were in one set-up. A set-up costs O(k ·
/// v/64), with triples O(k² · v/64), so that a long list is read in the time that its pairs take.
class Meetings {
 public:
  Meetings(std::uint64_t parts, bool triples);

  /// A set-up of any size. @throws BadInput for a part twice, or one that there is not; nothing is
  /// then added.
  void add(const Job& job, const Block& setup);
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
  Bits together_;  // of the last set-up
  Bits pairs_;     // for each part a row: with whom it was
  Bits triples_;   // for each two parts, x at x · parts + y, a row: with whom they were
};

/// Takes out the triples that have met; needed are then the pairs of the others. Nothing without
/// triples.
void drop_met_triples(Job& job, const Meetings& meetings);

}  // namespace changeover
