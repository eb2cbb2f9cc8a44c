#include "plan/request/workbook/changed_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <ranges>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_rows.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/model/model_names.hpp"
#include "plan/model/model_text.hpp"
#include "plan/request/parts_left.hpp"

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

// Leaves out of the lists of a question whose job was `before` what names values or parameters that
// the model has no more; returns their names. All others get their full names, "OS: Debian", which
// mean the same in both models.
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

// Without its pairs a question would be about nothing, or about all pairs.
void refuse_lost_pairs(const JobRequest& question, const JobRequest& fitted,
                       const std::string& book) {
  const auto has_rows = [](const RequestList& list) { return list.rows && !list.rows->empty(); };
  if (has_rows(question.pairs) && !has_rows(fitted.pairs)) {
    throw BadInput(fmt::format(
        "{}: each of the pairs that were to be tested, as {}, has a value that is no longer in the "
        "model; list other pairs",
        book, joined(question.pairs.rows->front().fields | std::views::take(2), shown)));
  }
}

}  // namespace

void take_other_model(JobRequest& request, JobRequest& question, const std::string& book,
                      bool has_costs_of_book, std::vector<std::string>& notes) {
  const auto opened = [](const RequestList& list) {
    return open(list, option_of(job_table(), "model").record, "model");
  };
  if (!request.model.file.empty()) {  // its text stays: a pipe can be read only once
    const auto input = opened(request.model);
    request.model = {.text = text_of_model(*input), .name = input->name()};
  }
  const Model model = read_model(*opened(request.model));
  const Job before = job_of(read_model(*opened(question.model)), Amount{}, Amount{});  // all values
  JobRequest lists = question;
  if (has_costs_of_book && request.change_costs.rows) {
    lists.change_costs = request.change_costs;
  }
  const std::vector<std::string> gone = fit_to_model(lists, before, model);
  if (!request.pairs.is_given()) {
    refuse_lost_pairs(question, lists, book);
  }
  if (has_costs_of_book && request.change_costs.rows) {
    request.change_costs = lists.change_costs;
  }
  question = std::move(lists);
  if (!gone.empty()) {
    notes.push_back(gone_note(book, gone, GoneFrom::model));
  }
}

}  // namespace changeover
