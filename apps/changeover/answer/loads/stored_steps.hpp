// What one worker stores if items change, as it is said.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/write_back.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

/// The steps of one worker, with what they store if that is asked for.
class StoredSteps {
 public:
  /// Calls take(step) for each step, from the first one.
  using Reader = std::function<void(const std::function<void(const WorkStep&)>& take)>;

  /// Reads them once, if asked to, and counts. `facts` must live as long. @throws InternalError if a change were lost
  StoredSteps(bool asked, const LoadOrderFacts& facts, Reader reader);

  /// Calls take(step) for each step, and if asked to for one more in which everything goes.
  void each(const std::function<void(const StoredStep&)>& take) const;

  /// What the head says; `alone` if items are computed alone, too.
  void add_to(JsonWriter& json, bool alone) const;
  [[nodiscard]] std::string text(bool alone) const;
  [[nodiscard]] std::string verified() const { return asked_ ? "; no change is lost" : ""; }
  [[nodiscard]] std::string column() const { return asked_ ? ",store" : ""; }

 private:
  [[nodiscard]] LoadBound bound(bool alone) const;

  bool asked_;
  const LoadOrderFacts& facts_;
  Reader reader_;
  std::uint64_t count_ = 0;
};

}  // namespace changeover::cli
