// Entries that wait in a file without a name until it is known that all of them may be added.
//
//     Spool spool;
//     spool.put(entry);
//     while (auto entries = spool.take(1000); !entries.empty()) {
//       …
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/catalog/entry.hpp"

namespace changeover {

class Spool {
 public:
  Spool();
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  /// Stores an entry unless there is one with its label: that design, or another one. @throws
  /// MissingResource if the disk is full.
  enum class Put : std::uint8_t { taken, there_already, label_of_another };
  Put put(const CatalogEntry& entry);

  /// The next entries in the order of put(); none at the end. Do not call put() afterwards.
  [[nodiscard]] std::vector<CatalogEntry> take(std::size_t most);

  /// The number of stored entries that were not taken.
  [[nodiscard]] std::uint64_t waiting() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover
