// Searches, their events, and what is kept of them.
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "changeover/io/input.hpp"
#include "core/printable.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/routes.hpp"
#include "serve/api/verify.hpp"
#include "serve/jobs/search_jobs.hpp"

namespace changeover::serve {
namespace {

SearchWay way_named(const std::string& name) {
  for (const SearchWay way :
       {SearchWay::local, SearchWay::exact, SearchWay::base_blocks, SearchWay::locked}) {
    if (name == to_string(way)) {
      return way;
    }
  }
  throw Refusal{422, "way: write \"local\", \"exact\", \"base-blocks\" or \"locked\""};
}

Block elements_in(JsonBody& body, const std::string& name) {
  Block elements;
  const JsonNode* const list = body.find(name);
  if (list == nullptr) {
    return elements;
  }
  if (!list->is_array()) {
    throw Refusal{422, fmt::format("{}: write a list of elements such as [0,1,2]", name)};
  }
  for (const auto& [key, each] : list->members) {
    if (!each.is_natural() || each.natural > max_elements_in_memory) {
      throw Refusal{422, fmt::format("{}: {} is not an element; write whole numbers from 0 to v-1",
                                     name, changeover::shown(json_text(each)))};
    }
    elements.push_back(static_cast<Element>(each.natural));
  }
  return elements;
}

// What a way cannot do, before it is begun.
void check_way(const SearchOrder& order) {
  const Parameters& p = order.parameters;
  const Wanted& wanted = order.wanted;
  const bool takes_wanted = order.way == SearchWay::locked || order.way == SearchWay::exact;
  if (!takes_wanted && (wanted.any() || order.anew)) {
    throw Refusal{422, wanted.any() ? "first, last and expansion_set are for \"way\":\"locked\" "
                                      "and \"exact\"; give one of these ways"
                                    : "anew is for \"way\":\"locked\" and \"exact\"; give one of "
                                      "these ways"};
  }
  if (order.way == SearchWay::locked) {
    if (!wanted.any()) {
      throw Refusal{422, "way: \"locked\" needs first, last or expansion_set; give one of them"};
    }
    if (p.strength != 2) {
      throw Refusal{422, "way: \"locked\" needs strength 2; use \"exact\" for other strengths"};
    }
  }
  if (const std::string defect = wanted_defect(p, wanted); !defect.empty()) {
    throw Refusal{422, fmt::format("no {} can have what you ask for: {}", name(p), defect)};
  }
  if (order.way == SearchWay::exact && order.blocks) {
    throw Refusal{422,
                  "blocks has no meaning with \"way\":\"exact\", which finds the minimum; "
                  "leave it out"};
  }
}

unsigned threads_of(JsonBody& body) {
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  const auto refusal = [&] {
    return Refusal{422, fmt::format("threads: write 1 to {}, as many as this machine has", cores)};
  };
  std::uint64_t threads = 0;
  try {
    threads = body.number("threads").value_or(1);
  } catch (const Refusal&) {  // Which says that it is no whole number, and not which are.
    throw refusal();
  }
  if (threads < 1 || threads > cores) {
    throw refusal();
  }
  return static_cast<unsigned>(threads);
}

SearchOrder order_of(const Request& request) {
  constexpr double most_seconds = 86'400;
  JsonBody body(request.body);
  SearchOrder order;
  Parameters& p = order.parameters;
  p.v = body.needed_number("v");
  p.k = body.needed_number("k");
  p.change = body.number("change").value_or(2);
  const auto kind = kind_from_string(body.text("kind").value_or("linear"));
  if (!kind) {
    throw Refusal{422, "kind: write \"circular\" or \"linear\""};
  }
  p.kind = *kind;
  const std::uint64_t strength = body.number("strength").value_or(2);
  if (strength < 2 || strength > max_strength) {
    throw Refusal{422, fmt::format("strength: write 2 to {}", max_strength)};
  }
  p.strength = static_cast<std::uint32_t>(strength);
  order.way = way_named(body.text("way").value_or("local"));
  order.blocks = body.number("blocks");
  if (order.blocks == 0) {
    throw Refusal{422, "blocks: a design has at least one block"};
  }
  order.wanted.first = elements_in(body, "first");
  order.wanted.last = elements_in(body, "last");
  order.wanted.expansion_set = body.boolean("expansion_set").value_or(false);
  order.anew = body.boolean("anew").value_or(false);
  order.seconds = body.seconds("seconds").value_or(order.seconds);
  if (order.seconds <= 0 || order.seconds > most_seconds) {
    throw Refusal{422, fmt::format("seconds: write more than 0 and at most {}", most_seconds)};
  }
  order.threads = threads_of(body);
  order.seed = body.number("seed").value_or(1);
  body.finish();
  check(p);
  check_way(order);
  return order;
}

std::string kept_json(const Kept& kept) {
  JsonWriter json;
  json.begin_object().key("label").value(kept.label).key("already").value(kept.already);
  return json.end_object().take() + "\n";
}

}  // namespace

void add_searches(Router& router, Explorer& explorer) {
  Route list = question(
      explorer, "api/search", {"id"}, Again::made_anew, [&explorer](const Request& request) {
        const auto id = number_of(request, "id");
        return json_response(id ? explorer.jobs->one_json(*id) : explorer.jobs->list_json());
      });
  router.add(std::move(list));

  Route events;
  events.path = "api/events";
  events.lane = always(Lane::here);
  events.answer = [&explorer](const Request&) {
    constexpr std::size_t most_listeners = 64;
    if (explorer.events.listeners() >= most_listeners) {
      throw Refusal{503, fmt::format("{} streams of events are open; close one", most_listeners)};
    }
    Response response;
    response.type = "text/event-stream; charset=utf-8";
    response.events = explorer.events.listen();
    return response;
  };
  router.add(std::move(events));

  router.add(changing(
      explorer, "api/search", {}, Body::json, Lane::quick, [&explorer](const Request& request) {
        return json_response(
            fmt::format("{{\"id\":{}}}\n", explorer.jobs->start(order_of(request))));
      }));
  router.add(changing(explorer, "api/search/stop", {"id"}, Body::none, Lane::quick,
                      [&explorer](const Request& request) {
                        explorer.jobs->stop(needed_number(request, "id"));
                        return json_response("{}\n");
                      }));
  router.add(changing(explorer, "api/search/keep", {"id"}, Body::none, Lane::slow,
                      [&explorer](const Request& request) {
                        return json_response(
                            kept_json(explorer.jobs->keep(needed_number(request, "id"))));
                      }));
  router.add(changing(
      explorer, "api/catalog/add", {"v", "k", "change", "kind", "strength"}, Body::any, Lane::slow,
      [&explorer](const Request& request) {
        return json_response(kept_json(keep_in_catalog(
            explorer.catalog, read_design(input_from_text(request.body), reading_of(request)))));
      }));
}

}  // namespace changeover::serve
