#include "io/workbook/workbook_parts.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/parsed.hpp"
#include "io/scan/xml_events.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_shared_bytes = std::uint64_t{1} << 26;

std::optional<std::uint64_t> natural(std::optional<std::string_view> text) {
  return text ? parsed<std::uint64_t>(*text) : std::nullopt;
}

bool is_true(std::optional<std::string_view> text) { return text == "1" || text == "true"; }

// Reads a whole member; false if there is none, as there need not be for relations.
bool read_member(const ZipArchive& archive, const std::string& file, const std::string& member,
                 XmlHandler& handler) {
  auto opened = archive.open(member, most_shared_bytes);
  if (!opened) {
    return false;
  }
  XmlReader reader(file + ":" + member, handler);
  for (std::string piece = opened->next(); !piece.empty(); piece = opened->next()) {
    reader.feed(piece);
  }
  reader.finish();
  return true;
}

// The same of one that the workbook names: without it cells would say something else.
void read_part(const ZipArchive& archive, const std::string& file, const std::string& member,
               XmlHandler& handler) {
  if (!read_member(archive, file, member, handler)) {
    throw BadInput(fmt::format("{}: its part {} is missing; save it again", file, member));
  }
}

// A handler that looks at tags only.
class Tags final : public XmlHandler {
 public:
  using OnBegin = std::function<void(std::string_view, const XmlAttributes&)>;
  using OnEnd = std::function<void(std::string_view)>;
  explicit Tags(OnBegin on_begin, OnEnd on_end = {})
      : on_begin_(std::move(on_begin)), on_end_(std::move(on_end)) {}

  void begin(std::string_view name, const XmlAttributes& attributes) override {
    on_begin_(name, attributes);
  }
  void end(std::string_view name) override {
    if (on_end_) {
      on_end_(name);
    }
  }
  void text(std::string_view /*piece*/) override {}

 private:
  OnBegin on_begin_;
  OnEnd on_end_;
};

struct Relation {
  std::string kind;  // the last word of its type: worksheet, sharedStrings, …
  std::string member;
};

// "xl/workbook.xml" and "worksheets/sheet1.xml" make "xl/worksheets/sheet1.xml".
std::string resolved(const std::string& from, std::string_view target) {
  std::string path = target.starts_with('/') ? std::string() : from.substr(0, from.rfind('/') + 1);
  for (std::size_t at = 0; at <= target.size();) {
    const std::size_t end = std::min(target.find('/', at), target.size());
    const std::string_view step = target.substr(at, end - at);
    if (step == "..") {
      const std::size_t up = path.size() < 2 ? std::string::npos : path.rfind('/', path.size() - 2);
      path.resize(up == std::string::npos ? 0 : up + 1);
    } else if (!step.empty() && step != ".") {
      path += std::string(step) + "/";
    }
    at = end + 1;
  }
  return path.empty() ? path : path.substr(0, path.size() - 1);
}

std::map<std::string, Relation> relations_of(const ZipArchive& archive, const std::string& file,
                                             const std::string& member) {
  std::map<std::string, Relation> relations;
  Tags tags([&](std::string_view name, const XmlAttributes& attributes) {
    const auto id = attributes.find("Id");
    const auto type = attributes.find("Type");
    const auto target = attributes.find("Target");
    if (name == "Relationship" && id && type && target &&
        attributes.find("TargetMode") != "External") {
      relations[std::string(*id)] = {std::string(type->substr(type->rfind('/') + 1)),
                                     resolved(member, *target)};
    }
  });
  const std::size_t folder = member.rfind('/') + 1;
  read_member(archive, file, member.substr(0, folder) + "_rels/" + member.substr(folder) + ".rels",
              tags);
  return relations;
}

std::string member_of_kind(const std::map<std::string, Relation>& relations,
                           const std::string& kind) {
  for (const auto& [id, relation] : relations) {
    if (relation.kind == kind) {
      return relation.member;
    }
  }
  return {};
}

// The texts that cells refer to by number; how a word is read aloud is left out.
class Texts final : public XmlHandler {
 public:
  Texts(std::vector<std::string>& texts, std::string file)
      : texts_(&texts), file_(std::move(file)) {}

  void begin(std::string_view name, const XmlAttributes& /*attributes*/) override {
    if (name == "si") {
      texts_->emplace_back();
    }
    aloud_ = aloud_ || name == "rPh";
    in_text_ = name == "t" && !aloud_;
  }
  void end(std::string_view name) override {
    in_text_ = false;
    if (name == "rPh") {
      aloud_ = false;
    } else if (name == "si") {
      texts_->back() = without_escapes(texts_->back());
    }
  }
  void text(std::string_view piece) override {
    if (!in_text_ || texts_->empty()) {
      return;
    }
    texts_->back() += piece;
    if (texts_->back().size() > longest_cell) {
      throw BadInput(file_ + ": a cell of more than 32,767 characters; this is not a list");
    }
  }

 private:
  std::vector<std::string>* texts_;
  std::string file_;
  bool in_text_ = false;
  bool aloud_ = false;
};

std::vector<NumberStyle> styles_in(const ZipArchive& archive, const std::string& file,
                                   const std::string& member) {
  std::vector<NumberStyle> styles;
  std::map<std::uint64_t, NumberStyle> own;
  bool of_cells = false;
  Tags tags(
      [&](std::string_view name, const XmlAttributes& attributes) {
        const auto number = natural(attributes.find("numFmtId"));
        const auto code = attributes.find("formatCode");
        if (name == "numFmt" && number && code) {
          own[*number] = style_of_format(*code);
        } else if (name == "cellXfs") {
          of_cells = true;
        } else if (name == "xf" && of_cells) {
          const auto found = own.find(number.value_or(0));
          styles.push_back(found != own.end() ? found->second
                                              : style_of_built_in(number.value_or(0)));
        }
      },
      [&](std::string_view name) { of_cells = of_cells && name != "cellXfs"; });
  read_part(archive, file, member, tags);
  return styles;
}

}  // namespace

WorkbookParts workbook_parts(const ZipArchive& archive, const std::string& file) {
  const auto fail = [&](std::string_view what) -> void {
    throw BadInput(fmt::format("{}: {}", file, what));
  };
  if (auto type = archive.open("mimetype", most_shared_bytes)) {
    if (type->next().find("opendocument") != std::string::npos) {
      fail("an OpenDocument file; save it as an Excel workbook (.xlsx) or as CSV");
    }
  }
  const std::string book = member_of_kind(relations_of(archive, file, ""), "officeDocument");
  if (book.ends_with(".bin") || archive.has("xl/workbook.bin")) {
    fail("a binary workbook (.xlsb); save it as an Excel workbook (.xlsx) or as CSV");
  }
  if (book.empty()) {
    fail("a zip archive, but no workbook; give a list as CSV or .xlsx");
  }
  const auto relations = relations_of(archive, file, book);
  WorkbookParts parts;
  Tags tags([&](std::string_view name, const XmlAttributes& attributes) {
    if (name == "workbookPr") {
      parts.from_1904 = is_true(attributes.find("date1904"));
    } else if (name == "sheet") {
      WorkbookParts::Sheet sheet;
      sheet.name = attributes.find("name").value_or("");
      sheet.hidden = attributes.find("state").value_or("visible") != "visible";
      const auto relation = relations.find(std::string(attributes.find("id").value_or("")));
      if (relation != relations.end() && relation->second.kind == "worksheet") {
        sheet.member = relation->second.member;
      }
      parts.sheets.push_back(std::move(sheet));
    }
  });
  read_part(archive, file, book, tags);
  if (const std::string member = member_of_kind(relations, "sharedStrings"); !member.empty()) {
    Texts texts(parts.texts, file);
    read_part(archive, file, member, texts);
  }
  if (const std::string member = member_of_kind(relations, "styles"); !member.empty()) {
    parts.styles = styles_in(archive, file, member);
  }
  return parts;
}

}  // namespace changeover
