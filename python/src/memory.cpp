#include "memory.hpp"

#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "bind.hpp"
#include "gil.hpp"

namespace changeover::python {
namespace {

// Python's memoryviews hold a reference to what they show: this object, which owns the bytes.
struct Exporter {
  PyObject_HEAD;
  std::shared_ptr<const void> owner;
  const void* bytes;
  Py_ssize_t shape[2];    // rows and numbers in a row; of an item its bytes
  Py_ssize_t strides[2];  // of rows of numbers
  bool writable;
};

Exporter& exporter_of(const py::handle& object) {
  return *reinterpret_cast<Exporter*>(object.ptr());
}

int get_buffer(PyObject* self, Py_buffer* view, int flags) {
  Exporter& exporter = *reinterpret_cast<Exporter*>(self);
  const bool rows = exporter.strides[0] != 0;
  const Py_ssize_t size = rows ? exporter.shape[0] * exporter.strides[0] : exporter.shape[0];
  const int readonly = exporter.writable ? 0 : 1;
  void* const bytes = const_cast<void*>(exporter.bytes);  // NOLINT: read-only, or writable
  const int failed = PyBuffer_FillInfo(view, self, bytes, size, readonly, flags);
  if (failed == 0 && rows && (flags & PyBUF_ND) != 0) {
    static char numbers[] = "I";
    view->itemsize = exporter.strides[1];
    view->ndim = 2;
    view->shape = exporter.shape;
    view->strides = (flags & PyBUF_STRIDES) == PyBUF_STRIDES ? exporter.strides : nullptr;
    view->format = (flags & PyBUF_FORMAT) != 0 ? numbers : nullptr;
  }
  return failed;
}

void destroy(PyObject* self) {
  PyTypeObject* const type = Py_TYPE(self);
  std::destroy_at(&reinterpret_cast<Exporter*>(self)->owner);
  type->tp_free(self);
  Py_DECREF(type);
}

PyObject* refuse_to_make(PyTypeObject* /*type*/, PyObject* /*args*/, PyObject* /*named*/) {
  PyErr_SetString(PyExc_TypeError, "memory is not made by hand");
  return nullptr;
}

PyObject* type_of_exporters() {
  static PyType_Slot slots[] = {
      {Py_bf_getbuffer, reinterpret_cast<void*>(&get_buffer)},
      {Py_tp_dealloc, reinterpret_cast<void*>(&destroy)},
      {Py_tp_new, reinterpret_cast<void*>(&refuse_to_make)},
      {0, nullptr},
  };
  static PyType_Spec spec = {"changeover._core.Memory", sizeof(Exporter), 0,
                             Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots};
  // Made once, with the lock held, and never given back.
  static PyObject* const type = PyType_FromSpec(&spec);
  if (type == nullptr) {
    throw py::error_already_set();
  }
  return type;
}

py::object exporter_of(PyObject* type, std::shared_ptr<const void> owner, const void* bytes,
                       Py_ssize_t count, Py_ssize_t k) {
  auto made =
      made_by_python([&] { return PyType_GenericAlloc(reinterpret_cast<PyTypeObject*>(type), 0); });
  Exporter& exporter = exporter_of(made);
  new (&exporter.owner) std::shared_ptr<const void>(std::move(owner));
  constexpr auto size = static_cast<Py_ssize_t>(sizeof(Element));
  exporter.bytes = bytes;
  exporter.writable = false;
  exporter.shape[0] = count;
  exporter.shape[1] = k;
  exporter.strides[0] = k * size;
  exporter.strides[1] = size;
  return made;
}

const Element* row_of(const Exporter& blocks, Py_ssize_t index) {
  return static_cast<const Element*>(blocks.bytes) + index * blocks.shape[1];
}

// A row of a type that Python derived, which says what rows there are.
py::tuple row(const py::object& blocks, Py_ssize_t index) {
  const Exporter& exporter = exporter_of(blocks);
  return tuple_of({row_of(exporter, index), static_cast<std::size_t>(exporter.shape[1])});
}

// A copy of rows of k numbers, of such a type.
py::object copied(const py::object& type, const py::bytes& bytes, std::size_t k) {
  const auto text = static_cast<std::string_view>(bytes);
  const std::size_t count = text.size() / sizeof(Element);
  if (k == 0 || k > std::numeric_limits<Element>::max() || text.size() % sizeof(Element) != 0 ||
      count % k != 0) {
    throw py::value_error("these are not rows of that many numbers");
  }
  const auto copy = std::make_shared<std::vector<Element>>(count);
  std::memcpy(copy->data(), text.data(), text.size());
  return blocks_of(type, copy, copy->data(), copy->size() / k, k);
}

// A part of the rows, of the same type.
py::object part(const py::object& blocks, Py_ssize_t first, Py_ssize_t length, Py_ssize_t step) {
  const py::type type = py::type::of(blocks);
  const Exporter& exporter = exporter_of(blocks);
  const Py_ssize_t k = exporter.shape[1];
  if (step == 1) {
    return exporter_of(type.ptr(), exporter.owner, row_of(exporter, first), length, k);
  }
  const auto copy = std::make_shared<std::vector<Element>>();
  for (Py_ssize_t i = 0; i < length; ++i) {
    const Element* const start = row_of(exporter, first + i * step);
    copy->insert(copy->end(), start, start + k);
  }
  return exporter_of(type.ptr(), copy, copy->data(), length, k);
}

}  // namespace

py::tuple tuple_of(std::span<const Element> elements) {
  py::tuple all(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    all[i] = py::int_(elements[i]);
  }
  return all;
}

py::object blocks_of(const py::object& type, std::shared_ptr<const void> owner,
                     const Element* first, std::size_t count, std::size_t k) {
  return exporter_of(type.ptr(), std::move(owner), first, static_cast<Py_ssize_t>(count),
                     static_cast<Py_ssize_t>(k));
}

py::object view_of(const ItemView& item) {
  const py::object made = exporter_of(type_of_exporters(), item.keep(), item.bytes.data(),
                                      static_cast<Py_ssize_t>(item.bytes.size()), 0);
  return made_by_python([&] { return PyMemoryView_FromObject(made.ptr()); });
}

py::object writable_view_of(const HeldItem& item) {
  const py::object made = exporter_of(type_of_exporters(), *item.memory, item.bytes.data(),
                                      static_cast<Py_ssize_t>(item.bytes.size()), 0);
  exporter_of(made).writable = true;
  return made_by_python([&] { return PyMemoryView_FromObject(made.ptr()); });
}

void end_view(const py::object& view) {
  PyObject* const none =
      unless_python_ends([&] { return PyObject_CallMethod(view.ptr(), "release", nullptr); });
  if (none == nullptr) {
    PyErr_Clear();  // NumPy holds it, say: it goes on, and so do its bytes.
  }
  Py_XDECREF(none);
}

void bind_memory(py::module_& module) {
  module.attr("Memory") = py::reinterpret_borrow<py::object>(type_of_exporters());
  const py::object memory = module.attr("Memory");
  module.def("blocks_of_bytes", &copied);
  memory.attr("row") = py::cpp_function(&row, py::name("row"), py::is_method(memory));
  memory.attr("part") = py::cpp_function(&part, py::name("part"), py::is_method(memory));
}

}  // namespace changeover::python
