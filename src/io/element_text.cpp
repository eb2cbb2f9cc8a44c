#include "io/element_text.hpp"

#include <algorithm>
#include <bit>

#include "changeover/core/parameters.hpp"

namespace changeover::io_detail {

ElementText::ElementText(Sink& sink, std::uint64_t v, std::uint64_t k,
                         const std::vector<std::string>& labels, char separator)
    : sink_(&sink), labels_(&labels), separator_(separator) {
  constexpr std::size_t usual = std::size_t{1} << 20;
  buffer_.resize(usual + static_cast<std::size_t>(std::min<std::uint64_t>(k, 1U << 20)) * 8);
  p_ = buffer_.data();
  end_ = p_ + buffer_.size();
  const bool short_words = std::all_of(labels.begin(), labels.end(), [](const std::string& label) {
    return label.size() < longest;
  });
  if (std::endian::native != std::endian::little || !short_words || v > max_elements_in_memory) {
    return;
  }
  slots_.reserve(static_cast<std::size_t>(v));
  for (std::uint64_t x = 0; x < v; ++x) {
    const std::string word =
        (labels.empty() ? std::to_string(x) : labels[static_cast<std::size_t>(x)]) + separator;
    std::uint64_t slot = 0;
    std::memcpy(&slot, word.data(), word.size());
    slots_.push_back(slot | static_cast<std::uint64_t>(word.size()) << 56);
  }
}

void ElementText::put(std::string_view text) {
  make_room(text.size());
  std::memcpy(p_, text.data(), text.size());
  p_ += text.size();
}

void ElementText::elements_slowly(std::span<const Element> block, char last) {
  for (const Element x : block) {
    if (labels_->empty()) {
      put_number(x);
    } else {
      put((*labels_)[x]);
    }
    put(separator_);
  }
  p_[-1] = last;
}

void ElementText::flush() {
  sink_->write({buffer_.data(), static_cast<std::size_t>(p_ - buffer_.data())});
  p_ = buffer_.data();
}

// Hands over whole pages only: the system stores them faster.
void ElementText::flush_for(std::size_t bytes) {
  constexpr std::size_t page = std::size_t{1} << 16;
  const auto size = static_cast<std::size_t>(p_ - buffer_.data());
  const std::size_t given = size / page * page;
  if (given > 0) {
    sink_->write({buffer_.data(), given});
    std::memmove(buffer_.data(), buffer_.data() + given, size - given);
  }
  if (buffer_.size() < size - given + bytes) {
    buffer_.resize(size - given + bytes);
    end_ = buffer_.data() + buffer_.size();
  }
  p_ = buffer_.data() + (size - given);
}

}  // namespace changeover::io_detail
