// A user's database of designs whose content is anything: the bytes of the file, or rows between
// tabs, a line each, that are put into one which is well made. It is read, or left aside in one
// line; what is read is what it says; what is damaged is not written to.
#include <algorithm>
#include <array>
#include <sstream>

#include "catalog/store/schema.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/curator/curator.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::database_fuzz {
namespace {

struct Table {
  std::string_view name;
  std::string_view sql;
  int columns;
};
constexpr std::array tables{
    Table{"credit", "INSERT INTO credit VALUES(?,?)", 2},
    Table{"design", "INSERT INTO design VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?)", 13},
    Table{"retraction", "INSERT INTO retraction VALUES(?,?)", 2},
    Table{"alias", "INSERT INTO alias VALUES(?,?)", 2}};

// What the tables take of the rows.
void make_database(const std::string& path, const std::string& rows) {
  const Database database = Database::open(path, Access::create);
  make_tables(database);
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == '\t') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    const auto* const table = std::ranges::find(tables, fields.front(), &Table::name);
    if (table == tables.end()) {
      continue;
    }
    fields.resize(static_cast<std::size_t>(table->columns) + 1);
    Statement insert = database.prepare(table->sql);
    for (int i = 1; i <= table->columns; ++i) {
      insert.bind(i, std::string_view(fields[static_cast<std::size_t>(i)]));
    }
    try {
      insert.step();
    } catch (const Error&) {
      continue;  // The tables do not take such a row.
    }
  }
}

CatalogEntry a_design() {
  return entry_from_line(
      R"({"label":"4.3.1.linear.3.fdc879cf","b":3,"lower_bound":3,"reason":"counting","recipe":)"
      R"({"construction":"literal","v":4,"k":3,"change":1,"kind":"linear","arguments":{},"inputs":[],)"
      R"("blocks":[[0,1,2],[0,1,3],[0,2,3]]},)"
      R"("sha256":"fdc879cf58d819b2f1550061bf579ec55c0ec7cd10f723344cd6bba2b4e4cf12"})",
      "a design", 1, {});
}

void look_at(const Catalog& catalog) {
  std::vector<std::string> labels{"4.3.1.linear.3.fdc879cf", "6.4", "", "mine"};
  for (const bool best_only : {true, false}) {
    for (const char* const status : {"", "retracted"}) {
      accepts([&] {
        catalog.each({.status = status, .best_only = best_only}, [&](const CatalogEntry& entry) {
          check(entry.parameters);
          must(is_one_plain_line(line_of(entry, {})), "an entry is one line");
          labels.push_back(entry.label());
          return labels.size() < 20;
        });
      });
    }
  }
  for (const std::string& label : labels) {
    accepts([&] {
      if (const auto entry = catalog.find(label)) {
        must(catalog.cell(entry->parameters).empty() ||
                 catalog.cell(entry->parameters).front().parameters == entry->parameters,
             "a cell holds designs of its parameters");
        (void)catalog.best(entry->parameters);
        (void)catalog.history(entry->parameters);
      }
    });
  }
  accepts([&] {
    (void)catalog.size();
    (void)catalog.largest_users_v();
    (void)catalog.fewest({.v = 4, .k = 3, .change = 1});
  });
  accepts([&] {
    RunControl control({.time = std::chrono::milliseconds(500)});
    for (const Audit::Fault& fault :
         audit_catalog(catalog, {.v_to = 60, .best_only = false}, control).faults) {
      must(is_one_plain_line(fault.what), "what is wrong with an entry is one line");
    }
  });
  accepts([&] {
    StringSink sink;
    write_entries(catalog, {.best_only = false}, sink);
    (void)read_catalog(sink.text(), "written");
  });
  must(catalog.problem().empty() || is_one_plain_line(catalog.problem()), "a problem is one line");
}

const Target target("database", [](const std::string& bytes) {
  static const Scratch scratch;
  scratch.empty();
  const std::string path = scratch.file("mine.db");
  if (bytes.starts_with("SQLite format 3") || bytes.empty()) {
    scratch.put("mine.db", bytes);
  } else {
    make_database(path, bytes);
  }
  const auto before = scratch.bytes("mine.db");
  {
    const Catalog catalog({.shipped = {}, .user = path});
    look_at(catalog);
  }
  must(scratch.bytes("mine.db") == before, "reading a database changes nothing in it");
  Catalog catalog({.shipped = {}, .user = path});
  const CatalogEntry entry = a_design();
  if (accepts([&] { catalog.add(entry); })) {
    accepts([&] { must(catalog.find(entry.label()).has_value(), "what was added is found"); });
  } else {
    must(scratch.bytes("mine.db") == before, "what is refused has changed nothing");
  }
});

}  // namespace
}  // namespace changeover::fuzz::database_fuzz
