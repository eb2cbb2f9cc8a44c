#include "plan/request/workbook/changed_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "changeover/plan/model.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "io/request/request_rows.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/model/model_names.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

class ModelChange {
 public:
  ModelChange(const Job& before, const Model& now)
      : before_(before), model_(before.model.get()), now_(now) {}

  [[nodiscard]] std::vector<std::string> gone() && { return std::move(gone_); }

  // The full name of a value; nothing if it is gone. A word that was none stays as it is.
  std::optional<std::string> value(const std::string& word) {
    const auto part = before_.find(word);
    if (!part) {
      return word;
    }
    const ModelParameter& parameter = model_->parameters[model_->parameter_of(*part)];
    const std::string& label = model_->value(*part).label;
    const std::string name = fmt::format("{}: {}", parameter.name, label);
    const auto still = now_.parameter(parameter.name);
    return still && now_.value(*still, label) ? std::optional(name) : lost(name);
  }

  void fit_names(std::vector<std::string>& words) {
    std::vector<std::string> kept;
    for (const std::string& word : words) {
      if (auto name = value(word)) {
        kept.push_back(*std::move(name));
      }
    }
    words = std::move(kept);
  }

  // Rows of two values, and what is said of them.
  void fit_pairs(RequestList& list) {
    std::erase_if(*list.rows, [&](ListRow& row) {
      bool is_gone = false;
      for (std::size_t i = 0; i < std::min<std::size_t>(row.fields.size(), 2); ++i) {
        auto name = value(row.fields[i]);
        is_gone = is_gone || !name;
        row.fields[i] = std::move(name).value_or("");
      }
      return is_gone;
    });
  }

  // Rows of a parameter, up to two of its values or a word, and what these cost.
  void fit_costs(RequestList& list) {
    std::erase_if(*list.rows, [&](const ListRow& row) {
      const std::string& parameter = row.fields.front();
      const auto known = model_names().parameter(parameter);
      if (!known) {
        return false;
      }
      const auto still = now_.parameter(parameter);
      if (!still) {
        static_cast<void>(lost(model_->parameters[*known].name));
        return true;
      }
      for (std::size_t i = 1; i + 1 < row.fields.size(); ++i) {
        if (model_names().value(*known, row.fields[i]) && !now_.value(*still, row.fields[i])) {
          static_cast<void>(lost(fmt::format("{}: {}", parameter, row.fields[i])));
          return true;
        }
      }
      return false;
    });
  }

  void fit_benches(RequestList& list) {
    const std::vector<std::string_view>& keys = row_keys(RowShape::benches);
    for (ListRow& row : *list.rows) {
      for (std::size_t c = 0; c < std::min(keys.size(), row.fields.size()); ++c) {
        constexpr std::array<std::string_view, 4> of_parts{"mounted", "start", "own", "without"};
        std::string& field = row.fields[c];
        if (!contains(of_parts, keys[c]) || field.empty()) {
          continue;
        }
        auto words = each_of<std::string>(split_row(field), &Field::text);
        std::erase(words, "");
        fit_names(words);
        field = joined(words, quoted_field);
        if (field.empty() && (keys[c] == "mounted" || keys[c] == "start")) {
          field = ",";  // none at all, which is not what all benches have
        }
      }
    }
  }

 private:
  [[nodiscard]] const ModelNames& model_names() const { return *before_.model(); }

  std::optional<std::string> lost(const std::string& name) {
    if (!contains(gone_, name)) {
      gone_.push_back(name);
    }
    return std::nullopt;
  }

  PartFinder before_;
  const Model* model_;
  ModelNames now_;
  std::vector<std::string> gone_;
};

}  // namespace

std::vector<std::string> fit_to_model(JobRequest& question, const Job& before, const Model& model) {
  ModelChange change(before, model);
  for (auto* const words : {&question.mounted, &question.start, &question.without}) {
    change.fit_names(*words);
  }
  for (auto* const list : {&question.never, &question.pairs}) {
    if (list->rows) {
      change.fit_pairs(*list);
    }
  }
  if (question.never.rows && question.never.rows->empty()) {
    question.never = {};
  }
  if (question.first.rows) {
    for (ListRow& row : *question.first.rows) {
      change.fit_names(row.fields);
    }
    std::erase_if(*question.first.rows, [](const ListRow& row) { return row.fields.empty(); });
  }
  if (question.change_costs.rows) {
    change.fit_costs(question.change_costs);
  }
  if (question.benches.rows) {
    change.fit_benches(question.benches);
  }
  return std::move(change).gone();
}

}  // namespace changeover
