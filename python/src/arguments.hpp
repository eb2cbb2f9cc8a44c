// What callers give as arguments: read item by item, so that Ctrl-C ends even what has no end.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "gil.hpp"

namespace changeover::python {

/// The words of a value, as str() has them. @throws UnicodeEncodeError (a ValueError) for what is no text in UTF-8.
[[nodiscard]] std::string words_of(const pybind11::handle& value);

/// Words as a fault quotes them: a long text is cut.
[[nodiscard]] std::string quoted(const std::string& words);

/// The pairs of a dict as they are now: to read them runs code of the caller, which may change the dict.
/// @throws BadInput if it is none.
[[nodiscard]] pybind11::dict dict_of(const char* argument, const pybind11::object& value);

/// Calls `take` with each item, and looks for signals between them: an iterator written in C never does. The code of the caller
/// that makes items may be where Python ends this thread.
template <typename Take>
void for_each(const pybind11::handle& items, const Take& take) {
  const pybind11::object iterator = made_by_python([&] { return PyObject_GetIter(items.ptr()); });
  for (;;) {
    PyObject* const next = unless_python_ends([&] { return PyIter_Next(iterator.ptr()); });
    const auto item = pybind11::reinterpret_steal<pybind11::object>(next);
    if (PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0) {
      throw pybind11::error_already_set();
    }
    if (!item) {
      return;
    }
    take(item);
  }
}

/// @throws type_error unless it can be gone through, and going through it gives what is meant: not for a string (its letters),
/// bytes (numbers), a table of columns (their names) or a mapping (its keys, without what they lead
/// to): "pairs has pairs of two parts, not 5".
void require_iterable(const char* argument, const char* holds, const pybind11::handle& value);
/// The same where the order says something: not for a set, which has none.
void require_ordered(const char* argument, const char* holds, const pybind11::handle& value);

/// Whether it is a table of columns, as pandas has it: going through it gives the names of its columns.
[[nodiscard]] bool is_data_frame(const pybind11::handle& value);

/// Whether the rows of a table, or the values of pandas' Series, are just numbered: an index of
/// whole numbers.
[[nodiscard]] bool has_numbered_rows(const pybind11::handle& table);

/// The rows of a table of columns as tuples; anything else as it is. @throws type_error for an
/// index that says something.
[[nodiscard]] pybind11::object rows_of(const char* argument, const pybind11::object& value);

/// A str, or what stands for one.
[[nodiscard]] bool is_text(const pybind11::handle& value);
[[nodiscard]] bool is_bytes(const pybind11::handle& value);
/// None, a NaN, or what pandas has for them.
[[nodiscard]] bool is_missing(const pybind11::handle& value);

/// Whether it is a dict, another mapping, or pandas' Series: keys that lead to values.
[[nodiscard]] bool leads_from_keys(const pybind11::handle& value);

}  // namespace changeover::python
