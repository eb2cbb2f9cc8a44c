// Internal: items with two places each, of which one is the state that was last committed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/loadorder/all_pairs.hpp"

namespace changeover {

/// Place 0 of item x is in the data file, place 1 in another, at the same offset. Nothing that was
/// committed is written to before the next commit.
class VersionedItems {
 public:
  /// Opens and locks the data. @throws as ResultFile::open()
  VersionedItems(const std::string& data, const std::string& beside, std::uint64_t items,
                 std::uint64_t item_bytes, const ResultsClaim& claim,
                 std::function<void()> before_write);

  /// Opens the other file, or makes it. @throws as ResultFile::open()
  void begin();

  /// Commits that these items were stored, as an earlier run did.
  void replay(const std::vector<Element>& stored);

  /// Reads all items as they were committed, and so knows their checksums.
  void read_all();

  /// The newest version. Thread-safe for different items, as store() is.
  void read(Element x, std::span<std::byte> bytes) const;
  void store(Element x, std::span<const std::byte> bytes);

  /// Of all items, as they would be after a commit.
  [[nodiscard]] Checksum checksum() const;

  /// Brings what was stored to the disk; commit() says that it counts from now on.
  void sync() const;
  void commit();

  /// Copies all items to their own places, and waits for the disk.
  void copy_back();

 private:
  [[nodiscard]] std::uint64_t offset_of(Element x) const { return x * item_bytes_; }

  std::uint64_t item_bytes_;
  ResultsClaim claim_;
  ResultFile data_;
  ResultFile beside_;
  std::function<void()> before_write_;
  std::vector<std::uint8_t> committed_;  // by item: 0 or 1, its place
  std::vector<std::uint8_t> newest_;
  std::vector<Checksum> checksums_;
};

}  // namespace changeover
