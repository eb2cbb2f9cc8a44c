#include "construct/expansion/inserter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {

InsertingSource::InsertingSource(std::unique_ptr<BlockSource>&& source, const Parameters& larger,
                                 Amount amount)
    : source_(std::move(source)),
      parameters_(larger),
      amount_(amount),
      circular_(larger.kind == Kind::circular) {}

std::optional<std::uint64_t> InsertingSource::block_count() const {
  const std::optional<std::uint64_t> b = source_->block_count();
  return b ? std::optional(checked_add(*b, amount_.blocks)) : std::nullopt;
}

bool InsertingSource::is_chosen(std::uint64_t at) const {
  return begun_ < amount_.insertions && position(begun_) == at;
}

// The next block of the source, which may have been read already.
bool InsertingSource::read_one(std::span<Element> block) {
  if (!read_ahead_) {
    return source_->next(block);
  }
  if (read_ahead_->empty()) {
    return false;
  }
  std::ranges::copy(*read_ahead_, block.begin());
  read_ahead_.reset();
  return true;
}

std::span<const Element> InsertingSource::read(std::span<Element> room) {
  const auto k = static_cast<std::size_t>(parameters_.k);
  const bool inserting = given_ < insertion_.others.size();
  if (read_ > 0 && !read_ahead_ && !inserting) {
    // Blocks that are not beside a position are handed on as they come.
    std::uint64_t passing = room.size() / k;
    if (begun_ < amount_.insertions) {
      const std::uint64_t at = position(begun_);
      passing = std::min(passing, at > read_ ? at - read_ - 1 : 0);
    }
    if (passing > 0) {
      const auto blocks = source_->read(room.first(static_cast<std::size_t>(passing) * k));
      if (!blocks.empty()) {
        read_ += blocks.size() / k;
        return blocks;
      }
    }
  }
  std::size_t filled = 0;
  do {
    if (!make(room.subspan(filled, k))) {
      break;
    }
    filled += k;
  } while (given_ < insertion_.others.size() && room.size() - filled >= k);
  return room.first(filled);
}

bool InsertingSource::make(std::span<Element> block) {
  while (given_ == insertion_.others.size() && is_chosen(read_)) {
    if (!read_ahead_) {
      read_ahead_.emplace(block.size());
      if (!source_->next(*read_ahead_)) {
        read_ahead_->clear();
      }
    }
    const bool closes = circular_ && read_ahead_->empty();
    insertion_ = insertion(begun_, {before_, closes ? first_ : *read_ahead_});
    begun_ += insertion_.unfinished ? 0U : 1U;
    given_ = 0;
  }
  if (given_ < insertion_.others.size()) {
    const auto rest = std::ranges::copy(insertion_.kept, block.begin()).out;
    const auto count = block.end() - rest;
    std::copy_n(insertion_.others.begin() + static_cast<std::ptrdiff_t>(given_), count, rest);
    given_ += static_cast<std::size_t>(count);
    return true;
  }
  if (!read_one(block)) {
    if (begun_ < amount_.insertions) {
      throw BadInput(
          fmt::format("position {} is past the last block, {}", position(begun_), read_));
    }
    return false;
  }
  if (++read_ == 1 && circular_) {
    first_.assign(block.begin(), block.end());
  }
  if (is_chosen(read_)) {
    before_.assign(block.begin(), block.end());
  }
  return true;
}

bool InsertingSource::rewind() {
  if (!source_->rewind()) {
    return false;
  }
  read_ = begun_ = 0;
  insertion_ = {};
  given_ = 0;
  before_.clear();
  read_ahead_.reset();
  return true;
}

}  // namespace changeover
