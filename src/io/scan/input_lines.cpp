#include "io/scan/input_lines.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "changeover/run/control.hpp"
#include "io/scan/place.hpp"

namespace changeover {

InputLines::Next InputLines::next() {
  std::size_t searched = begin_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      return found(end);
    }
    if (ended_) {
      return begin_ < buffer_.size() ? found(buffer_.size()) : Next::end;
    }
    stop_if_asked();
    buffer_.erase(0, std::exchange(begin_, 0));
    searched = buffer_.size();
    if (searched > longest_) {
      ++number_;
      line_ = buffer_;
      return Next::too_long;
    }
    constexpr std::size_t piece = std::size_t{1} << 18;
    buffer_.resize(searched + piece);
    const std::size_t count = input_->read(std::span(buffer_).subspan(searched));
    buffer_.resize(searched + count);
    bytes_ += count;
    ended_ = count == 0;
  }
}

InputLines::Next InputLines::found(std::size_t stop) {
  line_ = std::string_view(buffer_).substr(begin_, stop - begin_);
  begin_ = std::min(stop + 1, buffer_.size());
  if (++number_ == 1) {
    line_ = without_byte_order_mark(line_);
  }
  if (line_.ends_with('\r')) {
    line_.remove_suffix(1);
  }
  return line_.size() > longest_ ? Next::too_long : Next::line;
}

}  // namespace changeover
