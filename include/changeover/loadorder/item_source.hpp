// Where the items of an all-pairs job come from: a file of fixed-size items, or a function of
// yours.
//
//     FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});   // items of 32 MiB
//     file.item_count();                           // the last one may be shorter
//
// A source is read by several threads at once. Buffers are given by the reader; they start at a
// multiple of 4096 bytes and have buffer_bytes() bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "changeover/core/block.hpp"

namespace changeover {

/// Start and length of buffers and of direct reads are multiples of it.
inline constexpr std::size_t buffer_alignment = 4096;

class ItemSource {
 public:
  virtual ~ItemSource() = default;
  ItemSource(const ItemSource&) = delete;
  ItemSource& operator=(const ItemSource&) = delete;

  [[nodiscard]] virtual std::uint64_t item_count() const = 0;

  /// Enough for any item.
  [[nodiscard]] virtual std::size_t buffer_bytes() const = 0;

  /// Reads an item and returns the part of `buffer` that it fills. Thread-safe. @throws BadInput if
  /// the item is malformed or cut off, MissingResource if it cannot be read; one line that names
  /// the item.
  virtual std::span<const std::byte> read(Element item, std::span<std::byte> buffer) = 0;

  /// Names the data in messages and in journals, e.g. the path and the size of a file.
  [[nodiscard]] virtual std::string describe() const = 0;

  /// One line that is another when the data are others, so that results of others are not taken for
  /// theirs; empty if the source cannot tell.
  [[nodiscard]] virtual std::string fingerprint() const { return {}; }

 protected:
  ItemSource() = default;
};

struct FileItemsOptions {
  std::uint64_t header_bytes = 0;  ///< before the first item
  /// Keep the data out of the page cache: O_DIRECT, or where a file system has none, ordinary reads
  /// whose pages are given back (posix_fadvise, POSIX_FADV_DONTNEED).
  bool bypass_cache = false;
};

/// A file cut into items of the same size.
class FileItems final : public ItemSource {
 public:
  /// @throws BadInput if item_bytes = 0, the file is not a regular one or holds no item;
  /// MissingResource if it cannot be opened.
  FileItems(const std::string& path, std::uint64_t item_bytes,
            const FileItemsOptions& options = {});
  ~FileItems() override;

  [[nodiscard]] std::uint64_t item_count() const override;
  [[nodiscard]] std::size_t buffer_bytes() const override;
  std::span<const std::byte> read(Element item, std::span<std::byte> buffer) override;
  [[nodiscard]] std::string describe() const override;

  /// The size, the times of the last change of the contents and of the file (the second cannot be
  /// set back), and a checksum of the first, the last and up to 62 other pages. So `touch`, `mv`
  /// and `chmod` make another fingerprint too.
  [[nodiscard]] std::string fingerprint() const override;

  /// Of all items together.
  [[nodiscard]] std::uint64_t data_bytes() const;

  /// How bytes are read: "direct", "dropped" (given back after reading) or "cached".
  [[nodiscard]] std::string access() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Items that a function makes.
class CallbackItems final : public ItemSource {
 public:
  /// Fills the buffer and returns how many bytes the item has. Thread-safe; may throw.
  using Read = std::function<std::size_t(Element item, std::span<std::byte> buffer)>;

  /// The fingerprint is yours to choose: a version, a checksum, …; see ItemSource::fingerprint().
  CallbackItems(std::uint64_t items, std::size_t bytes_per_item, Read read,
                std::string description = "a function", std::string fingerprint = {});

  [[nodiscard]] std::uint64_t item_count() const override { return items_; }
  [[nodiscard]] std::size_t buffer_bytes() const override { return bytes_; }
  std::span<const std::byte> read(Element item, std::span<std::byte> buffer) override;
  [[nodiscard]] std::string describe() const override { return description_; }
  [[nodiscard]] std::string fingerprint() const override { return fingerprint_; }

 private:
  std::uint64_t items_;
  std::size_t bytes_;
  Read read_;
  std::string description_;
  std::string fingerprint_;
};

/// How many items fit into `memory_bytes`. @throws BadInput if less than two do.
[[nodiscard]] std::uint64_t room_for(const ItemSource& source, std::uint64_t memory_bytes);

}  // namespace changeover
