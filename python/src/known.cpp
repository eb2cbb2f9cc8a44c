// What is known, as the documents that every door has: bounds, tables, how a design is made, what
// makes designs.

#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "construct/known_tables.hpp"
#include "core/each.hpp"
#include "io/write/json_writer.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

class Question {
 public:
  explicit Question(const py::kwargs& asked) : asked_(asked) {}

  [[nodiscard]] std::uint64_t number(const char* key) const {
    return asked_[key].cast<std::uint64_t>();
  }
  [[nodiscard]] std::vector<Kind> kinds() const {
    return kinds_of(asked_["kind"].cast<std::optional<std::string>>());
  }
  [[nodiscard]] std::vector<Parameters> of_each_kind() const {
    return each_of<Parameters>(kinds(), [&](const Kind kind) {
      return parameters(number("v"), number("k"), number("change"), kind, number("strength"));
    });
  }

 private:
  const py::kwargs& asked_;
};

std::string table(const Question& asked) {
  const std::vector<Kind> kinds = asked.kinds();
  const CellRange range{.v_from = asked.number("v_from"),
                        .v_to = asked.number("v_to"),
                        .k_from = asked.number("k_from"),
                        .k_to = asked.number("k_to"),
                        .change = asked.number("change"),
                        .kind = kinds.size() == 1 ? std::optional(kinds.front()) : std::nullopt};
  if (range.k_from < 2 || range.k_to < range.k_from || range.v_from < 2 ||
      range.v_to < range.v_from || range.v_to > largest_v_of_a_range || range.change < 1) {
    throw BadInput("a table has 2 <= k, 2 <= v <= 1000 and a change of 1 or more");
  }
  return stoppable([&] {
    const BestKnownTable known = best_known_table(Registry::standard(), range);
    Cells cells;
    for (const KnownCell& cell : known.cells()) {
      cells.push_back(&cell);
    }
    return table_json(cells, CellKeys::with_reason);
  });
}

std::string known(const std::string& about, const py::kwargs& words) {
  const Question asked(words);
  if (about == "constructions") {
    return constructions_json();
  }
  if (about == "table") {
    return table(asked);
  }
  const std::vector<Parameters> cells = asked.of_each_kind();
  return stoppable([&]() -> std::string {
    if (about == "bounds" || about.starts_with("bounds in LaTeX")) {
      const std::vector<KnownBounds> all =
          each_of<KnownBounds>(cells, [](const Parameters& p) { return known_bounds(p); });
      return about == "bounds"            ? bounds_json(best_of(all))
             : about.ends_with(", cited") ? bounds_latex(best_of(all))
                                          : bounds_latex(best_of(all), Citations::written);
    }
    const auto offer = best_offer(Registry::standard(), cells);
    if (!offer) {
      return "null";
    }
    JsonWriter json;
    write_tree(offer->recipe, json);
    return json.take();
  });
}

}  // namespace

void bind_known(py::module_& module) { module.def("known", &known); }

}  // namespace changeover::python
