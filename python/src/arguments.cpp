#include "arguments.hpp"

#include "changeover/core/error.hpp"
#include "core/printable.hpp"

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
  return "'" + printable(words.substr(0, end)) + (end < words.size() ? "…'" : "'");
}

namespace {

// Whether it is of a class of Python's library. What finds this out runs code in Python, where Python may end this thread.
bool is_of(const py::handle& value, const char* module_name, const char* class_name) {
  const py::object holder = made_by_python([&] { return PyImport_ImportModule(module_name); });
  const py::object type =
      made_by_python([&] { return PyObject_GetAttrString(holder.ptr(), class_name); });
  const int is = unless_python_ends([&] { return PyObject_IsInstance(value.ptr(), type.ptr()); });
  if (is < 0) {
    throw py::error_already_set();
  }
  return is == 1;
}

bool is_mapping(const py::handle& value) {
  return py::isinstance<py::dict>(value) || is_of(value, "collections.abc", "Mapping");
}

}  // namespace

bool is_text(const py::handle& value) {
  return py::isinstance<py::str>(value) || is_of(value, "collections", "UserString");
}

bool is_bytes(const py::handle& value) {
  return py::isinstance<py::bytes>(value) || py::isinstance<py::bytearray>(value) ||
         (PyMemoryView_Check(value.ptr()) != 0 && words_of(value.attr("format")) == "B");
}

bool is_missing(const py::handle& value) {
  if (value.is_none()) {
    return true;
  }
  const std::string type = words_of(py::type::of(value).attr("__name__"));
  if (type == "NAType" || type == "NaTType") {
    return true;  // of pandas
  }
  if (is_text(value)) {
    return false;
  }
  // NaN alone is not what it is. An array has no answer.
  const auto differs = py::reinterpret_steal<py::object>(
      unless_python_ends([&] { return PyObject_RichCompare(value.ptr(), value.ptr(), Py_NE); }));
  const int is_nan = differs ? PyObject_IsTrue(differs.ptr()) : -1;
  if (is_nan < 0) {
    PyErr_Clear();
  }
  return is_nan == 1;
}

void require_iterable(const char* argument, const char* holds, const py::handle& value) {
  const std::string begin = std::string(argument) + " has " + holds + ", ";
  if (is_text(value)) {
    throw py::type_error(begin + "and is a list of them, not a string");
  }
  if (is_bytes(value)) {
    throw py::type_error(begin + "and is a list of them, not bytes");
  }
  if (is_mapping(value)) {
    throw py::type_error(begin +
                         "and is a list of them, not a dict; what its keys lead to would be lost");
  }
  if (is_data_frame(value)) {
    throw py::type_error(begin + "not a DataFrame; give its rows, or one of its columns");
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

bool has_numbered_rows(const py::handle& table) {
  const py::object index = table.attr("index");
  return py::hasattr(index, "dtype") &&
         std::string_view("iu").find(words_of(index.attr("dtype").attr("kind"))) !=
             std::string_view::npos;
}

py::object rows_of(const char* argument, const py::object& value) {
  if (!is_data_frame(value)) {
    return value;
  }
  if (!has_numbered_rows(value)) {
    throw py::type_error(std::string(argument) +
                         ": the index of the DataFrame would be lost; give reset_index() of it");
  }
  return value.attr("itertuples")(py::arg("index") = false, py::arg("name") = py::none());
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
