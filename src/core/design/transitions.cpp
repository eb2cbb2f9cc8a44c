#include "changeover/core/design.hpp"

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

Block select(std::span<const Element> block, std::span<const Element> other, bool common) {
  Block sorted(other.begin(), other.end());
  std::ranges::sort(sorted);
  Block result;
  for (const Element x : block) {
    if (std::ranges::binary_search(sorted, x) == common) {
      result.push_back(x);
    }
  }
  return result;
}

}  // namespace

Block difference(std::span<const Element> block, std::span<const Element> other) {
  return select(block, other, false);
}

Block intersection(std::span<const Element> block, std::span<const Element> other) {
  return select(block, other, true);
}

bool holds_all(std::span<const Element> block, std::span<const Element> elements) {
  return intersection(block, elements).size() == elements.size();
}

Transitions::Transitions(BlockSource& source) : source_(&source) {
  const auto k = static_cast<std::size_t>(source.parameters().k);
  block_.resize(k);
  ahead_.resize(k);
  if (source.parameters().kind == Kind::circular) {
    std::uint64_t count = 0;
    Block last(k);
    while (source.next(block_)) {
      std::swap(last, block_);
      ++count;
    }
    if (!source.rewind()) {
      throw BadInput(
          "the marks of a circular design need its blocks twice: read it into memory first");
    }
    if (count > 1) {  // a single block has no neighbour, not even itself
      previous_ = std::move(last);
      has_previous_ = true;
    }
  }
  has_ahead_ = source_->next(ahead_);
  if (has_ahead_ && has_previous_) {
    first_ = ahead_;
  }
}

bool Transitions::next() {
  if (!has_ahead_) {
    return false;
  }
  if (started_) {
    previous_ = block_;
    has_previous_ = true;
    ++index_;
  }
  started_ = true;
  std::swap(block_, ahead_);
  has_ahead_ = source_->next(ahead_);
  introduced_ = has_previous_ ? difference(block_, previous_) : block_;
  if (has_ahead_) {
    leaving_ = difference(block_, ahead_);
  } else {
    leaving_ = first_ ? difference(block_, *first_) : block_;
  }
  return true;
}

std::vector<UnchangedSubset> unchanged_subsets(const Design& design) {
  std::vector<UnchangedSubset> subsets;
  const std::size_t b = design.block_count();
  const bool wraps = design.parameters().kind == Kind::circular && b > 1;
  for (std::size_t i = 0; i + (wraps ? 0 : 1) < b; ++i) {
    Block common = intersection(design.block(i), design.block((i + 1) % b));
    std::ranges::sort(common);
    subsets.push_back({i + 1, std::move(common)});
  }
  return subsets;
}

}  // namespace changeover
