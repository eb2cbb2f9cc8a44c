#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"

namespace changeover::python {

Kind kind_of(const std::string& word) {
  if (const auto kind = kind_from_string(word)) {
    return *kind;
  }
  throw BadInput("kind is 'linear' or 'circular', not '" + word + "'");
}

std::vector<Kind> kinds_of(const std::optional<std::string>& word) {
  return word ? std::vector<Kind>{kind_of(*word)} : std::vector<Kind>{Kind::circular, Kind::linear};
}

py::object from_json(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

py::dict as_dict(const Recipe& recipe) { return from_json(recipe_to_json(recipe)); }

HeldDesign held(VerifiedDesign design) {
  Verdict verdict = design.verdict();
  return {std::make_shared<const Design>(std::move(design).take()), std::move(verdict)};
}

}  // namespace changeover::python
