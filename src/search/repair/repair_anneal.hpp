// Shared by repairing and extending a list.
#pragma once

#include <cstddef>
#include <new>
#include <string>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"

namespace changeover {

[[nodiscard]] inline Block block_of(const Design& design, std::size_t i) {
  const auto elements = design.block(i);
  return Block(elements.begin(), elements.end());
}

/// Anneals by `work()`. If memory is too small, returns one line that says so; otherwise an empty
/// text.
template <typename Work>
std::string annealing_fault(Work&& work) {
  try {
    work();
  } catch (const MissingResource& fault) {
    return fault.what();
  } catch (const std::bad_alloc&) {
    return "not enough memory to anneal the list";
  }
  return "";
}

}  // namespace changeover
