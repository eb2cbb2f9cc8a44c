// The catalog: designs that are known, by label and by cell.
#include "changeover/catalog/catalog.hpp"
#include <fmt/format.h>

#include "bind.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/run/control.hpp"
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

py::dict facts_of_entry(const CatalogEntry& entry) {
  const Credit& credit = entry.credit;
  py::dict facts = facts_of(entry.parameters);
  facts["label"] = entry.label();
  facts["b"] = entry.b;
  facts["lower_bound"] = entry.lower_bound;
  facts["reason"] = entry.reason;
  facts["status"] = std::string(entry.status());
  facts["credit"] =
      py::dict(py::arg("who") = credit.who, py::arg("date") = credit.date,
               py::arg("program") = credit.program, py::arg("command") = credit.command);
  facts["cites"] = entry.cites;
  facts["note"] = entry.note;
  facts["retracted"] = entry.retracted;
  return facts;
}

std::vector<CatalogEntry> entries(std::optional<std::uint64_t> v_from,
                                  std::optional<std::uint64_t> v_to,
                                  std::optional<std::uint64_t> k_from,
                                  std::optional<std::uint64_t> k_to,
                                  std::optional<std::uint64_t> change,
                                  const std::optional<std::string>& kind, const std::string& status,
                                  bool best_only, bool users_only) {
  const CatalogFilter filter{.v_from = v_from,
                             .v_to = v_to,
                             .k_from = k_from,
                             .k_to = k_to,
                             .change = change,
                             .kind = kind ? std::optional(kind_of(*kind)) : std::nullopt,
                             .status = status,
                             .best_only = best_only,
                             .users_only = users_only};
  return stoppable([&] {
    std::vector<CatalogEntry> found;
    standard_catalog().each(filter, [&](const CatalogEntry& entry) {
      stop_if_asked();
      found.push_back(entry);
      return true;
    });
    return found;
  });
}

// Where the text is the beginning of labels, it goes on as far as the number of blocks.
bool names_blocks(const std::string& text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string::npos || dot + 1 == text.size() || parse_cell_label(text)) {
    return false;
  }
  const std::size_t before = text.rfind('.', dot - 1);
  return parse_cell_label(text.substr(0, dot)) || parse_cell_label(text.substr(0, before));
}

std::optional<CatalogEntry> find(const std::string& label) {
  auto entry = standard_catalog().find(label);
  if (!entry && reads_as_label(label) && !names_blocks(label)) {
    throw BadInput(
        fmt::format("'{}' ends before the number of blocks, and is no alias; write a label such as "
                    "20.5.2.circular.29, or ask cell() for all entries with given v and k",
                    label));
  }
  return entry;
}

std::string add(const HeldDesign& design, const std::string& who, const std::string& date,
                const std::string& note) {
  return stoppable([&] {
    const Newcomer newcomer =
        newcomer_of(*design.design, {.credit = {.who = who, .date = date}, .note = note});
    if (!newcomer.entry) {
      throw BadInput("the design was not added to the catalog: " + newcomer.refused);
    }
    standard_catalog().add(*newcomer.entry);
    return newcomer.entry->label();
  });
}

}  // namespace

void bind_catalog(py::module_& module) {
  py::class_<CatalogEntry>(module, "Entry")
      .def("facts", &facts_of_entry)
      .def("recipe", [](const CatalogEntry& self) { return recipe_to_json(self.recipe); })
      .def("design", &built)
      .def("line", [](const CatalogEntry& self) { return line_of(self, {}); })
      .def_static("of_line",
                  [](const std::string& line) { return entry_from_line(line, "pickle", 1, {}); })
      .def_static("find", &find)
      .def_static(
          "cell",
          [](std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
             std::uint64_t strength) {
            return standard_catalog().cell(parameters(v, k, change, kind_of(kind), strength));
          })
      .def_static("all", &entries)
      .def_static("add", &add);
}

}  // namespace changeover::python
