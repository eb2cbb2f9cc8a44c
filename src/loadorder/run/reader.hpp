// Internal: a fixed pool of buffers (or, for items with sizes, a buffer for each load) and the
// threads that fill them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"

namespace changeover {

/// `room` buffers, each of them free, loading or loaded. Only one thread, the owner, may call
/// request(), wait() and release().
class Reader {
 public:
  /// With `sizes` a buffer has the size of its item, and is freed when the item is released.
  /// @throws std::bad_alloc; MissingResource if a thread cannot be started
  Reader(ItemSource& source, std::uint64_t items, std::uint64_t room, unsigned threads,
         std::shared_ptr<const ItemSizes> sizes = nullptr);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Starts to load an item. @throws InternalError if no buffer is free.
  void request(Element item);

  /// Waits until a requested item is loaded. @throws what reading it has thrown.
  ItemView wait(Element item);

  /// The view of an item that was waited for.
  [[nodiscard]] ItemView view(Element item) const {
    const Slot& slot = slots_[where_[item]];
    return {item, slot.bytes, &slot.buffer};
  }

  /// Frees the buffer of an item that was waited for.
  void release(Element item);

  [[nodiscard]] std::uint64_t most_used() const { return most_used_; }
  [[nodiscard]] std::uint64_t requests() const { return requests_; }
  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }
  [[nodiscard]] std::chrono::duration<double> waited() const { return waited_; }

 private:
  struct Slot {
    std::shared_ptr<const std::byte> buffer;
    std::byte* place = nullptr;  // the same memory, writable
    std::size_t capacity = 0;
    Element item = 0;
    bool ready = false;
    std::span<const std::byte> bytes;
    std::exception_ptr fault;
  };

  static void allocate(Slot& slot, std::size_t bytes);
  void close();
  void serve();

  ItemSource* source_;
  std::size_t capacity_;
  std::shared_ptr<const ItemSizes> sizes_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> where_;  // by item: its slot
  std::vector<std::uint32_t> free_;
  std::uint64_t most_used_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t bytes_read_ = 0;
  std::chrono::duration<double> waited_{};

  std::mutex mutex_;
  std::condition_variable wanted_;
  std::condition_variable arrived_;
  std::deque<std::uint32_t> queue_;  // slots to be filled
  bool closing_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace changeover
