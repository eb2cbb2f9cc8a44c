#include "io/read/point_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/read/declared.hpp"
#include "io/scan/text_scanner.hpp"

namespace changeover {

void PointBlocks::comment(std::string_view words, std::size_t offset) {
  const std::string_view first = next_word(words);
  if (first == "labels:") {
    read_labels(words, offset);
  } else if (first == "changeover" && next_word(words) == "design") {
    header_ = offset;
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
      const std::size_t equals = std::min(word.find('='), word.size() - 1);
      if (const auto defect = declare(file_, word.substr(0, equals), word.substr(equals + 1))) {
        fail(offset, *defect);
      }
    }
  }
}

void PointBlocks::read_labels(std::string_view words, std::size_t offset) {
  if (labels_) {
    fail(offset, "labels are listed twice; list them once");
  }
  labels_offset_ = offset;
  TokenTable known;
  for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
    if (const auto defect = add_label(known, word)) {
      fail(offset, *defect);
    }
  }
  labels_ = known.words();
}

void PointBlocks::declare_v(std::string_view number, std::size_t offset) {
  if (v_) {
    fail(offset, "the number of points is given twice; give it once");
  }
  const auto value = plain_number(number);
  if (!value || *value == 0 || *value > max_elements_in_memory) {
    fail(offset, fmt::format("{} is not a number of points; give a whole number from 1 to {}",
                             shown(number), max_elements_in_memory));
  }
  v_ = *value;
  v_offset_ = offset;
}

void PointBlocks::add(std::string_view number, std::size_t offset) {
  const auto value = plain_number(number);
  if (!value || *value > max_elements_in_memory) {
    fail(offset, fmt::format("{} is not a point; points are whole numbers up to {}", shown(number),
                             max_elements_in_memory));
  }
  add(static_cast<std::uint32_t>(*value), offset);
}

void PointBlocks::add(std::uint32_t number, std::size_t offset) {
  least_ = std::min(least_, number);
  greatest_ = std::max(greatest_, number);
  points_.push_back({number, static_cast<std::uint32_t>(offset)});
}

void PointBlocks::end_block(std::size_t offset) {
  // A point is two bytes at least, so there are not more of them than bytes.
  ends_.push_back({static_cast<std::uint32_t>(points_.size()), static_cast<std::uint32_t>(offset)});
}

Design PointBlocks::finish(const ReadOptions& options, std::uint32_t first) {
  if (v_ && file_.v && *v_ != *file_.v) {
    fail(v_offset_,
         fmt::format("{}, but a comment says v={}; correct one", count_of(*v_, "point"), *file_.v));
  }
  if (v_) {
    file_.v = v_;
  }
  Collector collector;
  std::size_t next = 0;
  for (const Point& end : ends_) {
    for (; next < end.number; ++next) {
      const Point& point = points_[next];
      if (point.number < first || (file_.v && point.number - first >= *file_.v)) {
        fail(point.offset,
             fmt::format("{} is not a point; they are numbered from {} to {}", point.number, first,
                         file_.v ? std::to_string(*file_.v - 1 + first) : "v"));
      }
      if (const auto defect = collector.add(std::to_string(point.number - first))) {
        fail(point.offset, *defect);
      }
    }
    if (const auto defect = collector.end_block()) {
      fail(end.offset, *defect);
    }
  }
  const Collector::Context context{.name = *name_,
                                   .declared = merged(*name_, options, file_),
                                   .labels = std::move(labels_),
                                   .labels_place = place_of(text_, labels_offset_),
                                   .place = place_of(text_, header_),
                                   .named = false,
                                   .place_of_word = [this](std::uint64_t word) {
                                     return place_of(
                                         text_, points_[static_cast<std::size_t>(word)].offset);
                                   }};
  return collector.finish(context);
}

}  // namespace changeover
