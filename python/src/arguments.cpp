#include "arguments.hpp"

#include "changeover/core/error.hpp"

namespace changeover::python {

namespace py = pybind11;

std::string words_of(const py::handle& value) {
  const py::object words = made_by_python([&] { return PyObject_Str(value.ptr()); });
  Py_ssize_t bytes = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(words.ptr(), &bytes);
  if (text == nullptr) {
    throw py::error_already_set();
  }
  return {text, static_cast<std::size_t>(bytes)};
}

std::string quoted(const std::string& words) {
  constexpr std::size_t most_bytes = 60;
  std::size_t end = std::min(words.size(), most_bytes);
  while (end < words.size() && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80U) {
    --end;  // not within a character
  }
  return "'" + words.substr(0, end) + (end < words.size() ? "…'" : "'");
}

void require_iterable(const char* argument, const char* holds, const py::handle& value) {
  if (!py::isinstance<py::iterable>(value)) {
    throw py::type_error(std::string(argument) + " has " + holds + ", not " +
                         quoted(words_of(py::repr(value))));
  }
}

py::dict dict_of(const char* argument, const py::object& value) {
  if (!py::isinstance<py::dict>(value)) {
    throw BadInput(std::string(argument) + " is a dict");
  }
  auto copy = py::reinterpret_steal<py::dict>(PyDict_Copy(value.ptr()));
  if (!copy) {
    throw py::error_already_set();
  }
  return copy;
}

}  // namespace changeover::python
