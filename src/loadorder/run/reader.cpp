#include "loadorder/run/reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "run/threads.hpp"

namespace changeover {

namespace {

std::size_t aligned(std::uint64_t bytes) {
  return static_cast<std::size_t>(ceil_div(std::max<std::uint64_t>(1, bytes), buffer_alignment) *
                                  buffer_alignment);
}

}  // namespace

Reader::Reader(ItemSource& source, std::uint64_t items, std::uint64_t room, unsigned threads,
               std::shared_ptr<const ItemSizes> sizes)
    : source_(&source),
      capacity_(aligned(source.buffer_bytes())),
      sizes_(std::move(sizes)),
      slots_(static_cast<std::size_t>(room)),
      where_(static_cast<std::size_t>(items), 0) {
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    if (sizes_ == nullptr) {
      allocate(slots_[i], capacity_);
    }
    free_.push_back(i);
  }
  start_threads(
      threads_, std::max(1U, threads), [this](unsigned) { serve(); }, [this] { close(); });
}

void Reader::allocate(Slot& slot, std::size_t bytes) {
  slot.capacity = aligned(bytes);
  slot.place = static_cast<std::byte*>(std::aligned_alloc(buffer_alignment, slot.capacity));
  if (slot.place == nullptr) {
    throw std::bad_alloc();
  }
  slot.buffer.reset(slot.place, [](std::byte* memory) { std::free(memory); });
}

void Reader::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wanted_.notify_all();
}

Reader::~Reader() {
  close();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void Reader::serve() {
  while (true) {
    std::uint32_t index = 0;
    {
      std::unique_lock lock(mutex_);
      wanted_.wait(lock, [this] { return closing_ || !queue_.empty(); });
      if (closing_) {
        return;
      }
      index = queue_.front();
      queue_.pop_front();
    }
    // No other thread uses a slot while it is being loaded.
    Slot& slot = slots_[index];
    try {
      slot.bytes = source_->read(slot.item, {slot.place, slot.capacity});
    } catch (...) {
      slot.fault = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      slot.ready = true;
    }
    arrived_.notify_all();
  }
}

void Reader::request(Element item) {
  if (free_.empty()) {
    throw InternalError("an item is to be loaded when every buffer is taken");
  }
  const std::uint32_t index = free_.back();
  Slot& slot = slots_[index];
  if (sizes_ != nullptr) {
    allocate(slot, static_cast<std::size_t>(sizes_->bytes[item]));
  } else if (slot.buffer.use_count() > 1) {
    allocate(slot,
             capacity_);  // the bytes of the item before are kept elsewhere, unchanged
  } else {
    // They were read before they were released: giving up one share takes in what others did before
    // they gave up theirs.
    std::shared_ptr<const std::byte>(slot.buffer).reset();
  }
  free_.pop_back();
  slot.item = item;
  slot.bytes = {};
  slot.fault = nullptr;
  where_[item] = index;
  ++requests_;
  most_used_ = std::max<std::uint64_t>(most_used_, slots_.size() - free_.size());
  {
    const std::lock_guard lock(mutex_);
    slot.ready = false;
    queue_.push_back(index);
  }
  wanted_.notify_one();
}

ItemView Reader::wait(Element item) {
  const auto start = std::chrono::steady_clock::now();
  Slot& slot = slots_[where_[item]];
  {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&slot] { return slot.ready; });
  }
  waited_ += std::chrono::steady_clock::now() - start;
  if (slot.fault) {
    std::rethrow_exception(slot.fault);
  }
  bytes_read_ += slot.bytes.size();
  return view(item);
}

void Reader::release(Element item) {
  free_.push_back(where_[item]);
  if (sizes_ != nullptr) {
    slots_[where_[item]].buffer.reset();
  }
}

}  // namespace changeover
