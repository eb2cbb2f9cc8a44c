#include "answer/known/known_bounds.hpp"

#include <fmt/format.h>

#include "io/write/json_writer.hpp"

namespace changeover::cli {

std::string KnownBounds::status() const {
  if (impossible) {
    return "impossible";
  }
  if (!best) {
    return "open";
  }
  return best->b == bounds.front().blocks ? "minimum" : "best-known";
}

KnownBounds known_bounds(const Parameters& p) {
  KnownBounds answer{
      .parameters = p, .impossible = impossibility(p), .bounds = {}, .best = {}, .reported = {}};
  if (!answer.impossible) {
    answer.bounds = lower_bounds(p);
    answer.best = best_known(p);
    answer.reported = reported_below(p, answer.best ? std::optional(answer.best->b) : std::nullopt);
  }
  return answer;
}

std::string in_words(const Reported& reported) {
  return fmt::format("{} reported [{}], blocks not held here", reported.blocks, reported.cites);
}

void write_reported(JsonWriter& json, const KnownBounds& known) {
  json.key("reported");
  if (!known.reported) {
    json.null();
    return;
  }
  json.begin_object().key("blocks").value(known.reported->blocks);
  json.key("cites").value(known.reported->cites).end_object();
}

void begin_known(JsonWriter& json, const KnownBounds& known) {
  const Parameters& p = known.parameters;
  json.begin_object().key("v").value(p.v).key("k").value(p.k).key("change").value(p.change);
  json.key("kind").value(to_string(p.kind)).key("strength").value(std::uint64_t{p.strength});
  json.key("lower_bound");
  known.impossible ? json.null() : json.value(known.bounds.front().blocks);
  json.key("reason").value(known.impossible ? *known.impossible : known.bounds.front().reason);
}

std::string bounds_json(const KnownBounds& answer) {
  JsonWriter json;
  begin_known(json, answer);
  json.key("best_known");
  answer.best ? json.value(answer.best->b) : json.null();
  json.key("construction");
  answer.best ? json.value(answer.best->recipe.construction) : json.null();
  json.key("status").value(answer.status());
  write_reported(json, answer);
  json.key("bounds").begin_array();
  for (const Bound& bound : answer.bounds) {
    json.begin_object().key("lower_bound").value(bound.blocks).key("name").value(bound.name);
    json.key("reason").value(bound.reason).end_object();
  }
  json.end_array().end_object();
  return json.take();
}

}  // namespace changeover::cli
