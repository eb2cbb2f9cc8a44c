#include "plan/request/whole_question.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
RequestList part_rows(const PartList& list, const Job& job) {
  std::vector<ListRow> rows;
  for (std::size_t i = 0; i < list.names.size(); ++i) {
    ListRow& row = rows.emplace_back();
    row.fields = {list.names[i], to_string(job.change_costs[i]),
                  list.slots.empty() ? "" : list.slots[i],
                  list.quantities.empty() ? "" : std::to_string(list.quantities[i])};
  }
  return {.rows = std::move(rows)};
}

RequestList slot_rows(const std::vector<Slot>& slots) {
  std::vector<ListRow> rows;
  rows.reserve(slots.size());
  for (const Slot& slot : slots) {
    rows.push_back({{slot.name, std::to_string(slot.least),
                     slot.most == Slot{}.most ? "" : std::to_string(slot.most)}});
  }
  return {.rows = std::move(rows)};
}

RequestList pair_rows(const PairSet& pairs, const Job& job, const PairReasons& why) {
  std::vector<ListRow> rows;
  pairs.for_each(all_of_them, [&](Element x, Element y) {
    ListRow& row = rows.emplace_back();
    row.fields = {job.names[std::min(x, y)], job.names[std::max(x, y)]};
    if (!why(x, y).empty()) {
      row.fields.push_back(why(x, y));
    }
  });
  return {.rows = std::move(rows)};
}

RequestList weight_rows(const Job& job) {
  std::vector<ListRow> rows;
  for (Element y = 1; y < job.parts(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (job.weights.weighs(x, y)) {
        rows.push_back({{job.names[x], job.names[y], to_string(job.weights(x, y))}});
      }
    }
  }
  return {.rows = std::move(rows)};
}

RequestList setup_rows(const std::vector<Block>& setups, const Job& job,
                       const std::vector<Bench>& benches) {
  std::vector<ListRow> rows;
  const auto add = [&](const Block& setup, const std::string& bench) {
    ListRow& row = rows.emplace_back();
    for (const Element x : setup) {
      row.fields.push_back(job.names[x]);
    }
    row.bench = bench;
  };
  for (const Block& setup : setups) {
    add(setup, "");
  }
  for (std::size_t b = 0; b < benches.size(); ++b) {
    for (std::size_t i = setups.size(); benches[b].first && i < benches[b].first->size(); ++i) {
      add((*benches[b].first)[i], name_of(benches, b));
    }
  }
  return {.rows = std::move(rows)};
}

RequestList bench_rows(const std::vector<Bench>& benches, const Job& job) {
  // No part at all is more than saying nothing.
  const auto parts = [&](const Block& block) {
    return block.empty() ? std::string(",") : parts_text(block, job.names);
  };
  const auto some = [&](const Block& block) { return block.empty() ? "" : parts(block); };
  const auto if_said = [&](const std::optional<Block>& block) {
    return block ? parts(*block) : "";
  };
  const auto amount = [](const std::optional<Amount>& said) {
    return said ? to_string(*said) : "";
  };
  std::vector<ListRow> rows;
  for (const Bench& bench : benches) {
    const std::string slots = joined(bench.slots, [](const Slot& slot) {
      return quoted_field(fmt::format("{}={}..{}", slot.name, slot.least,
                                      slot.most == Slot{}.most ? "" : std::to_string(slot.most)));
    });
    rows.push_back(
        {{bench.name, bench.at_once ? std::to_string(*bench.at_once) : "", amount(bench.test_cost),
          bench.change_factor == Bench{}.change_factor ? "" : to_string(bench.change_factor), slots,
          if_said(bench.mounted), if_said(bench.start), some(bench.own), some(bench.without),
          amount(bench.hours), bench.down ? "yes" : ""}});
  }
  return {.rows = std::move(rows)};
}

RequestList change_cost_rows(const Job& job) {
  std::vector<Element> parts;
  for (Element x = 0; x < job.parts(); ++x) {
    if (job.piece_of.empty() || job.piece_of[x] == x) {
      parts.push_back(x);
    }
  }
  std::vector<ListRow> rows(1);
  rows.front().fields.emplace_back();
  for (const Element in : parts) {
    rows.front().fields.push_back(job.names[in]);
  }
  for (const Element out : parts) {
    ListRow& row = rows.emplace_back();
    row.fields.push_back(job.names[out]);
    for (const Element in : parts) {
      row.fields.push_back(
          out == in || !job.may_replace(out, in) ? "" : to_string(job.replace_cost(out, in)));
    }
  }
  return {.rows = std::move(rows)};
}

RequestList value_cost_rows(const Job& job) {
  std::vector<ListRow> rows;
  for (const ModelParameter& parameter : job.model->parameters) {
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      const auto in = static_cast<Element>(parameter.first + i);
      rows.push_back(
          {{parameter.name, parameter.values[i].label, to_string(job.change_costs[in])}});
      if (!job.quantities.empty() && job.quantities[in] != enough_for_all) {
        rows.push_back({{parameter.name, parameter.values[i].label, "quantity",
                         std::to_string(job.quantities[in])}});
      }
      for (std::size_t o = 0; job.replaces() && o < parameter.values.size(); ++o) {
        const Amount cost = job.replace_cost(static_cast<Element>(parameter.first + o), in);
        if (o != i && cost != job.change_costs[in]) {
          rows.push_back({{parameter.name, parameter.values[o].label, parameter.values[i].label,
                           to_string(cost)}});
        }
      }
    }
  }
  return {.rows = std::move(rows)};
}

std::string first_names(const std::vector<std::string>& names, std::size_t from) {
  constexpr std::size_t few = 3;
  std::string first;
  for (std::size_t i = from; i < std::min(names.size(), from + few); ++i) {
    first += (first.empty() ? "" : ", ") + names[i];
  }
  return first + (names.size() > from + few ? ", …" : "");
}

std::string apart_note(const PairSet& apart, const Job& job, std::string_view where) {
  constexpr std::uint64_t few = 8;
  std::string examples;
  apart.for_each(few, [&](Element x, Element y) {
    examples += fmt::format("{}{} and {}", examples.empty() ? "" : "; ", job.names[std::min(x, y)],
                            job.names[std::max(x, y)]);
  });
  return fmt::format("{} cannot meet {} and need not: {}{}", count_of(apart.size(), "pair"), where,
                     examples,
                     apart.size() > few ? fmt::format("; and {} more", apart.size() - few) : "");
}

}  // namespace changeover
