#include "changeover/core/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover {

std::optional<std::string> label_defect(std::string_view label) {
  if (label.empty()) {
    return "an element has an empty name; name it";
  }
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7f) {
      return "a name with a blank or control character; use '_' or '-' instead";
    }
    if (c == ',' || c == '"' || c == '#') {
      return fmt::format("a name with {}, which not every format can carry; use another character",
                         c == ','   ? "a comma"
                         : c == '"' ? "a double quote"
                                    : "'#'");
    }
  }
  for (std::string_view rest = label; !rest.empty();) {
    const CodePoint point = first_code_point(rest);
    if (!point.valid) {
      return "a name with bytes that are not UTF-8; save the file as UTF-8";
    }
    if (!is_printable(point)) {
      return fmt::format("a name with the control character U+{:04X}; leave it out",
                         static_cast<std::uint32_t>(point.value));
    }
    rest.remove_prefix(point.bytes);
  }
  return std::nullopt;
}

Design::Design(const Parameters& parameters) : parameters_(parameters) {
  check(parameters);
  if (parameters.v > max_elements_in_memory) {
    throw ImpossibleParameters(fmt::format("v = {} exceeds the {} elements of a design in memory",
                                           parameters.v, max_elements_in_memory));
  }
}

Design::Design(const Parameters& parameters, std::span<const Block> blocks) : Design(parameters) {
  reserve(blocks.size());
  for (const Block& block : blocks) {
    append(block);
  }
}

void Design::append(std::span<const Element> block) {
  const std::size_t number = block_count() + 1;
  if (block.size() != parameters_.k) {
    throw BadInput(fmt::format("block {} has {}, not k = {}", number,
                               count_of(block.size(), "element"), parameters_.k));
  }
  if (last_seen_.empty()) {
    last_seen_.resize(static_cast<std::size_t>(parameters_.v), 0);
  }
  // A refused block's number is used again by the next one, so its marks must go.
  for (const Element element : block) {
    if (element >= parameters_.v) {
      last_seen_.clear();
      throw BadInput(
          fmt::format("block {}: element {} is not below v = {}", number, element, parameters_.v));
    }
    if (last_seen_[element] == number) {
      last_seen_.clear();
      throw BadInput(fmt::format("block {} repeats the element {}", number, label(element)));
    }
    last_seen_[element] = number;
  }
  elements_.insert(elements_.end(), block.begin(), block.end());
}

std::vector<Block> Design::blocks() const {
  std::vector<Block> list;
  list.reserve(block_count());
  for (std::size_t i = 0; i < block_count(); ++i) {
    list.emplace_back(block(i).begin(), block(i).end());
  }
  return list;
}

std::string Design::label(Element element) const {
  return labels_.empty() ? std::to_string(element) : labels_[element];
}

void Design::set_labels(std::vector<std::string> labels) {
  bool plain = true;
  for (std::size_t i = 0; i < labels.size() && plain; ++i) {
    plain = labels[i] == std::to_string(i);
  }
  if (labels.empty() || (plain && labels.size() == parameters_.v)) {
    labels_.clear();
    return;
  }
  if (labels.size() != parameters_.v) {
    throw BadInput(fmt::format("{} for v = {} elements: give one each",
                               count_of(labels.size(), "label"), parameters_.v));
  }
  std::unordered_set<std::string_view> seen;
  for (const std::string& label : labels) {
    if (const auto defect = label_defect(label)) {
      throw BadInput(fmt::format("the label '{}': {}", label, *defect));
    }
    if (!seen.insert(label).second) {
      throw BadInput(fmt::format("the label '{}' names two elements", label));
    }
  }
  labels_ = std::move(labels);
}

std::span<const Element> DesignSource::read(std::span<Element> room) {
  const std::span<const Element> rest = design_->elements().subspan(position_);
  const auto k = static_cast<std::size_t>(design_->k());
  const std::span<const Element> blocks = rest.first(std::min(rest.size(), room.size() / k * k));
  position_ += blocks.size();
  return blocks;
}

Design read_all(BlockSource& source) {
  Design design(source.parameters());
  if (const auto count = source.block_count()) {
    // A count from outside is only a claim: do not reserve memory that its blocks may not fill.
    design.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(*count, 1U << 20)));
  }
  for_each_block(source, [&](std::span<const Element> block) { design.append(block); });
  return design;
}

}  // namespace changeover
