// What run sheets of a model have as JSON, for one bench and for several.
#pragma once

#include <cstddef>
#include <optional>

#include "changeover/plan/model.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/shown_values.hpp"

namespace changeover {

/// The parameters of a model with the part of each value, and the number of its rules.
inline void write_model(JsonWriter& json, const Job& job) {
  json.objects("parameters", job.model->parameters, [&](const ModelParameter& parameter) {
    Element part = parameter.first;
    json.key("name").value(parameter.name);
    json.objects("values", parameter.values, [&](const ModelValue& value) {
      json.key("value").value(value.label).key("part").value(job.names[part++]);
      json.key("names").value(value.names).key("out_of_range").value(value.negative);
    });
  });
  json.key("rules").value(job.model->constraints.size());
}

/// The values of the steps of a sheet; nothing for other jobs. The job must outlive it.
class ValuesInJson {
 public:
  ValuesInJson(const Job& job, const RunSheet& sheet) : job_(&job) {
    if (job.model != nullptr) {
      shown_.emplace(job, sheet);
    }
  }

  void write(JsonWriter& json, std::size_t at) const {
    if (shown_) {
      json.key("values").begin_object();
      for (std::size_t p = 0; p < job_->model->parameters.size(); ++p) {
        json.key(job_->model->parameters[p].name).value(shown_->value(at, p));
      }
      json.end_object();
    }
  }

 private:
  const Job* job_;
  std::optional<ShownValues> shown_;
};

}  // namespace changeover
