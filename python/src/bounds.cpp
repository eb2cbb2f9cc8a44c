// Lower bounds with their reasons, what is known, and tables of both.
#include "changeover/bounds/lower_bound.hpp"

#include "bind.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

// The name of the parameters, what is known, and every bound.
py::tuple bounds(std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
                 std::uint64_t strength) {
  const Parameters p = parameters(v, k, change, kind_of(kind), strength);
  std::optional<std::string> impossible;
  std::vector<Bound> bounds;  // largest first; none if impossible
  std::optional<Offer> best;
  std::optional<Reported> reported;
  stoppable([&] {
    impossible = impossibility(p);
    if (!impossible) {
      bounds = lower_bounds(p);
      best = best_known(Registry::standard(), p);
      reported = reported_below(p, best ? std::optional(best->b) : std::nullopt);
    }
    return true;
  });
  py::list all;
  for (const Bound& each : bounds) {
    all.append(py::make_tuple(each.blocks, each.name, each.reason));
  }
  py::dict facts(py::arg("lower_bound") = py::none(), py::arg("best_known") = py::none(),
                 py::arg("construction") = "", py::arg("reason") = impossible,
                 py::arg("reported") = py::none());
  if (!impossible) {
    facts["lower_bound"] = bounds.front().blocks;
    facts["reason"] = bounds.front().reason;
  }
  if (reported) {
    facts["reported"] = py::make_tuple(reported->blocks, reported->cites);
  }
  if (best) {
    facts["best_known"] = best->b;
    facts["construction"] = best->recipe.construction;
  }
  return py::make_tuple(name(p), facts, all);
}

py::tuple cell_of(const KnownCell& cell) {
  py::dict facts = facts_of(cell.parameters);
  facts["b"] = cell.best ? py::cast(cell.best->b) : py::none();
  facts["construction"] = cell.best ? py::cast(cell.best->recipe.construction) : py::none();
  facts["lower_bound"] = cell.impossible ? py::none() : py::cast(cell.bound.blocks);
  facts["reason"] = cell.impossible ? *cell.impossible : cell.bound.reason;
  facts["status"] = cell.status();
  return py::make_tuple(name(cell.parameters), facts);
}

py::list table(std::uint64_t k_from, std::uint64_t k_to, std::uint64_t v_from, std::uint64_t v_to,
               std::uint64_t change, const std::optional<std::string>& kind) {
  if (k_from < 2 || k_to < k_from || v_from < 2 || v_to < v_from || v_to > largest_v_of_a_range ||
      change < 1) {
    throw BadInput("a table has 2 <= k, 2 <= v <= 1000 and a change of 1 or more");
  }
  const std::vector<Kind> kinds = kinds_of(kind);
  const BestKnownTable plan = stoppable([&] {
    return best_known_table(
        Registry::standard(),
        {.v_from = v_from, .v_to = v_to, .k_from = k_from, .k_to = k_to, .change = change});
  });
  py::list cells;
  for (const Kind each : kinds) {
    for (std::uint64_t k = k_from; k <= k_to; ++k) {
      for (std::uint64_t v = v_from; v <= v_to; ++v) {
        cells.append(cell_of(plan.at({.v = v, .k = k, .change = change, .kind = each})));
      }
    }
  }
  return cells;
}

}  // namespace

void bind_bounds(py::module_& module) {
  module.def("bounds", &bounds);
  module.def("table", &table);
}

}  // namespace changeover::python
