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

namespace {

bool is_mapping(const py::handle& value) {
  return py::isinstance<py::dict>(value) ||
         py::isinstance(value, py::module_::import("collections.abc").attr("Mapping"));
}

}  // namespace

void require_iterable(const char* argument, const char* holds, const py::handle& value) {
  const std::string begin = std::string(argument) + " has " + holds + ", ";
  if (py::isinstance<py::str>(value)) {
    throw py::type_error(begin + "and is a list of them, not a string");
  }
  if (py::isinstance<py::bytes>(value) || py::isinstance<py::bytearray>(value)) {
    throw py::type_error(begin + "and is a list of them, not bytes");
  }
  if (is_mapping(value)) {
    throw py::type_error(begin +
                         "and is a list of them, not a dict; what its keys lead to would be lost");
  }
  if (!py::isinstance<py::iterable>(value)) {
    throw py::type_error(begin + "not " + quoted(words_of(py::repr(value))));
  }
}

void require_ordered(const char* argument, const char* holds, const py::handle& value) {
  require_iterable(argument, holds, value);
  if (PyAnySet_Check(value.ptr()) != 0) {
    throw py::type_error(std::string(argument) + " has " + holds +
                         " in an order, and a set has none; give sorted(...) of it");
  }
}

bool is_data_frame(const py::handle& value) {
  return py::hasattr(value, "itertuples") && py::hasattr(value, "columns");
}

py::object rows_of(const py::object& value) {
  return is_data_frame(value)
             ? value.attr("itertuples")(py::arg("index") = false, py::arg("name") = py::none())
             : value;
}

bool leads_from_keys(const py::handle& value) {
  return is_mapping(value) ||
         (py::hasattr(value, "items") && py::hasattr(value, "index") && !is_data_frame(value));
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
