// Any bytes as the label of a cell or of a design.
#include "changeover/catalog/entry.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::label_fuzz {
namespace {

const Target target("label", [](const std::string& bytes) {
  if (const auto cell = parse_cell_label(bytes)) {
    must(cell_label(*cell) == bytes, "a cell has one label");
    check(*cell);
  }
  if (const auto label = parse_design_label(bytes)) {
    must(label->digits.size() == label_digits, "a label has eight digits");
    check(label->parameters);
    must(cell_label(label->parameters) + "." + std::to_string(label->b) + "." + label->digits ==
             bytes,
         "a design has one label");
  }
});

}  // namespace
}  // namespace changeover::fuzz::label_fuzz
