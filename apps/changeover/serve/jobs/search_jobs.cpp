#include "serve/jobs/search_jobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "answer/catalog/entry_words.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"
#include "changeover/search/exact.hpp"
#include "changeover/search/local_search.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/search_request.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

constexpr std::size_t most_remembered_searches = 50;
constexpr std::size_t most_points = 2000;

struct Point {
  double seconds = 0;
  std::optional<std::uint64_t> best = {};
  std::optional<std::uint64_t> lower_bound = {};
  double rate = 0;  // steps a second
};

// Whether there is a design with so many blocks, as an exact search decides it.
struct DecidedBlocks {
  std::uint64_t blocks = 0;
  std::string outcome = "running";  // then that of the decision
  double begin = 0;
  double end = 0;
  std::uint64_t steps = 0;  // kB of proof
};

// How a design was searched for.
std::string provenance(const SearchOrder& order, const std::string& way) {
  cli::SearchRequest request;
  request.run.seed = order.seed;
  request.run.threads = order.threads;
  request.run.time = fmt::format("{:g}s", order.seconds);
  request.blocks = order.blocks;
  return cli::provenance(request, order.parameters, way);
}

// A design whose recipe has its blocks and says how it was searched for.
Design credited(const SearchOrder& order, Design design, const std::string& way) {
  design.recipe = literal_recipe(design, provenance(order, way));
  return design;
}

std::string stopped_early(WhyStopped why) {
  return fmt::format("stopped ({}) before there was a design", to_string(why));
}

}  // namespace

std::string_view to_string(SearchWay way) {
  constexpr std::string_view names[] = {"local", "exact", "base-blocks", "locked"};
  return names[static_cast<std::size_t>(way)];
}

struct SearchJobs::Job : ListedJob {
  static std::string missing_defect(std::uint64_t id) {
    return fmt::format("there is no search {}; api/search lists all searches", id);
  }

  SearchOrder order;
  std::optional<std::uint64_t> best = {};
  std::optional<std::uint64_t> lower_bound = {};
  std::optional<std::uint64_t> start_best = {};
  std::optional<std::uint64_t> restarts = {};
  std::uint64_t moves = 0;
  std::string unit = "moves";
  std::string message = "searching";
  std::vector<Point> points = {};
  std::vector<DecidedBlocks> decisions = {};
  std::shared_ptr<const Design> design = {};

  void tell(const Progress& progress);
  void begin_deciding(std::uint64_t blocks);
  void end_deciding(const Decision& decision);
  void give_up_deciding();
  void add_point(Point point);
  void write(JsonWriter& json, bool with_points) const;
};

void SearchJobs::Job::tell(const Progress& progress) {
  const std::scoped_lock lock(mutex);
  const double now = progress.elapsed.count();
  const double rate = now > seconds && progress.steps >= moves
                          ? static_cast<double>(progress.steps - moves) / (now - seconds)
                          : 0;
  seconds = now;
  moves = progress.steps;
  unit = progress.unit;
  if (!decisions.empty()) {
    decisions.back().end = now;
    decisions.back().steps = std::max(decisions.back().steps, moves);
  }
  best = progress.best ? progress.best : best;
  lower_bound = progress.lower_bound ? progress.lower_bound : lower_bound;
  start_best = start_best ? start_best : progress.best;
  message = progress.phase;
  add_point({now, best, lower_bound, rate});
}

void SearchJobs::Job::add_point(Point point) {
  if (points.size() == most_points) {
    // Every second point goes, as often as need be: the curve keeps its shape.
    for (std::size_t i = 1; 2 * i < points.size(); ++i) {
      points[i] = points[2 * i];
    }
    points.resize(most_points / 2);
  }
  points.push_back(point);
}

void SearchJobs::Job::begin_deciding(std::uint64_t blocks) {
  const std::scoped_lock lock(mutex);
  const double now = control->elapsed().count();
  unit = "kB of proof";
  decisions.push_back({.blocks = blocks, .begin = now, .end = now});
  add_point({now, best, lower_bound, 0});
}

void SearchJobs::Job::end_deciding(const Decision& decision) {
  const std::scoped_lock lock(mutex);
  DecidedBlocks& decided = decisions.back();
  decided.outcome = to_string(decision.outcome);
  decided.end = control->elapsed().count();
  if (decision.excluded() && lower_bound < decision.b + 1) {
    lower_bound = decision.b + 1;
  }
  if (decision.outcome == Outcome::found) {
    best = decision.b;
  }
  add_point({decided.end, best, lower_bound, 0});
}

void SearchJobs::Job::write(JsonWriter& json, bool with_points) const {
  const std::scoped_lock lock(mutex);
  const Parameters& p = order.parameters;
  json.begin_object().key("id").value(id).cell(p).key("strength").value(p.strength);
  json.key("way").value(to_string(order.way));
  json.key("state").value(state).key("best").value(best).key("lower_bound").value(lower_bound);
  json.key("start_best").value(start_best).key("seconds").value(seconds);
  json.key("limit").value(order.seconds).key("threads").value(order.threads);
  json.key("seed").value(order.seed).key("restarts").value(restarts);
  json.key("message").value(message).key("steps").value(moves).key("unit").value(unit);
  json.objects("decisions", decisions, [&](const DecidedBlocks& decided) {
    json.key("blocks").value(decided.blocks).key("outcome").value(decided.outcome);
    json.key("seconds").value(decided.end - decided.begin).key("steps").value(decided.steps);
  });
  if (with_points) {
    json.objects("points", points, [&](const Point& point) {
      json.key("seconds").value(point.seconds).key("best").value(point.best);
      json.key("lower_bound").value(point.lower_bound);
      json.key("rate").value(point.rate);
    });
  }
  json.end_object();
}

// What was under way when the search ended stays open.
void SearchJobs::Job::give_up_deciding() {
  const std::scoped_lock lock(mutex);
  if (!decisions.empty() && decisions.back().outcome == "running") {
    decisions.back().outcome = to_string(Outcome::unknown);
  }
}

Kept keep_in_catalog(Catalog& catalog, const Design& design) {
  const Newcomer newcomer = newcomer_of(
      design, {.credit = {.who = "", .date = cli::today(), .program = "", .command = ""}});
  if (!newcomer.entry) {
    throw Refusal{422, "it is not a change covering design: " + newcomer.refused};
  }
  const CatalogEntry& entry = *newcomer.entry;
  try {
    const auto there = catalog.find(entry.label());
    if (there && there->checksum == entry.checksum) {
      return {entry.label(), true};
    }
    if (const auto same = same_in_catalog(catalog, entry)) {
      return {*same, true};
    }
    return {entry.label(), catalog.add(entry) == Added::already_there};
  } catch (const BadInput& fault) {  // The user's file is what is bad, and nothing that was sent.
    throw MissingResource(fault.what());
  }
}

SearchJobs::SearchJobs(Catalog& catalog, EventHub& events, const Settings& settings)
    : catalog_(catalog),
      events_(events),
      settings_(settings),
      jobs_(std::make_unique<JobList<Job>>(settings.at_once, most_remembered_searches)) {}

SearchJobs::~SearchJobs() = default;

std::uint64_t SearchJobs::start(const SearchOrder& order) {
  if (const auto reason = impossibility(order.parameters)) {
    throw Refusal{400, fmt::format("no {} exists: {}", name(order.parameters), *reason)};
  }
  return jobs_->start(
      "searches that run",
      [&](Job& job) {
        job.order = order;
        RunControl::Settings settings;
        settings.time = std::chrono::duration<double>(order.seconds);
        settings.memory_bytes = settings_.memory_bytes;
        settings.threads = order.threads;
        settings.seed = order.seed;
        settings.progress_interval = std::chrono::duration<double>(0.25);
        settings.on_progress = [this, one = &job](const Progress& progress) {
          one->tell(progress);
          publish(*one);
        };
        job.control = std::make_unique<RunControl>(std::move(settings));
      },
      [this](Job& job) { run(job); });
}

void SearchJobs::run(Job& job) {
  publish(job);
  std::string fault;
  try {
    search(job);
  } catch (const Stopped&) {
    const std::scoped_lock lock(job.mutex);
    job.state = "stopped";
    job.message = "stopped before there was a design";
  } catch (const std::exception& failure) {
    fault = failure.what();
  }
  if (!fault.empty()) {
    const std::scoped_lock lock(job.mutex);
    job.state = "failed";
    job.message = fault;
  }
  job.give_up_deciding();
  publish(job);
}

// The result of one way of searching.
struct SearchJobs::Found {
  std::optional<Design> design = {};
  std::optional<std::uint64_t> known = {};  // blocks of the best before
  std::optional<std::uint64_t> lower = {};  // proved by the search itself
  std::string wanted = {};                  // of which designs that is true, if not of all
  std::uint64_t attempts = 0;
  double moves_per_second = 0;
  std::string message = {};
  WhyStopped why_stopped = WhyStopped::running;
};

void SearchJobs::finish(Job& job, Found found) {
  const std::scoped_lock lock(job.mutex);
  if (found.design) {
    job.design = std::make_shared<const Design>(*std::move(found.design));
    job.best = job.design->block_count();
  }
  job.start_best = found.known;
  job.lower_bound = found.lower ? found.lower : job.lower_bound;
  job.restarts = found.attempts;
  job.seconds = job.control->elapsed().count();
  job.points.push_back({job.seconds, job.best, job.lower_bound, found.moves_per_second});
  job.state = found.why_stopped == WhyStopped::interrupted ? "stopped" : "done";
  job.message = found.message;
  if (job.design && job.lower_bound == job.best) {
    job.message = (found.wanted.empty() ? "minimum: as many blocks as the lower bound"
                                        : "no design" + found.wanted + " has fewer blocks") +
                  (found.lower && !found.message.empty() ? "; " + found.message : std::string());
  }
}

SearchJobs::Found SearchJobs::search_locally(const Job& job) {
  const SearchOrder& order = job.order;
  ImproveOptions options;
  options.target = order.blocks;
  ImproveResult result = improve(order.parameters, options, *job.control);
  Found found{.known = result.started_from,
              .attempts = result.attempts,
              .moves_per_second = result.moves_per_second,
              .why_stopped = result.why_stopped};
  const bool better = result.design &&
                      (!result.started_from || result.design->block_count() < *result.started_from);
  if (result.design) {
    Design design = (*std::move(result.design)).take();
    found.design = better || !design.recipe ? credited(order, std::move(design), "") : design;
  }
  const std::string known = result.started_from
                                ? count_of(*result.started_from, "block") + " were known before"
                                : "no design was known before";
  found.message = !found.design               ? stopped_early(result.why_stopped)
                  : better                    ? fmt::format("found with {}; {}", result.how, known)
                  : result.unsearched.empty() ? "nothing better was found"
                                              : "no search was made: " + result.unsearched;
  return found;
}

SearchJobs::Found SearchJobs::search_exactly(Job& job) {
  const SearchOrder& order = job.order;
  const bool any_known = order.parameters.strength == 2 && !order.anew && !order.wanted.any();
  const std::optional<Offer> offer =
      any_known ? best_known(Registry::standard(), order.parameters) : std::nullopt;
  const std::string besides = cli::way_of(order.wanted, order.anew);
  const std::string way = "--exact" + (besides.empty() ? "" : " " + besides);
  MinimumOptions options;
  options.exact.wanted = order.wanted;
  options.from_known = !order.anew;
  options.decider = [&](std::uint64_t b, const ExactOptions& exact) {
    job.begin_deciding(b);
    publish(job);
    Decision decision = decide(order.parameters, b, exact, *job.control);
    if (decision.design) {
      decision.design->set_recipe(*credited(order, decision.design->design(), way).recipe);
    }
    job.end_deciding(decision);
    publish(job);
    return decision;
  };
  std::optional<Design> known;
  if (offer) {
    known = built_design(*offer).take();
    const std::scoped_lock lock(job.mutex);
    job.best = job.start_best = offer->b;
  }
  MinimumResult result = find_minimum(order.parameters, options, *job.control, known);
  const bool settled = result.settled();
  Found found{.known = offer          ? std::optional(offer->b)
                       : result.known ? result.upper()
                                      : std::nullopt,
              .lower = result.lower,
              .wanted = wanted_words(order.wanted),
              .attempts = result.steps.size(),
              .why_stopped = result.why_stopped};
  std::vector<std::string> said;
  for (const Decision& step : result.steps) {
    if (step.excluded()) {
      said.push_back(count_of(step.b, "block") + ": none, by a checked DRAT proof");
    }
  }
  if (result.best) {
    Design design = (*std::move(result.best)).take();
    found.design = design.recipe ? design : credited(order, std::move(design), way);
  }
  if (!settled) {
    said.push_back(fmt::format("not decided ({})", to_string(result.why_stopped)));
  }
  found.message = fmt::format("{}", fmt::join(said, "; "));
  return found;
}

SearchJobs::Found SearchJobs::search_for_base_blocks(const Job& job) {
  const SearchOrder& order = job.order;
  BaseBlockOptions options;
  options.shapes.most_blocks = order.blocks;
  BaseBlockResult result = search_base_blocks(order.parameters, options, *job.control);
  Found found{.known = result.registry_b,
              .attempts = result.attempts.size(),
              .message = describe(result),
              .why_stopped = result.why_stopped};
  if (result.found()) {
    found.design = (*std::move(result.design)).take();
    found.design->recipe = result.recipe;
    if (result.recipe) {
      cli::credit(*found.design->recipe, provenance(order, "--base-blocks"));
    }
  }
  return found;
}

SearchJobs::Found SearchJobs::search_with_locked_cells(const Job& job) {
  const SearchOrder& order = job.order;
  LockedResult result =
      search_locked(order.parameters, order.wanted,
                    {.blocks = order.blocks, .moves = {}, .from_known = !order.anew}, *job.control);
  Found found{.attempts = result.attempts, .why_stopped = result.why_stopped};
  if (result.design) {
    found.design =
        credited(order, (*std::move(result.design)).take(), cli::way_of(order.wanted, order.anew));
  }
  found.message =
      found.design ? "found with what was to be in its place" : stopped_early(result.why_stopped);
  return found;
}

void SearchJobs::search(Job& job) {
  const SearchOrder& order = job.order;
  const RunScope scope(*job.control);
  const Bound bound = order.way == SearchWay::exact ? lower_bound_on_paper(order.parameters)
                                                    : lower_bound(order.parameters);
  {
    const std::scoped_lock lock(job.mutex);
    job.lower_bound = bound.blocks;
  }
  switch (order.way) {
    case SearchWay::local:
      return finish(job, search_locally(job));
    case SearchWay::exact:
      return finish(job, search_exactly(job));
    case SearchWay::base_blocks:
      return finish(job, search_for_base_blocks(job));
    case SearchWay::locked:
      return finish(job, search_with_locked_cells(job));
  }
}

void SearchJobs::publish(const Job& job) {
  JsonWriter json;
  job.write(json, false);
  events_.publish("search", std::to_string(job.id), json.take());
}

void SearchJobs::stop(std::uint64_t id) { jobs_->stop(id); }

bool SearchJobs::stop_all(std::chrono::duration<double> patience) {
  return jobs_->stop_all(patience);
}

std::shared_ptr<const Design> SearchJobs::design_of(std::uint64_t id) const {
  const auto job = jobs_->find(id);
  const std::scoped_lock lock(job->mutex);
  if (!job->design) {
    throw Refusal{404, job->state == "running"
                           ? fmt::format("search {} has no design yet; stop it to see the best", id)
                           : fmt::format("search {} ended without a design; search longer", id)};
  }
  return job->design;
}

Kept SearchJobs::keep(std::uint64_t id) { return keep_in_catalog(catalog_, *design_of(id)); }

std::string SearchJobs::list_json() const {
  JsonWriter json;
  json.list(jobs_->all(), [&](const auto& job) { job->write(json, false); });
  return json.take() + "\n";
}

std::string SearchJobs::one_json(std::uint64_t id) const {
  JsonWriter json;
  jobs_->find(id)->write(json, true);
  return json.take() + "\n";
}

}  // namespace changeover::serve
