// From a request to a job.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/model.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/place.hpp"
#include "plan/request/done_tests.hpp"
#include "plan/request/whole_question.hpp"
#include "plan/request/workbook_question.hpp"
#include "plan/sheet/clock.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t triples = 3;  // the strength that asks for them

// A request with the words of the door that it came through.
class Question {
 public:
  Question(const JobRequest& request, Door door) : request_(request), door_(door) {}

  [[nodiscard]] const JobRequest& operator*() const { return request_; }
  [[nodiscard]] const JobRequest* operator->() const { return &request_; }

  // "--at-once", "at_once".
  [[nodiscard]] std::string key(std::string_view key) const {
    return spelled(option_of(job_table(), key).record, door_);
  }
  // "--at-once K", "at_once".
  [[nodiscard]] std::string with_value(std::string_view key) const {
    const OptionRecord& record = option_of(job_table(), key).record;
    return door_ == Door::command_line ? fmt::format("{} {}", this->key(key), record.value)
                                       : this->key(key);
  }
  // A list that is no file stands in a document, at every door, and notes on it are the same at all
  // of them.
  [[nodiscard]] std::unique_ptr<Input> open(std::string_view key, const RequestList& list) const {
    return changeover::open(list, option_of(job_table(), key).record, std::string(key));
  }
  [[nodiscard]] bool has_file() const {
    return std::ranges::any_of(job_table().options, [&](const auto& option) {
      const auto* const field = std::get_if<RequestList JobRequest::*>(&option.field);
      return field != nullptr && !(request_.**field).file.empty();
    });
  }

  // What is wrong with the value of a key is the key's fault.
  template <typename Read>
  auto value_of(std::string_view key, Read&& read) const {
    try {
      return read();
    } catch (const BadOption&) {
      throw;
    } catch (const BadInput& fault) {
      throw BadOption(fmt::format("{}: {}", this->key(key), fault.what()));
    } catch (const ImpossibleParameters& fault) {
      throw BadOption(fmt::format("{}: {}", this->key(key), fault.what()));
    }
  }
  [[nodiscard]] std::optional<Amount> amount(std::string_view key, const std::string& text) const {
    return text.empty() ? std::nullopt
                        : std::optional(value_of(key, [&] { return parse_amount(text); }));
  }
  [[nodiscard]] Door door() const { return door_; }

 private:
  const JobRequest& request_;
  Door door_;
};

}  // namespace

// Makes a checked job step by step.
class JobMaker {
 public:
  JobMaker(const JobRequest& request, Door door) : question_(request, door) {}

  AskedJob make() {
    whole_ = *question_;
    take_parts();
    take_constraints();
    take_needs();
    take_first_and_weights();
    check(job_);
    finish_question();
    AskedJob asked;
    if (question_->done.is_given()) {
      asked = done_of_job();
    }
    asked.job.job_ = std::move(job_);
    notes_.insert(notes_.end(), asked.notes.begin(), asked.notes.end());
    asked.notes = std::move(notes_);
    asked.question = std::move(whole_);
    return asked;
  }

 private:
  // The parts and what they cost.
  void take_parts() {
    const JobRequest& asked = *question_;
    if (asked.model.is_given()) {
      take_model();
      return;
    }
    const Amount test = *question_.amount("test_cost", asked.test_cost);
    const auto change = question_.amount("change_cost", asked.change_cost);
    if (asked.items) {
      job_ = question_.value_of("items", [&] {
        Job job =
            make_job(*asked.items, asked.at_once.value_or(0), test, change.value_or(Amount{}));
        if (job.parts() < 2) {
          throw BadInput("a pair needs two parts");
        }
        return job;
      });
      take_unit(CostUnit::none);
      return;
    }
    std::vector<Slot> slots = slots_asked();
    PartListOptions options{.header = asked.header      ? Header::given
                                      : asked.no_header ? Header::none
                                                        : Header::guessed,
                            .cost_column = asked.cost_column};
    std::ranges::transform(slots, std::back_inserter(options.slots), &Slot::name);
    const auto input = question_.open("parts", asked.parts);
    const PartList list = read_parts(*input, options);
    job_ = make_job(list.names.size(), asked.at_once.value_or(0), test, change.value_or(Amount{}));
    for (std::size_t i = 0; i < list.names.size(); ++i) {
      if (list.change_costs[i]) {
        job_.change_costs[i] = *list.change_costs[i];
      } else if (!change && !asked.change_costs.is_given()) {
        throw BadOption(
            fmt::format("{} has no change cost in the list; give {} for parts without one",
                        list.names[i], question_.with_value("change_cost")));
      }
    }
    if (list.names.size() < 2) {
      throw BadInput(fmt::format("{}: one part is listed; a pair needs two", input->name()));
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

  // What costs are: as is asked, or as the list says.
  void take_unit(CostUnit said) {
    const std::string& word = question_->cost_unit;
    constexpr std::array units{CostUnit::seconds, CostUnit::minutes, CostUnit::hours};
    job_.cost_unit = word.empty() ? said : CostUnit::none;
    for (const CostUnit unit : units) {
      job_.cost_unit = word == word_of(unit) ? unit : job_.cost_unit;
    }
    if (word.empty() && said != CostUnit::none) {
      notes_.push_back(
          fmt::format("costs are {}, by the list: so is that of a test, and a clock runs along",
                      word_of(said)));
      whole_.cost_unit = word_of(said);
    }
  }

  // The values of a model and what they cost. Where the fewest tests are asked for and no costs are
  // given, changes are counted.
  void take_model() {
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
    if (!asked.change_costs.is_given()) {
      return;
    }
    const auto costs = question_.open("change_costs", asked.change_costs);
    const std::vector<bool> given = read_value_costs(*costs, job_);
    const auto without = std::ranges::find(given, false);
    if (!change && without != given.end()) {
      throw BadOption(fmt::format("{} has no cost in {}; give {} for values without one",
                                  job_.names[static_cast<std::size_t>(without - given.begin())],
                                  costs->name(), question_.with_value("change_cost")));
    }
  }

  [[nodiscard]] std::vector<Slot> slots_asked() const {
    const JobRequest& asked = *question_;
    if (asked.slots.is_given()) {
      return read_slots(*question_.open("slots", asked.slots));
    }
    return asked.slot.empty() ? std::vector<Slot>()
                              : question_.value_of("slot", [&] { return parse_slots(asked.slot); });
  }

  void take_slots(const std::vector<std::string>& of_parts, std::vector<Slot> slots,
                  const std::string& name) {
    if (slots.empty()) {
      if (!of_parts.empty()) {
        throw BadOption(fmt::format(
            "{} has a column slot; give {} or {}, as in {} CPU=1,disk=2..4, or rename "
            "the column",
            name, question_.with_value("slots"), question_.key("slot"), question_.key("slot")));
      }
      return;
    }
    set_slots(job_, of_parts, std::move(slots));
    whole_.slots = slot_rows(job_.slots);
    whole_.slot.clear();
  }

  // Pieces of parts that a set-up may need several of, and how many parts fit if only the slots say
  // so.
  void take_pieces_and_room() {
    if (job_.model != nullptr) {
      return;
    }
    if (!quantities_.empty()) {
      if (const std::uint64_t added = add_pieces(job_, quantities_)) {
        notes_.push_back(fmt::format(
            "{} may fill slots that need several: {}; what is tested with one piece of a part is "
            "tested",
            count_of(added, "further piece"), examples_of_pieces()));
      }
    }
    if (!question_->at_once) {
      job_.at_once = room_of_slots();
      whole_.at_once = job_.at_once;
      notes_.push_back(
          fmt::format("{} fit at once, as many as the slots hold", count_of(job_.at_once, "part")));
    }
    const std::string key = question_.key("at_once");
    const bool of_triples = question_->strength == triples;
    if (job_.at_once < 2 || (of_triples && job_.at_once < triples)) {
      throw BadOption(fmt::format("{} {}: no {} can meet; give at least {}", key, job_.at_once,
                                  of_triples ? "triple" : "pair", of_triples ? triples : 2));
    }
  }

  [[nodiscard]] std::string examples_of_pieces() const {
    constexpr std::size_t few = 3;
    const auto first = job_.names.begin() + static_cast<std::ptrdiff_t>(quantities_.size());
    std::string names;
    for (auto name = first; name != job_.names.end() && name - first < std::ptrdiff_t{few};
         ++name) {
      names += (names.empty() ? "" : ", ") + *name;
    }
    return names + (job_.names.end() - first > std::ptrdiff_t{few} ? ", …" : "");
  }

  // The most parts that the slots hold together: of a slot without a limit, all of its parts.
  [[nodiscard]] std::uint64_t room_of_slots() const {
    const std::string give =
        fmt::format("give {}, how many parts fit at once", question_.with_value("at_once"));
    if (job_.slots.empty()) {
      throw BadOption(give);
    }
    std::uint64_t room = 0;
    for (std::size_t s = 0; s < job_.slots.size(); ++s) {
      const auto members =
          static_cast<std::uint64_t>(std::ranges::count(job_.slot_of, std::uint32_t(s)));
      room += std::min(job_.slots[s].most, members);
    }
    const auto free = std::ranges::find(job_.slot_of, no_slot);
    if (free != job_.slot_of.end()) {
      throw BadOption(fmt::format("{}: {} is in no slot", give,
                                  job_.names[std::size_t(free - job_.slot_of.begin())]));
    }
    return room;
  }

  // What the answer keeps of the question, so that it stands by itself.
  void finish_question() {
    whole_.header = whole_.no_header = false;
    whole_.cost_column.clear();
    whole_.done = {};
    whole_.done_first.reset();
    whole_.diagnose = whole_.what_if = false;
    if (job_.model != nullptr && question_->change_costs.is_given()) {
      whole_.change_costs = value_cost_rows(job_);
    } else if (job_.replaces()) {
      whole_.change_costs = change_cost_rows(job_);
    }
    if (question_->first.is_given()) {
      whole_.first = setup_rows(job_.first, job_);
    }
    if (question_->weights.is_given()) {
      whole_.weights = weight_rows(job_);
    }
  }

  // What cannot be at all.
  void take_constraints() {
    const JobRequest& asked = *question_;
    if (asked.change_costs.is_given() && !asked.model.is_given()) {
      job_.replace_costs =
          read_change_costs(*question_.open("change_costs", asked.change_costs), job_.names,
                            job_.slots.empty() ? std::vector<std::uint32_t>() : job_.slot_of);
    }
    if (asked.never.is_given()) {
      const auto input = question_.open("never", asked.never);
      job_.never = read_pairs(*input, job_, &job_.why_never);
      drop_needed(job_, job_.never);
      whole_.never = pair_rows(job_.never, job_, job_.why_never);
      if (!asked.pairs.is_given() && job_.needed.size() == 0) {
        throw BadInput(
            fmt::format("{}: no two parts can be in one set-up; leave out a pair", input->name()));
      }
    }
    take_pieces_and_room();
    if (asked.pairs.is_given()) {
      const auto input = question_.open("pairs", asked.pairs);
      job_.needed = read_pairs(*input, job_);
      if (job_.needed.size() == 0) {
        throw BadInput(
            fmt::format("{}: no pair is listed; write A,B, a pair a line", input->name()));
      }
      whole_.pairs = pair_rows(job_.needed, job_);
    }
    job_.mounted = question_.value_of("mounted", [&] { return parts_named(asked.mounted, job_); });
    job_.start = question_.value_of("start", [&] { return parts_named(asked.start, job_); });
    Job any = job_;
    any.needed = PairSet(job_.parts());
    check(any);
  }

  // Pairs and triples that cannot meet need not, and this is said.
  void take_needs() {
    if (question_->strength == triples) {
      const std::uint64_t apart = need_triples(job_);
      if (job_.triples.empty()) {
        throw BadInput(job_.parts() < triples
                           ? "a triple needs three parts"
                           : "no three parts can be in one set-up, for the slots, forbidden pairs "
                             "or what stays mounted");
      }
      if (apart > 0) {
        notes_.push_back(fmt::format(
            "{} cannot meet, for slots, forbidden pairs or what stays mounted, and need not",
            count_of(apart, "triple")));
      }
    } else if (!question_->pairs.is_given() && !job_.slots.empty()) {
      leave_out(cannot_meet(job_));
    }
  }

  void leave_out(const PairSet& apart) {
    if (apart.size() == 0) {
      return;
    }
    if (apart.size() == job_.needed.size()) {
      throw BadInput(
          job_.model != nullptr
              ? "no two values can be in one test; leave out a rule or a pair"
              : fmt::format("no two parts can be in one set-up within the slots; let a slot hold "
                            "more parts, or raise {}",
                            question_.key("at_once")));
    }
    constexpr std::uint64_t few = 3;
    std::string examples;
    apart.for_each(few, [&](Element x, Element y) {
      examples += fmt::format("{}{} and {}", examples.empty() ? "" : "; ",
                              job_.names[std::min(x, y)], job_.names[std::max(x, y)]);
    });
    drop_needed(job_, apart);
    notes_.push_back(fmt::format(
        "{} {} and need not: {}{}", count_of(apart.size(), "pair"),
        job_.model == nullptr ? "cannot meet within the slots" : "cannot meet, by the rules,",
        examples, apart.size() > few ? "; …" : ""));
  }

  void take_first_and_weights() {
    if (question_->first.is_given()) {
      const auto input = question_.open("first", question_->first);
      job_.first = read_first(*input, job_);
      first_tests_ = input->name();
    }
    if (question_->weights.is_given()) {
      take_weights();
    }
  }

  // A weight of a pair that need not meet says nothing.
  void take_weights() {
    const auto input = question_.open("weights", question_->weights);
    job_.weights = read_priorities(*input, job_.names);
    try {
      Amount all;
      job_.needed.for_each(~std::uint64_t{0},
                           [&](Element x, Element y) { all += job_.weights(x, y); });
    } catch (const ImpossibleParameters&) {
      throw BadInput(
          fmt::format("{}: the weights together exceed 9.2e12; divide all of them", input->name()));
    }
    std::uint64_t without_need = 0;
    all_pairs_but(job_.needed).for_each(~std::uint64_t{0}, [&](Element x, Element y) {
      without_need += job_.weights.weighs(x, y) ? 1U : 0U;
    });
    if (without_need > 0) {
      notes_.push_back(fmt::format("{}: {} need not meet, and {} not count", input->name(),
                                   count_of(without_need, "pair"),
                                   without_need == 1 ? "its weight does" : "their weights do"));
    }
  }

  AskedJob done_of_job() {
    const JobRequest& asked = *question_;
    const auto inputs = open_done(asked.done, "done");
    DoneWords words{.done_first = question_.key("done_first"),
                    .trust_failed = question_.key("trust_failed"),
                    .first_tests = first_tests_};
    return take_done(inputs,
                     {.first = asked.done_first,
                      .failed = asked.trust_failed ? FailedTests::trusted : FailedTests::again,
                      .for_diagnosis = asked.diagnose,
                      .all_parts_known = asked.done.rows.has_value()},
                     words, job_);
  }

  Question question_;
  JobRequest whole_;  // the question with its lists as rows
  Job job_;
  std::vector<std::uint64_t> quantities_;  // of the parts of the list, if it says so
  std::vector<std::string> notes_;
  std::string first_tests_;
};

namespace {

// What the objective and a model ask of costs.
void check_objective(const JobRequest& request, const Question& question) {
  const bool of_model = request.model.is_given();
  if (of_model ? request.objective == "makespan" : request.objective == "tests") {
    throw BadOption(fmt::format("{} {} is for {}", question.key("objective"), request.objective,
                                of_model ? "several benches" : "a model"));
  }
  if (!of_model || request.objective == "tests") {
    return;
  }
  if (request.test_cost.empty()) {
    throw BadOption(
        fmt::format("give {}, what it costs to run one test; or {} tests, which asks for no costs",
                    question.with_value("test_cost"), question.key("objective")));
  }
  if (request.change_cost.empty() && !request.change_costs.is_given()) {
    throw BadOption(fmt::format(
        "give {}, what it costs to set a value, or {} for each; or {} tests, which asks "
        "for no costs",
        question.with_value("change_cost"), question.with_value("change_costs"),
        question.key("objective")));
  }
}

}  // namespace

void check_options(const JobRequest& request, Door door) {
  const Question question(request, door);
  const auto refuse = [](const std::string& line) { throw BadOption(line); };
  const auto key = [&](std::string_view name) { return question.key(name); };
  if (!request.model.is_given() && request.parts.is_given() == request.items.has_value()) {
    refuse(door == Door::command_line ? "give either a parts list or --items N"
           : request.items            ? "give either parts or items, not both"
                           : "parts is missing: write a number of parts, or an array of them");
  }
  check_rules(job_table(), request, door);
  if (request.benches && (*request.benches < 1 || *request.benches > max_benches)) {
    refuse(fmt::format("{} {}: give a number from 1 to {}", key("benches"), *request.benches,
                       max_benches));
  }
  const bool of_triples = request.strength == triples;
  if (request.strength.value_or(2) != 2 && !of_triples) {
    refuse(fmt::format("{} {}: give 2, for pairs, or 3, for triples", key("strength"),
                       *request.strength));
  }
  const std::vector<std::pair<std::string_view, bool>> of_pairs{
      {"pairs", request.pairs.is_given()},
      {"weights", request.weights.is_given()},
      {"shuffle", request.shuffle.has_value()},
      {"what_if", request.what_if},
      {"diagnose", request.diagnose}};
  for (const auto& [name, given] : of_pairs) {
    if (of_triples && given) {
      refuse(
          fmt::format("{} is of pairs; it has no meaning with {} 3", key(name), key("strength")));
    }
  }
  if (const auto defect = text_defect(request.title)) {
    refuse(fmt::format("{}: {}", key("title"), *defect));
  }
  check_objective(request, question);
  if (request.model.is_given()) {
    static_cast<void>(question.amount("test_cost", request.test_cost));
    static_cast<void>(question.amount("change_cost", request.change_cost));
    static_cast<void>(question.amount("budget", request.budget));
    return;
  }
  const std::uint64_t least = of_triples ? triples : 2;
  if (request.at_once.value_or(least) < least) {
    refuse(fmt::format("{} {}: no {} can meet; give at least {}", key("at_once"), *request.at_once,
                       of_triples ? "triple" : "pair", least));
  }
  if (request.test_cost.empty()) {
    refuse(fmt::format("give {}, what it costs to run one test", question.with_value("test_cost")));
  }
  static_cast<void>(question.amount("test_cost", request.test_cost));
  static_cast<void>(question.amount("change_cost", request.change_cost));
  static_cast<void>(question.amount("budget", request.budget));
  if (!request.items) {
    return;
  }
  if (request.slots.is_given() || !request.slot.empty()) {
    refuse(fmt::format("{} and {} are for a parts list with a column slot, not for {}",
                       key("slots"), key("slot"), key("items")));
  }
  if (request.header || request.no_header) {
    refuse(fmt::format("{} and {} are for a parts list, not for {}", key("header"),
                       key("no_header"), key("items")));
  }
  if (!request.cost_column.empty()) {
    refuse(fmt::format("{} is for a parts list, not for {}", key("cost_column"), key("items")));
  }
  if (request.change_cost.empty() && !request.change_costs.is_given()) {
    refuse(
        fmt::format("give {}, what it costs to mount a part", question.with_value("change_cost")));
  }
}

AskedJob checked_job(const JobRequest& request, Door door) {
  check_options(request, door);
  if (Question(request, door).has_file()) {
    return JobMaker(request, door).make();
  }
  // Where no file says anything, the options are wrong.
  try {
    return JobMaker(request, door).make();
  } catch (const BadOption&) {
    throw;
  } catch (const BadInput& fault) {
    throw BadOption(fault.what());
  }
}

AskedJob checked_job(const OpenedRequest& opened, Door door) {
  AskedJob asked = checked_job(opened.request, door);
  asked.notes.insert(asked.notes.begin(), opened.notes.begin(), opened.notes.end());
  return asked;
}

}  // namespace changeover
