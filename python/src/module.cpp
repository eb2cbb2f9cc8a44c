#include "bind.hpp"
#include "changeover/core/version.hpp"
#include "long_work.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace changeover::python;
  module.doc() = "Change covering designs: the compiled part of the package changeover.";
  module.attr("__version__") = std::string(changeover::version);
  stop_long_work_at_the_end();
  bind_errors(module);
  bind_blocks(module);
  bind_designs(module);
  bind_bounds(module);
  bind_search(module);
  bind_catalog(module);
  bind_benches(module);
  bind_plan(module);
  bind_loads(module);
  refuse_empty_objects(module);
}
