// Blocks as text, fast: the words of the elements are made once and then copied.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/io/output.hpp"
#include "changeover/io/tables.hpp"

namespace changeover {

/// Gathers text for a sink. Elements are written as "word separator word … word last".
class ElementText {
 public:
  /// `labels` is empty, for decimal numbers, or has v members; they must outlive this.
  ElementText(Sink& sink, std::uint64_t v, const std::vector<std::string>& labels, char separator);

  void put(std::string_view text);
  void put(char c) {
    make_room(1);
    *p_++ = c;
  }
  void put_number(std::uint64_t number) {
    make_room(20);
    p_ = std::to_chars(p_, p_ + 20, number).ptr;
  }

  /// The elements of a block with `last` after them.
  void elements(std::span<const Element> block, char last) { blocks(block, block.size(), last); }

  /// Blocks of k elements, one after another, each with `last` after it.
  void blocks(std::span<const Element> elements, std::size_t k, char last) {
    if (slots_.empty()) {
      blocks_slowly(elements, k, last);
      return;
    }
    make_room(elements.size() * sizeof(std::uint64_t));
    const std::uint64_t* const slots = slots_.data();
    char* p = p_;
    const Element* x = elements.data();
    for (const Element* const end = x + elements.size(); x != end;) {
#pragma GCC unroll 4  // blocks are short: 5 % for k = 4
      for (const Element* const block_end = x + k; x != block_end; ++x) {
        const std::uint64_t slot = slots[*x];
        std::memcpy(p, &slot, sizeof slot);
        p += length(slot);
      }
      p[-1] = last;
    }
    p_ = p;
  }

  /// Passes all text to the sink.
  void flush();

 private:
  // The last byte of a slot in memory is the length of its text; to find it by a shift, slots are
  // little-endian numbers, and on other machines there are none.
  static constexpr std::size_t longest = 7;
  static std::size_t length(std::uint64_t slot) { return static_cast<std::size_t>(slot >> 56); }

  void make_room(std::size_t bytes) {
    if (static_cast<std::size_t>(end_ - p_) < bytes) [[unlikely]] {
      make_room_slowly(bytes);
    }
  }
  void make_room_slowly(std::size_t bytes);
  void blocks_slowly(std::span<const Element> elements, std::size_t k, char last);

  Sink* sink_;
  const std::vector<std::string>* labels_;
  char separator_;
  std::vector<std::uint64_t> slots_;  // by element: its word and the separator; empty if too long
  std::vector<char> buffer_;
  char* p_;
  char* end_;
};

/// All blocks of `source`, a line each. Returns how many there are. The text is passed to the sink.
std::uint64_t write_block_lines(BlockSource& source, ElementText& text);

// The index of a block in its name: "3", or "i,j" for a developed design.

/// `index` from 0 in the order of the blocks.
[[nodiscard]] inline std::string block_name(const BlockNames& names, std::uint64_t index) {
  if (names.base_blocks && *names.base_blocks > 0) {
    return std::to_string(index % *names.base_blocks) + "," +
           std::to_string(index / *names.base_blocks);
  }
  return std::to_string(names.first + index);
}

}  // namespace changeover
