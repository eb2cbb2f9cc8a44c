// The parts of the module `changeover._core`, a file each, and what they share.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/recipe.hpp"
#include "changeover/verify/verified_design.hpp"

namespace changeover::python {

namespace py = pybind11;

/// Has every method of the module's types refuse an object that was made by __new__ alone, in which there is nothing.
/// After all have been bound.
void refuse_empty_objects(const py::module_& module);

void bind_errors(py::module_& module);
void bind_blocks(py::module_& module);
void bind_designs(py::module_& module);
void bind_bounds(py::module_& module);
void bind_search(py::module_& module);
void bind_catalog(py::module_& module);
void bind_benches(py::module_& module);
void bind_plan(py::module_& module);
void bind_loads(py::module_& module);

/// Blocks that somebody keeps alive: rows of k numbers, shown to Python as a read-only buffer.
struct Blocks {
  std::shared_ptr<const void> owner;
  const Element* data = nullptr;
  std::size_t count = 0;
  std::size_t k = 0;
};

[[nodiscard]] Blocks blocks_of(const std::shared_ptr<const Design>& design);

/// For the time of one call: an iterator is not for two threads at once. @throws value_error as generators do.
class OneAtATime {
 public:
  explicit OneAtATime(bool& busy) : busy_(busy) {
    if (busy) {
      throw py::value_error("iterator already executing in another thread");
    }
    busy = true;
  }
  ~OneAtATime() { busy_ = false; }
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

 private:
  bool& busy_;  // looked at with the GIL held
};

/// A design that Python holds: verified or not, always with a verdict.
struct HeldDesign {
  std::shared_ptr<const Design> design;
  Verdict verdict;
};

[[nodiscard]] HeldDesign held(VerifiedDesign design);

/// @throws value_error for another word than "linear" and "circular".
[[nodiscard]] Kind kind_of(const std::string& word);

/// Both kinds, circular first, if none is named.
[[nodiscard]] std::vector<Kind> kinds_of(const std::optional<std::string>& word);

/// A JSON text as Python's objects.
[[nodiscard]] py::object from_json(const std::string& json);

[[nodiscard]] py::dict as_dict(const Recipe& recipe);

}  // namespace changeover::python
