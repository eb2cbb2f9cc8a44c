// The parts of the private module `changeover._core`, a file each, and what they share. Arguments
// come as the functions of the package have checked them, so nothing here says what they mean: that
// stands there.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/draw/picture.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::python {

namespace py = pybind11;

void register_errors();
void bind_memory(py::module_& module);
void bind_designs(py::module_& module);
void bind_known(py::module_& module);
void bind_notebook(py::module_& module);
void bind_search(py::module_& module);
void bind_catalog(py::module_& module);
void bind_plan(py::module_& module);
void bind_loads(py::module_& module);

/// For the time of one call: an iterator is not for two threads at once. @throws value_error as
/// generators do.
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

/// @throws BadInput for another word than "linear" and "circular".
[[nodiscard]] Kind kind_of(const std::string& word);

/// Both kinds, circular first, if none is named.
[[nodiscard]] std::vector<Kind> kinds_of(const std::optional<std::string>& word);

/// @throws as check(); BadInput for a strength that its type does not hold.
[[nodiscard]] Parameters parameters(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                                    Kind kind, std::uint64_t strength = 2);

/// A dict with v, k, change, kind, strength.
[[nodiscard]] py::dict facts_of(const Parameters& parameters);

/// As SVG and as TikZ, or why it cannot be TikZ, and its title.
using DrawnPicture = std::tuple<std::string, std::string, std::string, std::string>;

[[nodiscard]] DrawnPicture written(const Picture& picture, Theme theme);

[[nodiscard]] py::tuple tuple_of(std::span<const Element> elements);

}  // namespace changeover::python
