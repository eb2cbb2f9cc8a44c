// Memory as Python sees it: read-only, owned until the last view of it is gone.
#pragma once

#include <pybind11/pybind11.h>

#include "changeover/core/design.hpp"
#include "changeover/loadorder/all_pairs.hpp"

namespace changeover::python {

/// A memoryview of an item. What is made of it (slices, casts, NumPy's arrays) may outlive the call
/// of compute(): the bytes stay as they are.
[[nodiscard]] pybind11::object view_of(const ItemView& item);

/// The same of an item that may be written.
[[nodiscard]] pybind11::object writable_view_of(const HeldItem& item);

/// Ends a view of view_of(), so that one that is kept is refused by Python where it is used; what
/// was made of it stays.
void end_view(const pybind11::object& view);

/// Rows of k numbers as an object of a type that Python derived from Memory, the base type of all
/// that shows memory.
[[nodiscard]] pybind11::object blocks_of(const pybind11::object& type,
                                         std::shared_ptr<const void> owner, const Element* first,
                                         std::size_t count, std::size_t k);

}  // namespace changeover::python
