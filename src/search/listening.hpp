// Reading and verifying blocks while listening to the scope of this thread (run/scope.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/run/scope.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// Another stream, which stops if asked. Keeps a reference.
class ListeningSource final : public BlockSource {
 public:
  explicit ListeningSource(BlockSource& source) : source_(&source) {}

  [[nodiscard]] const Parameters& parameters() const override { return source_->parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }
  std::span<const Element> read(std::span<Element> room) override {
    // A long block is asked about every time, short ones now and then.
    const auto k = static_cast<std::size_t>(parameters().k);
    const std::size_t blocks = std::max<std::size_t>(1, elements_between_questions / k);
    room = room.first(std::min(room.size(), blocks * k));
    elements_ += room.size();
    if (elements_ >= blocks * k) {
      elements_ = 0;
      stop_if_asked();
    }
    return source_->read(room);
  }
  bool rewind() override { return source_->rewind(); }

 private:
  static constexpr std::size_t elements_between_questions = 1024;

  BlockSource* source_;
  std::size_t elements_ = 0;
};

/// verify(). @throws Stopped if asked.
[[nodiscard]] inline Verdict verify_listening(const Design& design) {
  DesignSource blocks(design);
  ListeningSource listening(blocks);
  return verify(listening);
}

}  // namespace changeover
