#include "plan/job/parts/heading_words.hpp"

#include <algorithm>
#include <array>

#include "core/words.hpp"

namespace changeover {
namespace {

template <std::size_t N>
bool is_among(std::string_view word, const std::array<std::string_view, N>& all) {
  return std::ranges::find(all, word) != all.end();
}

template <std::size_t N>
bool has_one_of(const std::vector<std::string>& words, const std::array<std::string_view, N>& all) {
  return std::ranges::any_of(words, [&](const std::string& word) { return is_among(word, all); });
}

constexpr auto of_minutes = std::to_array<std::string_view>(
    {"min", "mins", "minute", "minutes", "minuten", "minutos", "minuti", "minuut", "分"});
constexpr auto of_hours = std::to_array<std::string_view>(
    {"h", "hr", "hrs", "hour", "hours", "stunde", "stunden", "heure", "heures", "hora", "horas",
     "ora", "ore", "uur", "uren", "小时", "시간"});
constexpr auto of_seconds =
    std::to_array<std::string_view>({"s", "sec", "secs", "seconds", "sek", "sekunden", "secondes",
                                     "segundos", "secondi", "seconden", "秒"});

CostUnit unit_of(const std::vector<std::string>& words) {
  return has_one_of(words, of_minutes)   ? CostUnit::minutes
         : has_one_of(words, of_hours)   ? CostUnit::hours
         : has_one_of(words, of_seconds) ? CostUnit::seconds
                                         : CostUnit::none;
}

// The unit of "Swap (min)", but none for "Part(s)".
CostUnit unit_in_brackets(std::string_view text) {
  const std::size_t open = text.find_last_of("([");
  const bool is_plural = open != std::string_view::npos && open > 0 && text[open - 1] != ' ' &&
                         text.substr(open).starts_with("(s)");
  return open == std::string_view::npos || is_plural ? CostUnit::none
                                                     : unit_of(heading_words(text.substr(open)));
}

// "part 2", "part_b" or "part2" without the number or letter.
std::string without_number(std::string word) {
  const std::size_t last = word.find_last_of(" _-#");
  if (last != std::string::npos && last + 2 == word.size()) {
    word.resize(word.find_last_not_of(" _-#", last) + 1);
  } else if (word.size() > 1 && word.back() >= '0' && word.back() <= '9') {
    word.pop_back();
  }
  return word;
}

constexpr auto words_of_parts = std::to_array<std::string_view>(
    {"name",    "part",    "component", "item",       "sample",   "product", "article",
     "device",  "module",  "specimen",  "element",    "wine",     "first",   "second",
     "parts",   "names",   "teil",      "bauteil",    "probe",    "muster",  "from",
     "to",      "pièce",   "unit",      "components", "items",    "samples", "products",
     "devices", "modules", "units",     "teile",      "bauteile", "proben",  "pièces"});

// All words of the heading, so that "Stock code" and "Number of ports" are none.
constexpr auto words_of_quantities = std::to_array<std::string_view>(
    {"quantity", "quantities", "qty",      "count",       "stock",   "pieces",       "pcs",
     "anzahl",   "menge",      "stück",    "stückzahl",   "bestand", "lagerbestand", "quantité",
     "quantite", "combien",    "cantidad", "existencias", "cuántos", "quantità",     "quantita",
     "giacenza", "quantidade", "aantal",   "voorraad",    "数量",    "수량",         "個数"});
constexpr auto phrases_of_quantities = std::to_array<std::string_view>({"qty pcs",
                                                                        "in stock",
                                                                        "on stock",
                                                                        "on hand",
                                                                        "how many",
                                                                        "how many parts",
                                                                        "how many pieces",
                                                                        "how many there are",
                                                                        "how many are there",
                                                                        "number of pieces",
                                                                        "number of parts",
                                                                        "number of units",
                                                                        "no of pieces",
                                                                        "no of units",
                                                                        "stock qty",
                                                                        "stock quantity",
                                                                        "stock count",
                                                                        "qty in stock",
                                                                        "quantity in stock",
                                                                        "units in stock",
                                                                        "pieces in stock",
                                                                        "qty on hand",
                                                                        "quantity on hand",
                                                                        "qty available",
                                                                        "quantity available",
                                                                        "wie viele"});

}  // namespace

std::vector<std::string> heading_words(std::string_view text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  std::vector<std::string> words(1);
  char before = ' ';
  for (const char c : text) {
    const bool is_letter = is_small(c) || is_capital(c) || static_cast<unsigned char>(c) >= 0x80;
    if ((!is_letter || (is_capital(c) && is_small(before))) && !words.back().empty()) {
      words.emplace_back();
    }
    if (is_letter) {
      words.back() += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
    }
    before = c;
  }
  return words;
}

bool heads_parts(std::string_view text) {
  return is_among(without_number(lower_case(text)), words_of_parts);
}

bool heads_names(std::string_view text) {
  constexpr auto others = std::to_array<std::string_view>(
      {"model",       "description", "label",    "material",    "reagent",      "reagents",
       "solvent",     "solvents",    "chemical", "ingredient",  "equipment",    "hardware",
       "paint",       "colour",      "color",    "bezeichnung", "beschreibung", "designation",
       "désignation", "nombre",      "nom",      "nome",        "naam"});
  // "Part number" identifies parts only for people who know the numbers.
  constexpr auto numbers = std::to_array<std::string_view>(
      {"number", "no", "nr", "id", "sku", "code", "serial", "count", "cost", "price"});
  const std::vector<std::string> words = heading_words(text);
  return (has_one_of(words, words_of_parts) || has_one_of(words, others)) &&
         !has_one_of(words, numbers) && !heads_costs(text) && !heads_times(text) &&
         !heads_quantities(text);
}

bool heads_row_numbers(std::string_view text) {
  constexpr auto all =
      std::to_array<std::string_view>({"#", "no", "no.", "nr", "nr.", "n°", "№", "id", "index",
                                       "pos", "pos.", "line", "row", "lfd. nr.", "num", "number"});
  return is_among(lower_case(text), all);
}

bool heads_costs(std::string_view text) {
  // Whole words: not "Europe" or "precision".
  constexpr auto alone = std::to_array<std::string_view>(
      {"cost",    "costs", "price",  "prices", "pricing", "preis",  "preise", "preises", "kosten",
       "aufwand", "prix",  "coût",   "coûts",  "cout",    "couts",  "precio", "precios", "coste",
       "costes",  "costo", "costos", "costi",  "prezzo",  "prezzi", "preço",  "preços",  "preco",
       "precos",  "custo", "custos", "prijs",  "prijzen", "eur",    "euro",   "euros",   "usd",
       "gbp",     "chf",   "€",      "£",      "dollar",  "dollars"});
  // Ends of longer words: "Umbaukosten", "unitprice", but not "caprice".
  constexpr auto ends = std::to_array<std::string_view>(
      {"cost", "costs", "price", "prices", "preis", "preise", "kosten", "aufwand"});
  constexpr std::size_t least_before = 3;
  const std::vector<std::string> words = heading_words(text);
  return has_one_of(words, alone) || std::ranges::any_of(words, [&](const std::string& word) {
           return std::ranges::any_of(ends, [&](std::string_view end) {
             return word.size() >= end.size() + least_before && word.ends_with(end);
           });
         });
}

bool heads_times(std::string_view text) {
  constexpr auto alone = std::to_array<std::string_view>(
      {"time",   "times",    "duration", "durations", "effort",   "efforts", "labour",  "labor",
       "zeit",   "zeiten",   "dauer",    "umbauzeit", "rüstzeit", "temps",   "durée",   "duree",
       "tiempo", "duración", "duracion", "tempo",     "durata",   "duração", "duracao", "tijd",
       "duur",   "時間",     "所要時間", "时间",      "工时"});
  // "Lead time" is not work, and "Date/Time" is a point in time.
  constexpr auto others = std::to_array<std::string_view>(
      {"date", "lead", "delivery", "run", "up", "start", "end", "stamp", "zone", "last", "created",
       "modified", "purchase", "warranty", "life", "test"});
  // "Min" may also mean the minimum.
  constexpr auto units = std::to_array<std::string_view>(
      {"minutes", "mins", "minuten", "minutos", "minuti", "hours", "hrs", "stunden", "heures",
       "horas", "ore", "uren", "seconds", "secs", "sekunden", "secondes", "segundos", "secondi"});
  const std::vector<std::string> words = heading_words(text);
  return (has_one_of(words, alone) || has_one_of(words, units) ||
          unit_in_brackets(text) != CostUnit::none) &&
         !has_one_of(words, others);
}

bool is_of_changes(std::string_view text) {
  constexpr auto beginnings = std::to_array<std::string_view>(
      {"change", "swap", "mount", "replac", "install", "wechsel", "umbau", "einbau", "rüst",
       "clean", "reinig", "setup", "fitting"});
  const std::vector<std::string> words = heading_words(text);
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::any_of(beginnings,
                               [&](std::string_view each) { return word.starts_with(each); });
  });
}

CostUnit unit_in_heading(std::string_view text) {
  const CostUnit unit = unit_in_brackets(text);
  return unit == CostUnit::none && heads_times(text) ? unit_of(heading_words(text)) : unit;
}

bool heads_slots(std::string_view text) {
  const std::string word = lower_case(text);
  constexpr auto all = std::to_array<std::string_view>(
      {"slot", "slots", "slot type", "slot name", "slot kind", "type of slot"});
  return is_among(word, all);
}

bool heads_quantities(std::string_view text) {
  std::string words;
  for (const std::string& word : heading_words(text)) {
    words += (words.empty() || word.empty() ? "" : " ") + word;
  }
  return is_among(words, words_of_quantities) || is_among(words, phrases_of_quantities);
}

bool heads_least(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"least", "at least", "min", "min.", "minimum", "from", "lower", "fewest", "mindestens",
       "von", "au moins", "de", "mínimo", "minimo"});
  return is_among(lower_case(text), all);
}

bool heads_most(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>({"most", "at most", "max", "max.", "maximum",
                                                        "to", "up to", "upper", "höchstens", "bis",
                                                        "au plus", "à", "máximo", "massimo"});
  return is_among(lower_case(text), all);
}

bool heads_weights(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"weight", "weights", "priority", "prio", "worth", "importance", "value", "gewicht",
       "priorität", "wichtigkeit", "poids", "priorité", "peso", "prioridad"});
  return is_among(lower_case(text), all);
}

bool heads_reasons(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"why",    "reason", "reasons",   "because",   "comment",     "comments",
       "note",   "notes",  "remark",    "remarks",   "explanation", "cause",
       "warum",  "grund",  "bemerkung", "kommentar", "begründung",  "pourquoi",
       "raison", "motivo", "razón",     "remarque"});
  return is_among(lower_case(text), all);
}

bool heads_remarks(std::string_view text) {
  return std::ranges::any_of(heading_words(text), heads_reasons);
}

bool heads_part_of_pair(std::string_view text) {
  constexpr auto others = std::to_array<std::string_view>(
      {"a", "b", "x", "y", "with", "not with", "and", "never with", "left", "right", "one", "other",
       "this", "that", "mit", "nicht mit", "und", "avec", "con"});
  const std::string word = lower_case(text);
  return heads_parts(text) || is_among(word, others) || heads_names(without_number(word));
}

bool heads_results(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"result",     "results",    "outcome",   "outcomes",     "verdict",      "verdicts",
       "ergebnis",   "ergebnisse", "resultat",  "testergebnis", "prüfergebnis", "befund",
       "résultat",   "résultats",  "resultado", "resultados",   "risultato",    "risultati",
       "esito",      "resultaat",  "uitslag",   "結果",         "结果",         "결과",
       "testresult", "pass",       "passed"});
  return has_one_of(heading_words(text), all);
}

bool heads_occasions(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"date",     "dates",   "day",       "time",     "when",     "datum",    "tag",
       "zeit",     "uhrzeit", "wann",      "jour",     "heure",    "quand",    "fecha",
       "día",      "dia",     "hora",      "cuándo",   "data",     "giorno",   "ora",
       "quando",   "dag",     "tijd",      "日付",     "日時",     "日期",     "时间",
       "날짜",     "시간",    "tester",    "operator", "by",       "initials", "prüfer",
       "bediener", "kürzel",  "opérateur", "operador", "operatore"});
  return has_one_of(heading_words(text), all);
}

bool heads_steps(std::string_view text) {
  constexpr auto all = std::to_array<std::string_view>(
      {"step", "steps", "test", "tests", "schritt", "étape", "etape", "paso", "passo", "stap",
       "essai", "prueba", "prova", "teste", "ステップ", "步骤", "단계"});
  constexpr auto beside =
      std::to_array<std::string_view>({"no", "nr", "number", "nummer", "num", "id", ""});
  const std::vector<std::string> words = heading_words(text);
  return has_one_of(words, all) && std::ranges::all_of(words, [&](const std::string& word) {
           return is_among(word, all) || is_among(word, beside);
         });
}

}  // namespace changeover
