// Internal: the keys of a schedule in the head of the document changeover-loads/1.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/workers.hpp"
#include "io/write/json_writer.hpp"
#include "loadorder/show/show_loads.hpp"

namespace changeover {

/// How many workers a schedule is for; 0 for a single buffer.
[[nodiscard]] std::uint64_t workers_of(const LoadOrderFacts& facts, const SplitFacts* split);

/// The bytes of so many moves of items of the size that was given. @throws BadInput if they do not
/// fit into 64 bits.
[[nodiscard]] std::uint64_t bytes_of_moves(std::uint64_t count, const LoadsShown& how,
                                           const std::string& what);

/// Each function writes some keys, in their order in the document.
class ScheduleKeys {
 public:
  /// `split` is null without shares. All must outlive this object.
  ScheduleKeys(const LoadOrderFacts& facts, const SplitFacts* split, const LoadsShown& how)
      : facts_(facts), split_(split), how_(how) {}

  void say_question(JsonWriter& json) const;
  /// Nothing if items have no sizes.
  void say_bytes(const ScheduleVerdict& checked, JsonWriter& json) const;
  void say_levels_or_method(JsonWriter& json) const;
  void say_workers(JsonWriter& json) const;
  /// So many places or bytes are kept for what is loading; `others`: the bound of orders for the
  /// other places, if some are kept.
  void say_spare(std::uint64_t spare, const std::optional<LoadBound>& others,
                 const ScheduleVerdict& checked, JsonWriter& json) const;

 private:
  const LoadOrderFacts& facts_;
  const SplitFacts* split_;
  const LoadsShown& how_;
};

}  // namespace changeover
