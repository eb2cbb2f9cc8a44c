// Lower bounds with their reasons, what is known, and tables of both.
#include "changeover/bounds/lower_bound.hpp"

#include "bind.hpp"
#include "changeover/catalog/reported.hpp"
#include "changeover/construct/planner.hpp"
#include "changeover/core/error.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

struct KnownBounds {
  Parameters parameters;
  std::optional<std::string> impossible;
  std::vector<Bound> bounds;  // largest first; none if impossible
  std::optional<std::uint64_t> best_known;
  std::string construction;
  std::optional<Reported> reported;
};

KnownBounds bounds(std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
                   std::uint32_t strength) {
  const Parameters p{.v = v, .k = k, .change = change, .kind = kind_of(kind), .strength = strength};
  check(p);
  return stoppable([&] {
    KnownBounds known{.parameters = p, .impossible = impossibility(p)};
    if (!known.impossible) {
      known.bounds = lower_bounds(p);
      if (const auto offer = best_known(Registry::standard(), p)) {
        known.best_known = offer->b;
        known.construction = offer->recipe.construction;
      }
      known.reported = reported_below(p, known.best_known);
    }
    return known;
  });
}

std::string status(const KnownBounds& known) {
  if (known.impossible) {
    return "impossible";
  }
  if (!known.best_known) {
    return "open";
  }
  return *known.best_known == known.bounds.front().blocks ? "minimum" : "best-known";
}

std::vector<PlannedCell> table(std::uint64_t k_from, std::uint64_t k_to, std::uint64_t v_from,
                               std::uint64_t v_to, std::uint64_t change,
                               const std::optional<std::string>& kind) {
  if (k_from < 2 || k_to < k_from || v_from < 2 || v_to < v_from || v_to > largest_v_of_a_plan ||
      change < 1) {
    throw BadInput("a table has 2 <= k, 2 <= v <= 1000 and a change of 1 or more");
  }
  const std::vector<Kind> kinds = kinds_of(kind);
  return stoppable([&] {
    const Plan plan = plan_range(
        Registry::standard(),
        {.v_from = v_from, .v_to = v_to, .k_from = k_from, .k_to = k_to, .change = change});
    std::vector<PlannedCell> cells;
    for (const Kind each : kinds) {
      for (std::uint64_t k = k_from; k <= k_to; ++k) {
        for (std::uint64_t v = v_from; v <= v_to; ++v) {
          cells.push_back(plan.at({.v = v, .k = k, .change = change, .kind = each}));
        }
      }
    }
    return cells;
  });
}

}  // namespace

void bind_bounds(py::module_& module) {
  py::class_<Bound>(module, "Bound", "A number of blocks that no design goes below, and why.")
      .def_readonly("blocks", &Bound::blocks)
      .def_readonly("name", &Bound::name, "'counting', 'degree', 'stays', …")
      .def_readonly("reason", &Bound::reason, "One line of plain mathematics.")
      .def("__repr__", [](const Bound& self) {
        return "<at least " + std::to_string(self.blocks) + " (" + self.name + ")>";
      });
  py::class_<KnownBounds>(module, "Bounds", "What is known of the least number of blocks.")
      .def_property_readonly(
          "lower_bound",
          [](const KnownBounds& self) {
            return self.impossible ? std::nullopt : std::optional(self.bounds.front().blocks);
          },
          "The largest lower bound; None if no design exists.")
      .def_property_readonly(
          "reason",
          [](const KnownBounds& self) {
            return self.impossible ? *self.impossible : self.bounds.front().reason;
          },
          "Of the bound, or why no design exists; one line.")
      .def_readonly("best_known", &KnownBounds::best_known,
                    "Blocks of the best design that is known, or None.")
      .def_readonly("construction", &KnownBounds::construction, "What makes that design.")
      .def_readonly("all", &KnownBounds::bounds, "Every bound that applies, largest first.")
      .def_property_readonly("status", &status, "'minimum', 'best-known', 'open' or 'impossible'.")
      .def_property_readonly(
          "reported",
          [](const KnownBounds& self) {
            return self.reported
                       ? std::optional(std::pair(self.reported->blocks, self.reported->cites))
                       : std::nullopt;
          },
          "Fewer blocks that a publication reports and that are not held here, so not verified, and its "
          "key in the references; or None.")
      .def("__repr__", [](const KnownBounds& self) {
        return "<" + name(self.parameters) + ": " + status(self) + ">";
      });
  py::class_<PlannedCell>(module, "Cell",
                          "What is known of one set of parameters: a cell of a table.")
      .def_property_readonly("v", [](const PlannedCell& self) { return self.parameters.v; })
      .def_property_readonly("k", [](const PlannedCell& self) { return self.parameters.k; })
      .def_property_readonly("change",
                             [](const PlannedCell& self) { return self.parameters.change; })
      .def_property_readonly(
          "kind",
          [](const PlannedCell& self) { return std::string(to_string(self.parameters.kind)); })
      .def_property_readonly(
          "b",
          [](const PlannedCell& self) {
            return self.best ? std::optional(self.best->b) : std::nullopt;
          },
          "Blocks of the best design that is known, or None.")
      .def_property_readonly("lower_bound",
                             [](const PlannedCell& self) {
                               return self.impossible ? std::nullopt
                                                      : std::optional(self.bound.blocks);
                             })
      .def_property_readonly("reason",
                             [](const PlannedCell& self) {
                               return self.impossible ? *self.impossible : self.bound.reason;
                             })
      .def_property_readonly("status", &PlannedCell::status,
                             "'minimum', 'best-known', 'open' or 'impossible'.")
      .def_property_readonly("construction",
                             [](const PlannedCell& self) {
                               return self.best ? std::optional(self.best->recipe.construction)
                                                : std::nullopt;
                             })
      .def("__repr__", [](const PlannedCell& self) {
        return "<" + name(self.parameters) + ": " + self.status() + ">";
      });
  module.def(
      "bounds", &bounds, py::arg("v"), py::arg("k"), py::arg("change") = 2,
      py::arg("kind") = "linear", py::arg("strength") = 2,
      "Lower bounds on the number of blocks with their reasons, and the best design that is known. Raises "
      "ImpossibleParameters if no such blocks can be written down.");
  module.def("_table", &table, py::arg("k_from"), py::arg("k_to"), py::arg("v_from"),
             py::arg("v_to"), py::arg("change"), py::arg("kind"));
}

}  // namespace changeover::python
