#include "bind.hpp"
#include "changeover/core/version.hpp"
#include "changeover/run/control.hpp"
#include "long_work.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace changeover::python;
  module.doc() = "What the package changeover calls. Its functions are for its modules alone.";
  module.attr("__version__") = std::string(changeover::version);
  module.attr("most_threads") = changeover::most_threads;
  stop_long_work_at_the_end();
  register_errors();
  bind_memory(module);
  bind_designs(module);
  bind_known(module);
  bind_notebook(module);
  bind_search(module);
  bind_catalog(module);
  bind_plan(module);
  bind_loads(module);
}
