// Faults of the library as exceptions of changeover/errors.py, told apart as in
// changeover/core/error.hpp.
#include <exception>
#include <string>
#include <utility>

#include "bind.hpp"
#include "changeover/core/error.hpp"

namespace changeover::python {

void register_errors() {
  py::register_exception_translator([](std::exception_ptr fault) {
    const auto raise = [](const char* name, const Error& error) {
      const py::object type = py::module_::import("changeover.errors").attr(name);
      // A name of a file may be no UTF-8.
      const std::string what = error.what();
      const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
          what.data(), static_cast<Py_ssize_t>(what.size()), "backslashreplace"));
      if (text) {
        PyErr_SetObject(type.ptr(), text.ptr());
      }
    };
    try {
      if (fault) {
        std::rethrow_exception(std::move(fault));
      }
    } catch (const BadInput& error) {
      raise("BadInput", error);
    } catch (const ImpossibleParameters& error) {
      raise("ImpossibleParameters", error);
    } catch (const MissingResource& error) {
      raise("MissingResource", error);
    } catch (const InternalError& error) {
      raise("InternalError", error);
    } catch (const Error& error) {
      raise("Error", error);
    }
  });
}

}  // namespace changeover::python
