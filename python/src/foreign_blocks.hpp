// Blocks that Python has, as a design.
#pragma once

#include "bind.hpp"
#include "changeover/io/input.hpp"

namespace changeover::python {

/// From a Design or Blocks, a two-dimensional buffer of whole numbers (a NumPy array), or any iterable of iterables of numbers or
/// strings. What is not said is inferred by the rules of files (io/input.hpp). @throws BadInput with the block at fault.
[[nodiscard]] Design design_from(const py::object& blocks, const ReadOptions& options);

}  // namespace changeover::python
