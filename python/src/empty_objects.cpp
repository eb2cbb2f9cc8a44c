// Objects that were made without their constructor: T.__new__(T).
#include "bind.hpp"

namespace changeover::python {
namespace {

// pybind11 asks for memory when a method is called on an object that has none, and would hand it out as it is.
void* refuse_memory(std::size_t /*bytes*/) {
  throw py::type_error("this object was made without its constructor, and there is nothing in it");
}

// As above, where Python's C interface asks, which knows no exceptions.
int refuse_buffer(PyObject* self, Py_buffer* view, int flags) {
  const auto* const instance = reinterpret_cast<const py::detail::instance*>(self);
  if (!instance->simple_layout || instance->simple_value_holder[0] == nullptr) {
    view->obj = nullptr;
    PyErr_SetString(PyExc_TypeError,
                    "this object was made without its constructor, and there is nothing in it");
    return -1;
  }
  return py::detail::pybind11_getbuffer(self, view, flags);
}

}  // namespace

void refuse_empty_objects(const py::module_& module) {
  for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>()) {
    if (py::isinstance<py::module_>(value)) {
      refuse_empty_objects(value.cast<py::module_>());
    }
    if (!py::isinstance<py::type>(value)) {
      continue;
    }
    auto* const type = reinterpret_cast<PyTypeObject*>(value.ptr());
    if (py::detail::type_info* const info = py::detail::get_type_info(type)) {
      info->operator_new = &refuse_memory;
      if (info->get_buffer != nullptr) {
        type->tp_as_buffer->bf_getbuffer = &refuse_buffer;
      }
    }
  }
}

}  // namespace changeover::python
