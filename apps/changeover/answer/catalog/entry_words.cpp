#include "answer/catalog/entry_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "changeover/construct/registry.hpp"
#include "changeover/core/version.hpp"
#include "changeover/io/tables.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

namespace {

void collect(const Recipe& recipe, std::vector<std::string>& keys) {
  if (const Construction* const construction = Registry::standard().find(recipe.construction)) {
    const std::string key = construction->citation().key;
    if (!key.empty() && std::ranges::find(keys, key) == keys.end()) {
      keys.push_back(key);
    }
  }
  for (const Recipe& input : recipe.inputs) {
    collect(input, keys);
  }
}

// Words of a user's in a field of BibTeX, which counts braces after a backslash, too.
std::string bibtex_text(const std::string& words) {
  std::string text;
  const std::string escaped = latex_escaped(words);
  for (std::string_view rest = escaped; !rest.empty();) {
    const bool brace = rest.starts_with("\\{") || rest.starts_with("\\}");
    text += !brace           ? rest.substr(0, 1)
            : rest[1] == '{' ? "\\textbraceleft{}"
                             : "\\textbraceright{}";
    rest.remove_prefix(brace ? 2 : 1);
  }
  return text;
}

// "A, B and C" as BibTeX has three names, each in braces: a name is one, whatever else is in it. A
// comma is between names only where a list ends with the last "and"; "Doe, Jane" is one name.
std::string names_of(std::string names) {
  constexpr std::string_view comma = ", ";
  constexpr std::string_view between = " and ";
  const std::size_t last = names.rfind(between);
  if (last != std::string::npos && last == names.find(between) &&
      names.find(comma, last) == std::string::npos) {
    for (std::size_t at = names.find(comma); at != std::string::npos; at = names.find(comma)) {
      names.replace(at, comma.size(), between);
    }
  }
  for (std::size_t at = 0; (at = names.find(between, at)) != std::string::npos;) {
    names.replace(at, between.size(), "} and {");
    at += between.size() + 2;
  }
  return names;
}

std::string misc(const std::string& key, const std::string& author, const std::string& title,
                 const std::string& date, const std::string& note) {
  std::string text = fmt::format("@misc{{{},\n", key);
  if (!author.empty()) {
    text += "  author = {{" + names_of(bibtex_text(author)) + "}},\n";
  }
  text += fmt::format("  title  = {{{{{}}}}},\n", title);
  if (!date.empty()) {
    text += fmt::format("  year   = {{{}}},\n", date.substr(0, 4));
  }
  return text + fmt::format("  note   = {{{}}}\n}}\n", bibtex_text(note));
}

// The rest of an entry, to its end.
void write_sources(JsonWriter& json, const CatalogEntry& entry) {
  json.key("status").value(entry.status());
  json.key("construction").value(entry.recipe.construction);
  json.key("credit").begin_object();
  json.key("who").value(entry.credit.who).key("date").value(entry.credit.date);
  json.key("program").value(entry.credit.program).key("command").value(entry.credit.command);
  json.end_object();
  json.key("cites").value(references_of(entry));
  if (!entry.note.empty()) {
    json.key("note").value(entry.note);
  }
  if (!entry.retracted.empty()) {
    json.key("retracted").value(entry.retracted);
  }
  json.key("hash").value(to_hex(entry.checksum)).end_object();
}

}  // namespace

void write_entry(JsonWriter& json, const CatalogEntry& entry) {
  json.begin_object().key("label").value(entry.label()).parameters(entry.parameters);
  json.key("b").value(entry.b).key("lower_bound").value(entry.lower_bound);
  json.key("reason").value(entry.reason);
  write_sources(json, entry);
}

void write_entry_beside(JsonWriter& json, const CatalogEntry& entry, const Bound& of_cell) {
  json.begin_object().key("label").value(entry.label()).key("b").value(entry.b);
  if (entry.lower_bound != of_cell.blocks) {
    json.key("lower_bound").value(entry.lower_bound);
  }
  if (entry.reason != of_cell.reason) {
    json.key("reason").value(entry.reason);
  }
  write_sources(json, entry);
}

std::string credit_words(const Credit& credit) {
  std::string words;
  for (const std::string& part : {credit.command, credit.who, credit.program, credit.date}) {
    words += (words.empty() || part.empty() ? "" : "; ") + part;
  }
  return words;
}

std::string entry_row(const CatalogEntry& entry) {
  return fmt::format("{:<34} b = {:<7} bound {:<7} {:<11} {:<20} {}", entry.label(), entry.b,
                     entry.lower_bound, entry.status(), entry.recipe.construction,
                     entry.credit.date);
}

std::vector<std::string> references_of(const CatalogEntry& entry) {
  std::vector<std::string> keys = entry.cites;
  collect(entry.recipe, keys);
  for (const std::string& key : reporters_of(entry.parameters, entry.b)) {
    if (std::ranges::find(keys, key) == keys.end()) {
      keys.push_back(key);
    }
  }
  return keys;
}

std::string bibtex_of(const CatalogEntry& entry) {
  std::string text =
      misc("changeover-" + entry.label(), entry.credit.who,
           fmt::format("{} with {}", name(entry.parameters), count_of(entry.b, "block")),
           entry.credit.date,
           fmt::format("Changeover {}, catalog label {}, SHA-256 of the blocks {}{}{}", version,
                       entry.label(), to_hex(entry.checksum), entry.note.empty() ? "" : "; ",
                       entry.note));
  for (const std::string& key : references_of(entry)) {
    const std::string reference = bibtex_of(key);
    text +=
        "\n" + (reference.empty() ? "% " + key + " is not in docs/references.bib\n" : reference);
  }
  return text;
}

std::string bibtex_of(const Catalog& catalog) {
  Sha256 hash;
  std::uint64_t count = 0;
  std::string latest;
  catalog.each({.best_only = false}, [&](const CatalogEntry& entry) {
    if (catalog.is_shipped(entry.label())) {
      ++count;
      latest = std::max(latest, entry.credit.date);
      hash.add(entry.checksum);
    }
    return true;
  });
  return misc("changeover-catalog-" + latest, "The Changeover developers",
              "A catalog of change covering designs", latest,
              fmt::format("Changeover {}; {} as of {}; SHA-256 of their checksums {}", version,
                          count_of(count, "design"), latest, to_hex(hash.finish())));
}

Completeness completeness(const Catalog& catalog, const CatalogFilter& filter) {
  Completeness tallies;
  catalog.each(filter, [&](const CatalogEntry& entry) {
    const Parameters& p = entry.parameters;
    Tally& tally = tallies[{p.strength, p.change, p.kind, p.k}];
    ++tally.cells;
    tally.minimum += entry.status() == "minimum" ? 1U : 0U;
    tally.v_from = std::min(tally.v_from, p.v);
    tally.v_to = std::max(tally.v_to, p.v);
    tally.ratios += static_cast<double>(entry.b) / static_cast<double>(entry.lower_bound);
    return true;
  });
  return tallies;
}

std::string completeness_json(const Completeness& found) {
  JsonWriter json;
  json.objects(found, [&](const auto& cells) {
    const auto& [key, tally] = cells;
    const auto& [strength, change, kind, k] = key;
    json.key("strength").value(std::uint64_t{strength}).key("change").value(change);
    json.key("kind").value(to_string(kind)).key("k").value(k).key("v_from").value(tally.v_from);
    json.key("v_to").value(tally.v_to).key("cells").value(tally.cells);
    json.key("minimum").value(tally.minimum).key("mean_ratio").value(tally.mean_ratio());
  });
  return json.take();
}

std::string today() {
  const std::chrono::year_month_day day{
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())};
  return fmt::format("{:04}-{:02}-{:02}", int{day.year()}, unsigned{day.month()},
                     unsigned{day.day()});
}

}  // namespace changeover::cli
