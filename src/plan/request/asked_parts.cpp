#include "plan/request/asked_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/words.hpp"
#include "plan/request/asked_slots.hpp"
#include "plan/request/values_left.hpp"
#include "plan/request/whole_question.hpp"
#include "plan/sheet/clock.hpp"

namespace changeover {

Block AskedParts::called(std::string_view key, const std::vector<std::string>& words) const {
  return question_.value_of(key, [&] {
    return all_values_ ? parts_named(words, *all_values_) : parts_named(words, names_);
  });
}

void AskedParts::take_parts() {
  whole_ = *question_;
  if (question_->model.is_given()) {
    take_model();
    return;
  }
  const Amount test = *question_.amount("test_cost", question_->test_cost);
  const auto change = question_.amount("change_cost", question_->change_cost);
  if (question_->items) {
    take_number(test, change.value_or(Amount{}));
  } else {
    take_list(test, change);
  }
}

void AskedParts::take_parts_left(const std::vector<std::string>& names) {
  names_ = names;
  const Block without = called("without", question_->without);
  left_ = PartsLeft(names_.size(), without);
  if (without.empty()) {
    return;
  }
  if (left_.size() < 2) {
    question_.refuse("without",
                     fmt::format("{}: {} left; a pair needs two", question_.key("without"),
                                 left_.size() == 1 ? "one part is" : "no part is"));
  }
  notes_.push_back(fmt::format("without: left out from now on: {}", parts_text(without, names_)));
}

void AskedParts::take_number(Amount test, Amount change) {
  const JobRequest& asked = *question_;
  job_ = question_.value_of("items", [&] {
    Job job = make_job(*asked.items, asked.at_once.value_or(0), test, change);
    if (job.parts() < 2) {
      throw BadInput("a pair needs two parts; give 2 or more");
    }
    return job;
  });
  take_parts_left(job_.names);
  if (!left_.all()) {
    job_.names = left_(job_.names);
    job_.change_costs = left_(job_.change_costs);
    job_.needed = left_(job_.needed);
    job_.never = left_(job_.never);
    whole_.items.reset();
    PartList list;
    list.names = job_.names;
    list.change_costs.assign(job_.change_costs.begin(), job_.change_costs.end());
    whole_.parts = part_rows(list, job_);
  }
  take_unit(CostUnit::none);
}

void AskedParts::take_list(Amount test, std::optional<Amount> change) {
  const JobRequest& asked = *question_;
  std::vector<Slot> slots = slots_asked(question_);
  PartListOptions options{.header = asked.header      ? Header::given
                                    : asked.no_header ? Header::none
                                                      : Header::guessed,
                          .cost_column = asked.cost_column};
  std::ranges::transform(slots, std::back_inserter(options.slots), &Slot::name);
  options.costs_may_lack = change || asked.change_costs.is_given();
  const auto input = question_.open("parts", asked.parts);
  PartList list = read_parts(*input, options);
  if (list.names.size() < 2) {
    throw BadInput(fmt::format("{}: one part is listed; a pair needs two", input->name()));
  }
  take_parts_left(list.names);
  list.names = left_(list.names);
  list.change_costs = left_(list.change_costs);
  list.slots = left_(list.slots);
  list.quantities = left_(list.quantities);
  job_ = make_job(list.names.size(), asked.at_once.value_or(0), test, change.value_or(Amount{}));
  for (std::size_t i = 0; i < list.names.size(); ++i) {
    if (list.change_costs[i]) {
      job_.change_costs[i] = *list.change_costs[i];
    } else if (!change && !asked.change_costs.is_given()) {
      question_.refuse(
          "change_cost",
          fmt::format("{} has no change cost in the list; give {} for parts without one",
                      list.names[i], question_.with_value("change_cost")));
    }
  }
  job_.names = list.names;
  if (!list.note.empty()) {
    notes_.push_back(list.note);
  }
  take_unit(list.unit);
  take_slots(list.slots, std::move(slots), input->name());
  quantities_ = list.quantities;
  whole_.parts = part_rows(list, job_);
}

void AskedParts::take_unit(CostUnit said) {
  const std::string& word = question_->cost_unit;
  constexpr std::array units{CostUnit::seconds, CostUnit::minutes, CostUnit::hours};
  job_.cost_unit = word.empty() ? said : CostUnit::none;
  for (const CostUnit unit : units) {
    job_.cost_unit = word == word_of(unit) ? unit : job_.cost_unit;
  }
  if (word.empty() && said != CostUnit::none) {
    notes_.push_back(fmt::format(
        "costs are {}, by the list: so is that of a test, and a clock runs along", word_of(said)));
    whole_.cost_unit = word_of(said);
  }
}

void AskedParts::take_model() {
  const JobRequest& asked = *question_;
  const auto input = question_.open("model", asked.model);
  whole_.model = {};
  whole_.model.text = text_of_model(*input);
  Model model = read_model(*input_from_text(*whole_.model.text, input->name()));
  check_relations(model, question_->strength.value_or(2));
  for (std::string& note : model.notes) {
    notes_.push_back(std::move(note));
  }
  model.notes.clear();
  const bool free = asked.objective == "tests";
  const auto test = question_.amount("test_cost", asked.test_cost);
  const auto change = question_.amount("change_cost", asked.change_cost);
  const bool counts = free && asked.change_cost.empty() && !asked.change_costs.is_given();
  job_ = job_of(std::move(model), test.value_or(Amount{}),
                change.value_or(counts ? parse_amount("1") : Amount{}));
  take_unit(CostUnit::none);
  all_values_ = job_;
  take_parts_left(job_.names);
  if (asked.change_costs.is_given()) {
    const auto costs = question_.open("change_costs", asked.change_costs);
    const std::vector<bool> given = read_value_costs(*costs, job_);
    for (Element x = 0; x < given.size() && !change; ++x) {
      if (!given[x] && !left_(Block{x}).empty()) {
        question_.refuse(
            "change_cost",
            fmt::format("{} has no cost in {}; give {} for values without one", job_.names[x],
                        costs->name(), question_.with_value("change_cost")));
      }
    }
  }
  if (!left_.all()) {
    job_ = question_.value_of("without", [&] { return values_left(job_, left_); });
  }
}

void AskedParts::take_slots(const std::vector<std::string>& of_parts, std::vector<Slot> slots,
                            const std::string& name) {
  if (slots.empty()) {
    if (!of_parts.empty()) {
      question_.refuse(
          "slots",
          fmt::format("{} has a column slot; give {} or {}, as in {} CPU=1,disk=2..4, or rename "
                      "the column",
                      name, question_.with_value("slots"), question_.key("slot"),
                      question_.key("slot")));
    }
    return;
  }
  set_slots(job_, of_parts, std::move(slots));
  whole_.slots = slot_rows(job_.slots);
  whole_.slot.clear();
}

void AskedParts::take_pieces() {
  if (job_.model != nullptr || quantities_.empty()) {
    return;
  }
  const std::uint64_t added = add_pieces(job_, quantities_);
  if (added == 0) {
    return;
  }
  names_.insert(names_.end(), job_.names.end() - static_cast<std::ptrdiff_t>(added),
                job_.names.end());
  left_.add(added);
  notes_.push_back(fmt::format(
      "{} may fill slots that need several: {}; what is tested with one piece of a part is tested",
      count_of(added, "further piece"), first_names(job_.names, quantities_.size())));
}

}  // namespace changeover
