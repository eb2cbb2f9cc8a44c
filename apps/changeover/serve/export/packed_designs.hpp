// Many designs in one small file, step by step instead of block by block.
//
//     PackedDesigns shelf;
//     shelf.add(label, design, verdict);       // from any thread
//     workshop.write("data/design/2.circular.5.gz", gzip(shelf.take(), best_gzip));
//
// The first line is JSON: an array of what a design's document says but for its blocks, with "at",
// where its bytes begin behind that line, and "way". Numbers are little-endian, of one byte if v is
// at most 256, else of two.
//   "steps"  Elements of the first block; then for j = 0, …, m−1 a column of places, one a step,
//            and a column of elements. In a step the element at each of the places, which grow with
//            j, gives way to another, which grow too; a column of elements has differences from the
//            step before, modulo v. The elements of a block are what is in the k places, in
//            increasing order.
//   "blocks" Block after block, each element less the one at the same place of the block before,
//            modulo v: for lists whose blocks are not in increasing order.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/io/formats.hpp"

namespace changeover::serve {

class PackedDesigns {
 public:
  /// Thread-safe. Labels are those of the catalog; that of its cell for a design that it does not
  /// keep.
  void add(const std::string& label, const Design& design, const DesignVerdict& verdict);

  /// The file, designs by their labels; nothing is left.
  [[nodiscard]] std::string take();

 private:
  struct Packed {
    std::string label;
    std::string head;  // of the document, without its brace at the end
    std::string way;
    std::string bytes;
  };
  std::mutex mutex_;
  std::vector<Packed> designs_;
};

}  // namespace changeover::serve
