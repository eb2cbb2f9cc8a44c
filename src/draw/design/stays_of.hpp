// The stays of the elements of a design, as far as its drawn blocks show them.
//
//     const DrawnStays stays = stays_of(drawing);
//     for (const Element x : ordered(stays, ElementOrder::first)) {
//       draw(stays.of[x]);
//     }
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/design/frame.hpp"

namespace changeover {

/// Consecutive blocks, counted from 1, that hold an element; of a stay over the end of a circular
/// design `from` is greater than `to` unless it takes all blocks.
struct DrawnStay {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::uint64_t length = 0;   ///< in drawn blocks
  bool began_before = false;  ///< it was there before what is drawn
  bool goes_on = false;       ///< it is there after what is drawn
  bool over_the_end = false;  ///< the last block and the first are both in it, one after the other

  bool operator==(const DrawnStay&) const = default;
};

struct DrawnStays {
  std::vector<std::vector<DrawnStay>> of;  ///< by element, in the order in which they are seen
  std::uint64_t first = 0, last = 0;       ///< the blocks that are drawn
};

/// @throws BadInput as Drawing::require_range() and Drawing::require_fits().
[[nodiscard]] DrawnStays stays_of(const Drawing& drawing);

/// The stays of anything that comes and goes: by step, from 1, which of `rows` rows are there.
/// @throws InternalError for a row that is not below `rows`, or if there is no step.
[[nodiscard]] DrawnStays stays_of(const std::vector<std::vector<Element>>& steps, std::size_t rows);

/// All elements, those that are in no block last.
[[nodiscard]] std::vector<Element> ordered(const DrawnStays& stays, ElementOrder order);

/// Stays as a picture: a row an element, a bar a stay.
struct StaysFigure {
  DrawnStays stays;
  std::vector<std::string> names;  ///< of the rows
  Heading heading;
  std::string summary;  ///< what there is, at the beginning of the description
  std::string row = "element";
  std::string step = "block";
  ElementOrder order = ElementOrder::first;
  StayColour colour = StayColour::length;
  bool circular = false;
};

[[nodiscard]] Picture draw_stays(const StaysFigure& figure);

}  // namespace changeover
