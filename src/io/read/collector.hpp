// Makes a design of blocks in memory, for formats that are not streamed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "io/read/declared.hpp"
#include "io/scan/place.hpp"
#include "io/scan/token_table.hpp"

namespace changeover {

/// Collects the words of blocks; their meaning is decided at the end, when all of them are known.
class Collector {
 public:
  /// Adds a word to the block; returns what is wrong with it, if anything. A quoted label has a '"'
  /// in front in formats where quotes make a difference.
  [[nodiscard]] std::optional<std::string> add(std::string_view word);

  /// Ends the block; returns what is wrong with its size, if anything.
  [[nodiscard]] std::optional<std::string> end_block();

  /// The number of words of the block that is being collected.
  [[nodiscard]] std::size_t block_size() const { return elements_.size() - block_start_; }

  /// What the rest of the file declares.
  struct Context {
    std::string name;
    Declared declared;
    std::optional<std::vector<std::string>> labels;  ///< valid and distinct
    Place labels_place;
    Place place;         ///< where the parameters are, or the beginning
    bool named = false;  ///< words are labels even if they are numbers
    std::function<Place(std::uint64_t word)> place_of_word;  ///< the i-th word of all, from 0
  };

  /// The design. @throws BadInput as io/input.hpp says.
  [[nodiscard]] Design finish(const Context& context);

 private:
  void settle(const Context& context);

  TokenTable table_;
  std::vector<Element> elements_;  // first by word, after settle() by element
  std::size_t block_start_ = 0;
  std::uint64_t blocks_ = 0;
  std::size_t k_ = 0;
  std::uint64_t v_ = 0;
  std::vector<std::string> labels_;
};

}  // namespace changeover
