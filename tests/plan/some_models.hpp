// Models of parameters from texts, and all of their rows.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/model.hpp"

namespace changeover::test {

inline Model model_of(const std::string& text, const std::string& name = "m.txt") {
  return read_model(*input_from_text(text, name));
}

/// A job at these costs in which all that can meet must.
inline Job job_of_text(const std::string& text, const std::string& test_cost = "1",
                       const std::string& change_cost = "1") {
  Job job = job_of(model_of(text), parse_amount(test_cost), parse_amount(change_cost));
  drop_needed(job, cannot_meet(job));
  return job;
}

/// Every choice of one value of each parameter, whatever the rules say.
inline std::vector<Block> all_choices(const Model& model) {
  std::vector<Block> rows{{}};
  for (const ModelParameter& parameter : model.parameters) {
    std::vector<Block> longer;
    for (const Block& row : rows) {
      for (std::size_t i = 0; i < parameter.values.size(); ++i) {
        longer.push_back(row);
        longer.back().push_back(parameter.first + static_cast<Element>(i));
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

/// Those that are tests.
inline std::vector<Block> all_tests(const Model& model) {
  std::vector<Block> rows;
  for (Block& row : all_choices(model)) {
    if (follows(model, row)) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// Whether a test shows what two of its values do together: it does not stop at another one that is
/// out of range.
inline bool shows(const Model& model, const Block& test, Element x, Element y) {
  bool has_x = false;
  bool has_y = false;
  bool hidden = false;
  for (const Element z : test) {
    has_x = has_x || z == x;
    has_y = has_y || z == y;
    hidden = hidden || (model.value(z).negative && z != x && z != y);
  }
  return has_x && has_y && !hidden;
}

}  // namespace changeover::test
