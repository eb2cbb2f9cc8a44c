// Three parts that must meet.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {
namespace {

bool may_meet(const Job& job, const Fitting& fitting, const Triple& triple) {
  Block setup = with_mounted(job, {triple[0], triple[1], triple[2]});
  for (std::size_t i = 0; i < setup.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (job.never.contains(setup[i], setup[j])) {
        return false;
      }
    }
  }
  return setup.size() <= job.room() &&
         (!fitting.has_slots() || fitting.simplest(std::move(setup)).setup.has_value());
}

// Whether the parts belong to three parameters and at most one is out of range.
bool is_of_three_parameters(const Job& job, const Triple& t) {
  const bool different = job.slot_of[t[0]] != job.slot_of[t[1]] &&
                         job.slot_of[t[0]] != job.slot_of[t[2]] &&
                         job.slot_of[t[1]] != job.slot_of[t[2]];
  return different && std::ranges::count_if(t, [&](Element x) {
                        return out_of_range(job, std::span(&x, 1)).has_value();
                      }) <= 1;
}

// For a triple with a value out of range, only the pairs of that value are needed: a test of the
// triple hides the third pair.
void need_their_pairs(Job& job) {
  job.needed = PairSet(job.parts());
  for (const Triple& t : job.triples) {
    const std::optional<Element> hiding = out_of_range(job, t);
    const auto need = [&](Element x, Element y) {
      if (!hiding || x == *hiding || y == *hiding) {
        job.needed.insert(x, y);
      }
    };
    need(t[0], t[1]);
    need(t[0], t[2]);
    need(t[1], t[2]);
  }
}

}  // namespace

std::uint64_t need_triples(Job& job) {
  if (job.parts() > max_parts_of_triples) {
    throw BadInput(
        fmt::format("there are {} parts; where triples must meet, at most {} are supported",
                    job.parts(), max_parts_of_triples));
  }
  const bool of_model = job.model != nullptr;
  const Fitting fitting(job);
  std::vector<Triple> triples;
  std::uint64_t apart = 0;
  for (Element z = 2; z < job.parts(); ++z) {
    for (Element y = 1; y < z; ++y) {
      stop_if_asked();
      for (Element x = 0; x < y; ++x) {
        if (of_model ? is_of_three_parameters(job, {x, y, z}) : may_meet(job, fitting, {x, y, z})) {
          triples.push_back({x, y, z});
        } else {
          apart += of_model ? 0U : 1U;
        }
      }
    }
  }
  if (of_model) {
    const std::size_t all = triples.size();
    triples = together_in_choices(job, triples);
    apart = all - triples.size();
  }
  job.triples = std::move(triples);
  job.asks_for_triples = true;
  need_their_pairs(job);
  return apart;
}

void drop_met_triples(Job& job, const Meetings& meetings) {
  if (job.triples.empty()) {
    return;
  }
  std::erase_if(job.triples, [&](const Triple& t) { return meetings.met(t); });
  need_their_pairs(job);
}

}  // namespace changeover
