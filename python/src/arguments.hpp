// What callers give as arguments: read item by item, so that Ctrl-C ends even what has no end.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace changeover::python {

/// The words of a value, as str() has them. @throws UnicodeEncodeError (a ValueError) for what is no text in UTF-8.
[[nodiscard]] std::string words_of(const pybind11::handle& value);

/// Words as a fault quotes them: a long text is cut.
[[nodiscard]] std::string quoted(const std::string& words);

/// The pairs of a dict as they are now: to read them runs code of the caller, which may change the dict.
/// @throws BadInput if it is none.
[[nodiscard]] pybind11::dict dict_of(const char* argument, const pybind11::object& value);

/// Calls `take` with each item, and looks for signals between them: an iterator written in C never does.
template <typename Take>
void for_each(const pybind11::handle& items, const Take& take) {
  for (const pybind11::handle item : pybind11::iter(items)) {
    if (PyErr_CheckSignals() != 0) {
      throw pybind11::error_already_set();
    }
    take(item);
  }
}

}  // namespace changeover::python
