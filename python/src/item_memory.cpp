#include "item_memory.hpp"

#include <memory>
#include <new>

#include "gil.hpp"

namespace changeover::python {
namespace {

namespace py = pybind11;

// Python's memoryviews hold a reference to what they show: this object, which owns the bytes.
struct Exporter {
  PyObject_HEAD;
  std::shared_ptr<const std::byte> owner;
  const std::byte* bytes;
  Py_ssize_t size;
};

int get_buffer(PyObject* self, Py_buffer* view, int flags) {
  auto* const exporter = reinterpret_cast<Exporter*>(self);
  constexpr int readonly = 1;
  return PyBuffer_FillInfo(view, self,
                           const_cast<std::byte*>(exporter->bytes),  // NOLINT: read-only
                           exporter->size, readonly, flags);
}

void destroy(PyObject* self) {
  PyTypeObject* const type = Py_TYPE(self);
  std::destroy_at(&reinterpret_cast<Exporter*>(self)->owner);
  type->tp_free(self);
  Py_DECREF(type);
}

PyObject* refuse_to_make(PyTypeObject* /*type*/, PyObject* /*args*/, PyObject* /*named*/) {
  PyErr_SetString(PyExc_TypeError, "the memory of an item is not made by hand");
  return nullptr;
}

PyTypeObject* type_of_exporters() {
  static PyType_Slot slots[] = {
      {Py_bf_getbuffer, reinterpret_cast<void*>(&get_buffer)},
      {Py_tp_dealloc, reinterpret_cast<void*>(&destroy)},
      {Py_tp_new, reinterpret_cast<void*>(&refuse_to_make)},
      {0, nullptr},
  };
  static PyType_Spec spec = {"changeover._core._ItemMemory", sizeof(Exporter), 0,
                             Py_TPFLAGS_DEFAULT, slots};
  // Made once, with the lock held, and never given back.
  static PyObject* const type = PyType_FromSpec(&spec);
  if (type == nullptr) {
    throw py::error_already_set();
  }
  return reinterpret_cast<PyTypeObject*>(type);
}

}  // namespace

py::object view_of(const ItemView& item) {
  PyTypeObject* const type = type_of_exporters();
  const auto made = made_by_python([&] { return PyType_GenericAlloc(type, 0); });
  auto* const exporter = reinterpret_cast<Exporter*>(made.ptr());
  new (&exporter->owner) std::shared_ptr<const std::byte>(item.keep());
  exporter->bytes = item.bytes.data();
  exporter->size = static_cast<Py_ssize_t>(item.bytes.size());
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

}  // namespace changeover::python
