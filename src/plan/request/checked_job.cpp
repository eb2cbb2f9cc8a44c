// Converts a request to a job.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/request/asked_benches.hpp"
#include "plan/request/asked_parts.hpp"
#include "plan/request/asked_slots.hpp"
#include "plan/request/done/done_tests.hpp"
#include "plan/request/first_lists.hpp"
#include "plan/request/parts_left.hpp"
#include "plan/request/question.hpp"
#include "plan/request/whole_question.hpp"
#include "plan/request/workbook/run_workbook.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"

namespace changeover {

static constexpr std::uint64_t of_triples = 3;  // the strength at which triples must meet

// Builds a checked job step by step.
class JobMaker : private AskedParts {
 public:
  using AskedParts::AskedParts;

  ReadJob make() {
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

  std::vector<Bench> benches_;
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
