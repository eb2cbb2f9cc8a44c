#include "isomorphism/standard_names.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace changeover {

StandardNames::StandardNames(const Design& design)
    : design_(&design),
      name_of_(design.v()),
      element_of_(design.v()),
      form_(design.elements().size()),
      class_of_(design.v()) {}

void StandardNames::read(const Reading& reading) {
  const std::size_t v = name_of_.size();
  const std::size_t b = design_->block_count();
  const std::size_t k = design_->k();
  reading_ = reading;
  std::iota(name_of_.begin(), name_of_.end(), Element{0});
  std::iota(element_of_.begin(), element_of_.end(), Element{0});
  std::fill(class_of_.begin(), class_of_.end(), 0);
  classes_.assign(1, Class{.begin = 0, .size = v, .met = 0});
  for (std::size_t place = 0; place < b && classes_.size() < v; ++place) {
    split(design_->block(reading.block(place, b)));
  }
  auto out = form_.begin();
  for (std::size_t place = 0; place < b; ++place) {
    const auto begin = out;
    for (const Element x : design_->block(reading.block(place, b))) {
      *out++ = name_of_[x];
    }
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(k));
  }
}

void StandardNames::split(std::span<const Element> block) {
  touched_.clear();
  for (const Element x : block) {
    Class& own = classes_[class_of_[x]];
    if (own.met == 0) {
      touched_.push_back(class_of_[x]);
    }
    const auto front = static_cast<Element>(own.begin + own.met++);
    const Element other = element_of_[front];
    std::swap(element_of_[front], element_of_[name_of_[x]]);
    std::swap(name_of_[x], name_of_[other]);
  }
  for (const std::size_t index : touched_) {
    Class& own = classes_[index];
    const std::size_t met = std::exchange(own.met, 0);
    if (met == own.size) {
      continue;
    }
    const Class in{.begin = own.begin, .size = met, .met = 0};
    own.begin += met;
    own.size -= met;
    for (std::size_t name = in.begin; name < in.begin + met; ++name) {
      class_of_[element_of_[name]] = classes_.size();
    }
    classes_.push_back(in);
  }
}

std::vector<std::vector<Element>> StandardNames::twins() const {
  std::vector<std::vector<Element>> twins;
  for (const Class& each : classes_) {
    if (each.size > 1) {
      const auto begin = element_of_.begin() + static_cast<std::ptrdiff_t>(each.begin);
      twins.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(each.size));
      std::sort(twins.back().begin(), twins.back().end());
    }
  }
  std::sort(twins.begin(), twins.end());
  return twins;
}

Isomorphism StandardNames::map() const {
  const std::size_t b = design_->block_count();
  const std::size_t shift =
      reading_.backwards || b == 0 ? reading_.start : (b - reading_.start) % b;
  return {.elements = name_of_, .shift = shift, .reversed = reading_.backwards};
}

}  // namespace changeover
