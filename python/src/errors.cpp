// Faults of the library as exceptions of changeover/errors.py, told apart as in
// changeover/core/error.hpp.
#include <exception>
#include <utility>

#include "bind.hpp"
#include "changeover/core/error.hpp"

namespace changeover::python {

void register_errors() {
  py::register_exception_translator([](std::exception_ptr fault) {
    const auto raise = [](const char* name, const Error& error) {
      const py::object type = py::module_::import("changeover.errors").attr(name);
      PyErr_SetString(type.ptr(), error.what());
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
