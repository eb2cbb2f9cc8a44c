// Faults of the library as exceptions of Python, told apart as in changeover/core/error.hpp.
#include "bind.hpp"
#include "changeover/core/error.hpp"

namespace changeover::python {

void bind_errors(py::module_& module) {
  static py::exception<Error> base(module, "Error");
  base.attr("__doc__") = "Base of every fault of this package.";
  // The first is told from others before the base, so the base is registered first.
  const auto with = [&](PyObject* builtin) { return py::make_tuple(base, py::handle(builtin)); };
  static py::exception<BadInput> bad(module, "BadInput", with(PyExc_ValueError));
  bad.attr("__doc__") =
      "What was given is malformed; one line says what, where, and how to mend it.";
  static py::exception<ImpossibleParameters> impossible(module, "ImpossibleParameters",
                                                        with(PyExc_ValueError));
  impossible.attr("__doc__") =
      "Nothing with these parameters can exist, or they exceed what is supported.";
  static py::exception<MissingResource> missing(module, "MissingResource", with(PyExc_OSError));
  missing.attr("__doc__") =
      "Something outside is missing: memory, room on the disk, a file, a permission.";
  static py::exception<InternalError> internal(module, "InternalError", with(PyExc_RuntimeError));
  internal.attr("__doc__") = "A bug of this library: a result failed its own verification.";
  py::register_exception_translator([](std::exception_ptr fault) {
    try {
      if (fault) {
        std::rethrow_exception(fault);
      }
    } catch (const BadInput& error) {
      bad(error.what());
    } catch (const ImpossibleParameters& error) {
      impossible(error.what());
    } catch (const MissingResource& error) {
      missing(error.what());
    } catch (const InternalError& error) {
      internal(error.what());
    } catch (const Error& error) {
      base(error.what());
    }
  });
}

}  // namespace changeover::python
