// An input whose first bytes can be looked at before they are read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/io/input.hpp"

namespace changeover {

class PeekedInput final : public Input {
 public:
  /// Peeks at so many bytes, or all there are. @throws MissingResource if reading fails.
  explicit PeekedInput(std::unique_ptr<Input> inner, std::size_t bytes = 4096)
      : PeekedInput(*inner, bytes) {
    owned_ = std::move(inner);
  }
  /// The same; the input must outlive this.
  PeekedInput(Input& inner, std::size_t bytes)
      : Input(inner.name()), inner_(&inner), peeked_(bytes) {
    while (size_ < peeked_.size()) {
      const std::size_t count = inner_->read(std::span(peeked_).subspan(size_));
      if (count == 0) {
        break;
      }
      size_ += count;
    }
  }

  [[nodiscard]] std::string_view beginning() const { return {peeked_.data(), size_}; }

  std::size_t read(std::span<char> buffer) override {
    if (position_ == size_) {
      return inner_->read(buffer);
    }
    const std::size_t count = std::min(buffer.size(), size_ - position_);
    std::copy_n(peeked_.data() + position_, count, buffer.data());
    position_ += count;
    return count;
  }

  bool rewind() override {
    if (!inner_->rewind()) {
      return false;
    }
    position_ = size_;  // what was peeked comes from the inner input again
    return true;
  }

 private:
  std::unique_ptr<Input> owned_;
  Input* inner_;
  std::vector<char> peeked_;
  std::size_t size_ = 0;
  std::size_t position_ = 0;
};

}  // namespace changeover
