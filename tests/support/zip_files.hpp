// Zip archives out of their members, and back.
#pragma once

#include <zip.h>

#include <map>
#include <stdexcept>
#include <string>

namespace changeover::test {

using Members = std::map<std::string, std::string>;

/// An archive of these members, packed; with a password, if one is given.
inline std::string zipped(const Members& members, const char* password = nullptr) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const out = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(out);
  zip_t* const archive = zip_open_from_source(out, ZIP_TRUNCATE, &error);
  for (const auto& [name, text] : members) {
    const zip_int64_t index =
        zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0),
                     ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      throw std::runtime_error("cannot add " + name);
    }
    const auto at = static_cast<zip_uint64_t>(index);
    zip_set_file_compression(archive, at, ZIP_CM_DEFLATE, 1);
    if (password != nullptr) {
      zip_file_set_encryption(archive, at, ZIP_EM_AES_256, password);
    }
  }
  if (zip_close(archive) != 0 || zip_source_open(out) != 0) {
    throw std::runtime_error("cannot pack");
  }
  zip_source_seek(out, 0, SEEK_END);
  std::string bytes(static_cast<std::size_t>(zip_source_tell(out)), '\0');
  zip_source_seek(out, 0, SEEK_SET);
  zip_source_read(out, bytes.data(), bytes.size());
  zip_source_close(out);
  zip_source_free(out);
  return bytes;
}

/// The members of an archive.
inline Members unzipped(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_t* const archive = zip_open_from_source(
      zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error), ZIP_RDONLY, &error);
  if (archive == nullptr) {
    throw std::runtime_error("no archive");
  }
  Members members;
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t status;
    zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &status);
    std::string text(static_cast<std::size_t>(status.size), '\0');
    zip_file_t* const member = zip_fopen_index(archive, static_cast<zip_uint64_t>(i), 0);
    zip_fread(member, text.data(), text.size());
    zip_fclose(member);
    members[status.name] = text;
  }
  zip_discard(archive);
  return members;
}

/// A workbook as programs write it: the XML of its sheets by name, the texts and formats that they
/// share.
inline Members workbook_of(const std::map<std::string, std::string>& sheets,
                           const std::string& texts = "", const std::string& styles = "") {
  const std::string kind = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";
  const std::string space = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
  const auto relation = [&](const std::string& id, const std::string& of, const std::string& to) {
    return "<Relationship Id=\"" + id + "\" Type=\"" + kind + of + "\" Target=\"" + to + "\"/>";
  };
  Members members;
  members["[Content_Types].xml"] = "<Types/>";
  members["_rels/.rels"] =
      "<Relationships>" + relation("r1", "officeDocument", "xl/workbook.xml") + "</Relationships>";
  std::string book;
  std::string relations = relation("t", "sharedStrings", "sharedStrings.xml") +
                          relation("s", "styles", "/xl/styles.xml");
  std::size_t number = 0;
  for (const auto& [name, cells] : sheets) {
    const std::string n = std::to_string(++number);
    book += "<sheet name=\"" + name + "\" sheetId=\"" + n + "\" r:id=\"s" + n + "\"/>";
    relations += relation("s" + n, "worksheet", "worksheets/sheet" + n + ".xml");
    members["xl/worksheets/sheet" + n + ".xml"] =
        "<worksheet xmlns=\"" + space + "\"><sheetData>" + cells + "</sheetData></worksheet>";
  }
  members["xl/workbook.xml"] = "<workbook xmlns=\"" + space + "\" xmlns:r=\"" + kind +
                               "\"><sheets>" + book + "</sheets></workbook>";
  members["xl/_rels/workbook.xml.rels"] = "<Relationships>" + relations + "</Relationships>";
  members["xl/sharedStrings.xml"] = "<sst xmlns=\"" + space + "\">" + texts + "</sst>";
  members["xl/styles.xml"] = "<styleSheet xmlns=\"" + space + "\">" + styles + "</styleSheet>";
  return members;
}

}  // namespace changeover::test
