// Internal: items with two places each, of which one has the last committed state.
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

/// Place 0 of item x is in the data file, place 1 in another file, at the same offset. Committed
/// data are not overwritten before the next commit.
class VersionedItems {
 public:
  /// Opens and locks the data. @throws as ResultFile::open()
  VersionedItems(const std::string& data, const std::string& beside, std::uint64_t items,
                 std::uint64_t item_bytes, const ResultsClaim& claim,
                 std::function<void()> before_write);

  /// Opens or creates the other file. @throws as ResultFile::open()
  void begin();

  /// Commits the stores of an earlier run.
  void replay(const std::vector<Element>& stored);

  /// Reads all committed items and computes their checksums.
  void read_all();

  /// Reads the newest version. Thread-safe for different items, like store().
  void read(Element x, std::span<std::byte> bytes) const;
  void store(Element x, std::span<const std::byte> bytes);

  /// The checksum of all items after a commit.
  [[nodiscard]] Checksum checksum() const;

  /// Syncs the stored items to the disk; commit() makes them count.
  void sync() const;
  void commit();

  /// Copies all items to their own places and syncs them.
  void copy_back();

 private:
  [[nodiscard]] std::uint64_t offset_of(Element x) const { return x * item_bytes_; }

  std::uint64_t item_bytes_;
  ResultsClaim claim_;
  ResultFile data_;
  ResultFile beside_;
  std::function<void()> before_write_;
  std::vector<std::uint8_t> committed_;  // by item: 0 or 1, the place of its committed version
  std::vector<std::uint8_t> newest_;
  std::vector<Checksum> checksums_;
};

}  // namespace changeover
