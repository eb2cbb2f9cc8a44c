#include "io/write/element_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "changeover/core/parameters.hpp"
#include "changeover/io/formats.hpp"

namespace changeover {

ElementText::ElementText(Sink& sink, std::uint64_t v, const std::vector<std::string>& labels,
                         char separator)
    : sink_(&sink), labels_(&labels), separator_(separator), buffer_(4096) {
  p_ = buffer_.data();
  end_ = p_ + buffer_.size();
  const bool short_words =
      std::ranges::all_of(labels, [](const std::string& label) { return label.size() < longest; });
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

void ElementText::blocks_slowly(std::span<const Element> elements, std::size_t k, char last) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (labels_->empty()) {
      put_number(elements[i]);
    } else {
      put((*labels_)[elements[i]]);
    }
    put((i + 1) % k == 0 ? last : separator_);
  }
}

void ElementText::flush() {
  sink_->write({buffer_.data(), static_cast<std::size_t>(p_ - buffer_.data())});
  p_ = buffer_.data();
}

// The buffer grows to a size that the system writes fast and then gives up its whole pages, which
// are stored faster, too.
void ElementText::make_room_slowly(std::size_t bytes) {
  constexpr std::size_t page = std::size_t{1} << 16;
  constexpr std::size_t usual = std::size_t{1} << 20;
  auto size = static_cast<std::size_t>(p_ - buffer_.data());
  if (buffer_.size() >= usual) {
    const std::size_t given = size / page * page;
    sink_->write({buffer_.data(), given});
    size -= given;
    std::memmove(buffer_.data(), buffer_.data() + given, size);
  }
  if (buffer_.size() < size + bytes) {
    buffer_.resize(std::max(size + bytes, std::min(8 * buffer_.size(), usual)));
  }
  p_ = buffer_.data() + size;
  end_ = buffer_.data() + buffer_.size();
}

std::string header_words(const Parameters& p) {
  return fmt::format("changeover design v={} k={} change={} kind={}{}", p.v, p.k, p.change,
                     to_string(p.kind),
                     p.strength == 2 ? std::string() : fmt::format(" strength={}", p.strength));
}

namespace {

void put_header(ElementText& text, const Parameters& p, const std::vector<std::string>& labels,
                const std::optional<Recipe>& recipe) {
  text.put("# " + header_words(p) + "\n");
  if (!labels.empty()) {
    text.put("# labels:");
    for (const std::string& label : labels) {
      text.put(' ');
      text.put(label);
    }
    text.put('\n');
  }
  if (recipe) {
    text.put("# recipe: " + recipe_to_json(*recipe) + "\n");
  }
}

}  // namespace

std::uint64_t write_block_lines(BlockSource& source, ElementText& text) {
  const auto k = static_cast<std::size_t>(source.parameters().k);
  std::uint64_t elements = 0;
  for_each_batch(source, [&](std::span<const Element> blocks) {
    text.blocks(blocks, k, '\n');
    elements += blocks.size();
  });
  text.flush();
  return elements / k;
}

std::uint64_t write_text(BlockSource& source, Sink& sink, const TextHeader& header) {
  const Parameters& p = source.parameters();
  ElementText text(sink, p.v, header.labels, ' ');
  put_header(text, p, header.labels, header.recipe);
  return write_block_lines(source, text);
}

void write_text(const Design& design, Sink& sink) {
  DesignSource source(design);
  write_text(source, sink, {design.labels(), design.recipe});
}

}  // namespace changeover
