#include "plan/request/values_left.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/printable.hpp"

namespace changeover {

Job values_left(const Job& all, const PartsLeft& left) {
  Model model = *all.model;
  Element next = 0;
  for (ModelParameter& parameter : model.parameters) {
    std::vector<ModelValue> values;
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      if (!left(Block{static_cast<Element>(parameter.first + i)}).empty()) {
        values.push_back(std::move(parameter.values[i]));
      }
    }
    if (values.empty()) {
      throw BadInput(fmt::format("no value of {} is left; leave one", shown(parameter.name)));
    }
    parameter.values = std::move(values);
    parameter.first = next;
    next += static_cast<Element>(parameter.values.size());
  }
  Job job = job_of(std::move(model), all.test_cost, Amount{});
  // A name that has its parameter keeps it: lists of the whole model have it, too.
  job.names = left(all.names);
  job.change_costs = left(all.change_costs);
  if (all.replaces()) {
    job.replace_costs = left.square(all.replace_costs);
  }
  job.quantities = all.quantities.empty() ? all.quantities : left(all.quantities);
  job.cost_unit = all.cost_unit;
  return job;
}

}  // namespace changeover
