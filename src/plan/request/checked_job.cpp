// Converts a request to a job.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/request/asked_benches.hpp"
#include "plan/request/asked_slots.hpp"
#include "plan/request/done_tests.hpp"
#include "plan/request/first_lists.hpp"
#include "plan/request/parts_left.hpp"
#include "plan/request/question.hpp"
#include "plan/request/values_left.hpp"
#include "plan/request/whole_question.hpp"
#include "plan/request/workbook/run_workbook.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/clock.hpp"

namespace changeover {

static constexpr std::uint64_t of_triples = 3;  // the strength at which triples must meet

// Builds a checked job step by step.
class JobMaker {
 public:
  JobMaker(const JobRequest& request, Door door) : question_(request, door) {}

  ReadJob make() {
    whole_ = *question_;
    take_parts();
    take_constraints();
    take_needs();
    take_first_and_weights();
    check_job(job_);
    finish_question();
    ReadJob asked;
    if (question_->done.is_given()) {
      asked = done_of_job();
      if (asked.done.empty() && misspelled_ && question_->without.empty()) {
        throw BadInput(unknown_part_defect(misspelled_->first, misspelled_->second, names_));
      }
    }
    if (has_benches() && !question_->pairs.is_given() && job_.triples.empty()) {
      leave_out(cannot_meet(job_, benches_), "on any bench that works");
    }
    asked.job.job_ = std::move(job_);
    asked.benches = std::move(benches_);
    notes_.insert(notes_.end(), asked.notes.begin(), asked.notes.end());
    asked.notes = std::move(notes_);
    asked.question = std::move(whole_);
    return asked;
  }

 private:
  [[nodiscard]] bool has_benches() const { return question_->benches.is_given(); }

  // Reads a list that may be older than the parts list if something is done or broke: unknown names
  // are left out, with a note. Before, they are misspelled.
  template <typename Read>
  auto read_old(Input& input, Read&& read) {
    std::vector<std::string> gone;
    const bool old = question_->done.is_given() || !question_->without.empty();
    auto found = read(input, names_, old ? &gone : nullptr);
    if (!gone.empty()) {
      notes_.push_back(gone_note(input.name(), gone));
      misspelled_ = misspelled_.value_or(std::pair(input.name(), gone.front()));
    }
    return found;
  }

  // A model is not a list, and knows its values by several names.
  [[nodiscard]] Block called(std::string_view key, const std::vector<std::string>& words) const {
    return question_.value_of(key, [&] {
      return all_values_ ? parts_named(words, *all_values_) : parts_named(words, names_);
    });
  }
  [[nodiscard]] Block named(std::string_view key, const std::vector<std::string>& words) const {
    return left_(called(key, words));
  }
  // What stays mounted, but for what broke.
  Block mounted_left() {
    Block mounted = called("mounted", question_->mounted);
    const Block left = left_(mounted);
    if (left.size() < mounted.size()) {
      std::erase_if(mounted, [&](Element x) { return !left_(Block{x}).empty(); });
      notes_.push_back(fmt::format("{}: left out from now on, by {}, so not mounted: {}",
                                   question_.key("mounted"), question_.key("without"),
                                   parts_text(mounted, names_)));
    }
    return left;
  }
  PairSet pairs_of(Input& input, PairReasons* why) {
    return all_values_ ? read_pairs(input, *all_values_, why)
                       : read_old(input, [why](Input& list, const auto& names, auto* gone) {
                           return read_pairs(list, names, why, gone);
                         });
  }

  // The parts of the list that broke.
  void take_parts_left(const std::vector<std::string>& names) {
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
      return;
    }
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

  void take_benches() {
    const JobRequest& asked = *question_;
    if (!has_benches()) {
      return;
    }
    if (asked.benches.number) {
      benches_ = benches_alike(*asked.benches.number);
    } else {
      const auto input = question_.open("benches", asked.benches);
      benches_ = read_old(*input, [&](Input& list, const auto&, std::vector<std::string>* gone) {
        return listed_benches(list, {.names = &names_,
                                     .all_values = all_values_ ? &*all_values_ : nullptr,
                                     .left = &left_,
                                     .gone = all_values_ ? nullptr : gone,
                                     .notes = &notes_});
      });
      whole_.benches = bench_rows(benches_, job_);
    }
    const auto hours = question_.amount("hours", asked.hours);
    bool some_rest = false;
    for (Bench& bench : benches_) {
      bench.hours = bench.hours ? bench.hours : hours;
      some_rest = some_rest || bench.hours.has_value();
    }
    if (!asked.first_day.empty() && !some_rest) {
      question_.refuse("first_day",
                       fmt::format("{} is for benches with hours of work a day; give {} too",
                                   question_.key("first_day"), question_.with_value("hours")));
    }
  }

  // With benches, these are checked instead; pairs that cannot meet on any are dropped later, with
  // a note.
  void check_job(const Job& job) const {
    if (!has_benches()) {
      check(job);
      return;
    }
    Job any = job;
    if (!question_->pairs.is_given()) {
      any.needed = PairSet(any.parts());
      any.triples.clear();
    }
    const bool is_here = !question_->places.before("benches").empty();
    const std::string& file = question_->benches.file;
    check_benches(any, benches_, file.empty() && is_here ? "benches" : file);
    check_beside_mounted(job);
  }

  // What stays on all benches is checked as on one.
  void check_beside_mounted(const Job& job) const {
    const auto as_job = [](const Bench& bench) { return !bench.mounted && !bench.at_once; };
    const bool is_plain = job.model == nullptr && job.slots.empty() && job.triples.empty();
    if (std::ranges::all_of(benches_, as_job) && is_plain && !job.mounted.empty()) {
      Job one = job;
      one.start.clear();
      one.first.clear();
      check(one);
    }
  }

  // The unit of costs: as requested, or as in the list.
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

  // The values of a model and their costs. If the fewest tests are requested and no costs are
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

  void take_slots(const std::vector<std::string>& of_parts, std::vector<Slot> slots,
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

  // Pieces of parts that a set-up may need several of.
  void take_pieces() {
    if (job_.model != nullptr) {
      return;
    }
    if (!quantities_.empty()) {
      if (const std::uint64_t added = add_pieces(job_, quantities_)) {
        names_.insert(names_.end(), job_.names.end() - static_cast<std::ptrdiff_t>(added),
                      job_.names.end());
        left_.add(added);
        notes_.push_back(fmt::format(
            "{} may fill slots that need several: {}; what is tested with one piece of a part is "
            "tested",
            count_of(added, "further piece"), first_names(job_.names, quantities_.size())));
      }
    }
  }

  // How many parts fit; of benches that all say it themselves, most of them.
  void take_room() {
    if (job_.model != nullptr) {
      return;
    }
    const bool benches_say = has_benches() && std::ranges::all_of(benches_, [](const Bench& bench) {
                               return bench.down || bench.at_once;
                             });
    const bool is_triple = question_->strength == of_triples;
    const std::uint64_t least = is_triple ? of_triples : 2;
    if (benches_say && job_.at_once < least) {
      job_.at_once = std::max(least, most_at_once(job_, benches_));
    } else if (!question_->at_once) {
      job_.at_once = room_of_slots(job_, question_);
      whole_.at_once = job_.at_once;
      notes_.push_back(
          fmt::format("{} fit at once, as many as the slots hold", count_of(job_.at_once, "part")));
    }
    if (job_.at_once < least) {
      question_.refuse("at_once", fmt::format("{} {}: no {} can meet; give at least {}",
                                              question_.key("at_once"), job_.at_once,
                                              is_triple ? "triple" : "pair", least));
    }
  }

  // The request that the answer keeps, which needs no files.
  void finish_question() {
    whole_.header = whole_.no_header = false;
    whole_.cost_column.clear();
    whole_.done = {};
    whole_.done_first.reset();
    whole_.diagnose = whole_.what_if = false;
    if (!left_.all()) {  // the lists are of the remaining parts, but not the text of a model
      whole_.without = all_values_ ? question_->without : std::vector<std::string>();
      whole_.mounted = names_in(job_.mounted);
      whole_.start = names_in(job_.start);
    }
    if (job_.model != nullptr && question_->change_costs.is_given()) {
      whole_.change_costs = value_cost_rows(job_);
    } else if (job_.replaces()) {
      whole_.change_costs = change_cost_rows(job_);
    }
    if (question_->first.is_given()) {
      whole_.first = setup_rows(job_.first, job_, benches_);
    }
    if (question_->weights.is_given()) {
      whole_.weights = weight_rows(job_);
    }
  }

  [[nodiscard]] std::vector<std::string> names_in(const Block& parts) const {
    return each_of<std::string>(parts, [&](Element x) { return job_.names[x]; });
  }

  // Forbidden pairs and other constraints.
  void take_constraints() {
    const JobRequest& asked = *question_;
    if (asked.change_costs.is_given() && !asked.model.is_given()) {
      const auto input = question_.open("change_costs", asked.change_costs);
      job_.replace_costs = left_.square(
          read_old(*input, [&](Input& list, const auto& names, std::vector<std::string>* gone) {
            return read_change_costs(list, names, left_.slots(job_), gone);
          }));
    }
    if (asked.never.is_given()) {
      const auto input = question_.open("never", asked.never);
      PairReasons why;
      job_.never = left_(pairs_of(*input, &why));
      job_.why_never = left_(why);
      drop_needed(job_, job_.never);
      whole_.never = pair_rows(job_.never, job_, job_.why_never);
      if (!asked.pairs.is_given() && job_.needed.size() == 0) {
        throw BadInput(
            fmt::format("{}: no two parts can be in one set-up; leave out a pair", input->name()));
      }
    }
    take_pieces();
    if (asked.pairs.is_given()) {
      const auto input = question_.open("pairs", asked.pairs);
      const std::size_t notes = notes_.size();
      const PairSet pairs = pairs_of(*input, nullptr);
      job_.needed = left_(pairs);
      if (pairs.size() == 0 && notes_.size() == notes) {
        throw BadInput(
            fmt::format("{}: no pair is listed; write A,B, one pair per line", input->name()));
      }
      whole_.pairs = pair_rows(job_.needed, job_);
    }
    job_.mounted = mounted_left();
    job_.start = named("start", asked.start);
    take_benches();
    take_room();
    Job any = job_;
    any.needed = PairSet(job_.parts());
    check_job(any);
  }

  // Drops pairs and triples that cannot meet, with a note.
  void take_needs() {
    if (question_->strength == of_triples) {
      // A bench may have others that stay.
      const Block mounted = has_benches() ? std::exchange(job_.mounted, {}) : job_.mounted;
      std::uint64_t apart = need_triples(job_);
      job_.mounted = mounted;
      apart += drop_impossible_triples(job_, benches_);
      if (job_.triples.empty()) {
        throw BadInput(
            job_.model != nullptr
                ? "no values of three parameters fit in one test; give three, or loosen the rules"
            : job_.parts() < of_triples
                ? "a triple needs three parts; list three or more"
                : "no three parts can be in one set-up; loosen the slots, forbidden pairs or "
                  "what stays mounted");
      }
      if (apart > 0) {
        notes_.push_back(fmt::format(
            "{} cannot meet, for slots, forbidden pairs or what stays mounted, and need not",
            count_of(apart, "triple")));
      }
    } else if (!question_->pairs.is_given() && job_.model != nullptr) {
      leave_out_by_rules();
    } else if (!question_->pairs.is_given() && !job_.slots.empty() && !has_benches()) {
      leave_out(cannot_meet(job_), "within the slots");
    }
  }

  // What no test of the model has, and then what none has beside the values that stay; a bench may
  // have others that stay.
  void leave_out_by_rules() {
    const Block mounted = std::exchange(job_.mounted, {});
    const PairSet apart = cannot_meet(job_);
    job_.mounted = mounted;
    leave_out(apart, "by the rules");
    if (!has_benches() && !mounted.empty()) {
      leave_out(cannot_meet(job_), "beside what is always set");
    }
  }

  void leave_out(const PairSet& apart, std::string_view where) {
    if (apart.size() == 0) {
      return;
    }
    const bool is_all = apart.size() == job_.needed.size();
    // With several benches these are the pairs that done tests have left: perhaps impossible ones.
    if (is_all && has_benches() && !question_->done.is_given()) {
      throw BadInput("no two parts that must meet can be on one bench; let a bench have both");
    }
    if (is_all && !has_benches()) {
      throw BadInput(
          fmt::format("no two parts can be in one set-up within the slots; let a slot "
                      "hold more parts, or raise {}",
                      question_.key("at_once")));
    }
    drop_needed(job_, apart);
    notes_.push_back(apart_note(apart, job_, where));
  }

  void take_first_and_weights() {
    if (question_->first.is_given()) {
      const auto input = question_.open("first", question_->first);
      first_tests_ = input->name();
      read_old(*input, [&](Input& list, const auto&, std::vector<std::string>* gone) {
        take_first(list,
                   {.names = &names_,
                    .all_values = all_values_ ? &*all_values_ : nullptr,
                    .left = &left_,
                    .gone = gone,
                    .notes = &notes_},
                   job_, benches_);
        return 0;
      });
    }
    if (question_->weights.is_given()) {
      take_weights();
    }
  }

  // Weights of pairs that need not meet have no effect.
  void take_weights() {
    const auto input = question_.open("weights", question_->weights);
    job_.weights = left_(read_old(*input, read_priorities));
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

  ReadJob done_of_job() {
    const JobRequest& asked = *question_;
    DoneWords words{.done_first = question_.key("done_first"),
                    .trust_failed = question_.key("trust_failed"),
                    .first_tests = first_tests_};
    try {
      return take_done(open_done(asked.done, "done"),
                       {.names = &names_,
                        .all_values = all_values_ ? &*all_values_ : nullptr,
                        .left = &left_,
                        .first = asked.done_first,
                        .failed = asked.trust_failed ? FailedTests::trusted : FailedTests::again,
                        .for_diagnosis = asked.diagnose,
                        .all_parts_known = asked.done.rows.has_value()},
                       words, job_, benches_);
    } catch (const BadOption& fault) {
      question_.refuse("done_first", fault.what());
    }
  }

  Question question_;
  JobRequest whole_;  // the request with its lists as rows
  Job job_;
  std::optional<Job> all_values_;   // of a model, with those that broke
  std::vector<std::string> names_;  // of all parts of the list, and further pieces
  PartsLeft left_;                  // which of them remain
  std::vector<Bench> benches_;
  std::vector<std::uint64_t> quantities_;  // of the parts of the list, if it has them
  std::vector<std::string> notes_;
  std::optional<std::pair<std::string, std::string>> misspelled_;  // a list, and what it names
  std::string first_tests_;
};

ReadJob read_job(const JobRequest& request, Door door) {
  check_options(request, door);
  const Question question(request, door);
  try {
    return with_places(request.places, [&] { return JobMaker(request, door).make(); });
  } catch (const BadOption&) {
    throw;
  } catch (const BadInput& fault) {
    const std::string what = fault.what();
    const std::string& name = request.places.name;
    if (question.has_file() || (!name.empty() && what.starts_with(name))) {
      throw;
    }
    // Without a file or a document, the options are at fault.
    if (name.empty()) {
      throw BadOption(what);
    }
    throw BadInput(request.places.before_all() + what);
  }
}

}  // namespace changeover
