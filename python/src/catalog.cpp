// The catalog: designs that are known, by label and by cell.
#include "changeover/catalog/catalog.hpp"
#include "bind.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/construct/standard_catalog.hpp"
#include "changeover/core/error.hpp"
#include "changeover/curator/add.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

HeldDesign built(const CatalogEntry& entry) {
  return stoppable([&] {
    const Registry& registry = Registry::standard();
    Design design = read_all(*registry.build(entry.recipe));
    design.recipe = entry.recipe;
    return held(surely_verified(std::move(design), entry.label()));
  });
}

py::dict credit_of(const Credit& credit) {
  py::dict said;
  said["who"] = credit.who;
  said["date"] = credit.date;
  said["program"] = credit.program;
  said["command"] = credit.command;
  return said;
}

std::vector<CatalogEntry> entries(const CatalogFilter& filter) {
  return stoppable([&] {
    std::vector<CatalogEntry> found;
    standard_catalog().each(filter, [&](const CatalogEntry& entry) {
      found.push_back(entry);
      return true;
    });
    return found;
  });
}

std::string add(const HeldDesign& design, const std::string& who, const std::string& date,
                const std::string& note) {
  return stoppable([&] {
    const Newcomer newcomer =
        newcomer_of(*design.design, {.credit = {.who = who, .date = date}, .note = note});
    if (!newcomer.entry) {
      throw BadInput("the catalog does not take it: " + newcomer.refused);
    }
    standard_catalog().add(*newcomer.entry);
    return newcomer.entry->label();
  });
}

}  // namespace

void bind_catalog(py::module_& module) {
  py::class_<CatalogEntry>(module, "Entry", "A design of the catalog, with all that is said of it.")
      .def_property_readonly("label", &CatalogEntry::label,
                             "Permanent; made of the parameters and the blocks alone.")
      .def_property_readonly("v", [](const CatalogEntry& self) { return self.parameters.v; })
      .def_property_readonly("k", [](const CatalogEntry& self) { return self.parameters.k; })
      .def_property_readonly("change",
                             [](const CatalogEntry& self) { return self.parameters.change; })
      .def_property_readonly(
          "kind",
          [](const CatalogEntry& self) { return std::string(to_string(self.parameters.kind)); })
      .def_property_readonly("strength",
                             [](const CatalogEntry& self) { return self.parameters.strength; })
      .def_readonly("b", &CatalogEntry::b)
      .def_readonly("lower_bound", &CatalogEntry::lower_bound,
                    "That was known when the entry was written.")
      .def_readonly("reason", &CatalogEntry::reason)
      .def_property_readonly(
          "status", [](const CatalogEntry& self) { return std::string(self.status()); },
          "'minimum', 'best-known' or 'retracted'.")
      .def_property_readonly("recipe",
                             [](const CatalogEntry& self) { return as_dict(self.recipe); })
      .def_property_readonly("credit",
                             [](const CatalogEntry& self) { return credit_of(self.credit); })
      .def_readonly("cites", &CatalogEntry::cites)
      .def_readonly("note", &CatalogEntry::note)
      .def_readonly("retracted", &CatalogEntry::retracted,
                    "Why it is no longer vouched for; empty if it is.")
      .def("design", &built, "Its blocks, built and verified.")
      .def("__repr__", [](const CatalogEntry& self) { return "<" + self.label() + ">"; });
  py::module_ catalog = module.def_submodule(
      "catalog", "The catalog that comes with the package, and the user's own.");
  catalog.def(
      "find", [](const std::string& label) { return standard_catalog().find(label); },
      py::arg("label"),
      "The entry of a label, of an alias, or of the beginning of one label alone; None if there is none.");
  catalog.def(
      "cell",
      [](std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
         std::uint32_t strength) {
        const Parameters p{
            .v = v, .k = k, .change = change, .kind = kind_of(kind), .strength = strength};
        check(p);
        return standard_catalog().cell(p);
      },
      py::arg("v"), py::arg("k"), py::arg("change") = 2, py::arg("kind") = "linear",
      py::arg("strength") = 2, "All entries of a cell, fewest blocks first, retracted ones too.");
  catalog.def(
      "entries",
      [](std::optional<std::uint64_t> v_from, std::optional<std::uint64_t> v_to,
         std::optional<std::uint64_t> k_from, std::optional<std::uint64_t> k_to,
         std::optional<std::uint64_t> change, const std::optional<std::string>& kind,
         const std::string& status, bool best_only, bool users_only) {
        return entries({.v_from = v_from,
                        .v_to = v_to,
                        .k_from = k_from,
                        .k_to = k_to,
                        .change = change,
                        .kind = kind ? std::optional(kind_of(*kind)) : std::nullopt,
                        .status = status,
                        .best_only = best_only,
                        .users_only = users_only});
      },
      py::kw_only(), py::arg("v_from") = py::none(), py::arg("v_to") = py::none(),
      py::arg("k_from") = py::none(), py::arg("k_to") = py::none(), py::arg("change") = py::none(),
      py::arg("kind") = py::none(), py::arg("status") = "", py::arg("best_only") = true,
      py::arg("users_only") = false,
      "A list of the entries that are asked for, by change, kind, k, v, b; the best of each cell only unless said.");
  catalog.def(
      "add", &add, py::arg("design"), py::kw_only(), py::arg("who"), py::arg("date"),
      py::arg("note") = "",
      "Puts a design into the user's catalog and returns its label. Raises BadInput if it is none.");
}

}  // namespace changeover::python
