#include "serve/api/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ranges>

#include "answer/design/judgement.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

constexpr std::size_t most_bad_steps = 100;
constexpr std::size_t most_uncovered = 200;
constexpr std::size_t most_shown_blocks = 200'000;

void write_defects(JsonWriter& json, const Verdict& verdict) {
  const auto shown = verdict.bad_step_examples | std::views::take(most_bad_steps);
  json.objects("bad_steps", shown, [&](const BadStep& step) {
    json.key("block").value(step.to);
    json.key("why").value(fmt::format("from block {} to block {}{}: {} changed, not {}", step.from,
                                      step.to, step.to < step.from ? " (the circle closes)" : "",
                                      count_of(step.changes, "element"),
                                      verdict.parameters.change));
  });
  json.key("uncovered_pairs").value(verdict.uncovered_examples);
}

}  // namespace

ReadOptions reading_of(const Request& request) {
  ReadOptions options{.v = number_of(request, "v"),
                      .k = number_of(request, "k"),
                      .change = number_of(request, "change"),
                      .kind = kind_of(request),
                      .strength = {}};
  if (const auto strength = number_of(request, "strength")) {
    if (*strength < 2 || *strength > max_strength) {
      throw Refusal{400, fmt::format("strength={}: give 2 to {}", *strength, max_strength)};
    }
    options.strength = static_cast<std::uint32_t>(*strength);
  }
  return options;
}

std::string verified_json(const Design& design) {
  const Verdict verdict = verify(design, {.examples = most_uncovered, .unchanged = true});
  const cli::Judgement judgement = cli::judge(verdict);
  // As many examples as the command line names.
  Verdict details = verdict;
  const std::size_t named = VerifyOptions().examples;
  details.bad_step_examples.resize(std::min(details.bad_step_examples.size(), named));
  details.uncovered_examples.resize(std::min(details.uncovered_examples.size(), named));
  // The members of that document, between its braces.
  const std::string document = cli::verify_json(details, judgement, design.labels());
  JsonWriter more;
  more.begin_object();
  write_defects(more, verdict);
  more.key("design");
  if (design.block_count() > most_shown_blocks) {
    more.null();
  } else {
    StringSink sink;
    write_json(design, sink);
    std::string text = sink.take();
    std::ranges::replace(text, '\n', ' ');
    more.raw(text);
  }
  const std::string rest = more.end_object().take();
  return fmt::format("{{\"valid\":{},{},{}", verdict.valid(),
                     std::string_view(document).substr(1, document.size() - 2),
                     std::string_view(rest).substr(1));
}

// What a list of blocks becomes with few blocks changed, and which blocks these are.
static std::string repaired_json(const Design& list, RunControl& control) {
  const RepairResult result = repair(list, {}, control);
  JsonWriter json;
  json.begin_object().key("given").value(result.given).key("kept").value(result.kept);
  json.key("bad_steps").value(result.bad_steps).key("uncovered").value(result.uncovered);
  json.key("design");
  if (!result.design) {
    json.null();
  } else {
    StringSink sink;
    write_json(*result.design, sink);
    std::string text = sink.take();
    std::ranges::replace(text, '\n', ' ');
    json.raw(text);
  }
  return json.end_object().take();
}

static Response repaired(const Request& request) {
  constexpr std::size_t most_repaired = 20'000;
  constexpr std::chrono::duration<double> most_time{10};
  const Design list = read_design(input_from_text(request.body), reading_of(request));
  if (list.block_count() > most_repaired) {
    throw Refusal{413, fmt::format("the list has {} blocks, and at most {} are repaired here; "
                                   "changeover search --repair FILE has no such limit",
                                   list.block_count(), most_repaired)};
  }
  RunControl control(*RunScope::current(), most_time);
  std::string answer = repaired_json(list, control);
  stop_if_asked();  // The client may have gone.
  return json_response(answer + "\n");
}

void add_verify(Router& router, Explorer& explorer) {
  constexpr std::size_t quick_bytes = 200'000;
  Route route = posted(
      explorer, "api/verify", {"v", "k", "change", "kind", "strength"}, Body::any,
      [](const Request& request) {
        return json_response(
            verified_json(read_design(input_from_text(request.body), reading_of(request))) + "\n");
      });
  route.lane = [](const Request& request) {
    return request.body.size() <= quick_bytes ? Lane::quick : Lane::slow;
  };
  router.add(std::move(route));
  router.add(posted(explorer, "api/repair", {"v", "k", "change", "kind", "strength"}, Body::any,
                    repaired));
}

}  // namespace changeover::serve
