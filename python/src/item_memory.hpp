// The memory of an item as Python sees it: read-only bytes that are owned until the last view of them is gone.
#pragma once

#include <pybind11/pybind11.h>

#include "changeover/loadorder/all_pairs.hpp"

namespace changeover::python {

/// A memoryview of an item. What is made of it (slices, casts, NumPy's arrays) may outlive the call of compute(): the bytes
/// stay as they are.
[[nodiscard]] pybind11::object view_of(const ItemView& item);

/// Ends a view of view_of(), so that one that is kept is refused by Python where it is used; what was made of it stays.
void end_view(const pybind11::object& view);

}  // namespace changeover::python
