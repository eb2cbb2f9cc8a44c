// XML as a sequence of events, read one piece at a time, so that its length does not matter.
//
//     XmlReader reader(name, handler);
//     while (more) reader.feed(piece);
//     reader.finish();
//
// Names come without their name space. Documents that declare entities, or use one that is not
// XML's own, are refused, so that events show only text of the file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/scan/place.hpp"

namespace changeover {

/// The attributes of one element; lives as long as the event.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}

  /// The value of an attribute. Name it without its name space.
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char* const* pairs_;
};

/// Receives the events of one document. Its exceptions pass through XmlReader.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  virtual void begin(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end(std::string_view name) = 0;
  /// A piece of text: one text may come in several.
  virtual void text(std::string_view piece) = 0;
  /// A processing instruction, <?target words?>.
  virtual void instruction(std::string_view /*target*/, std::string_view /*words*/) {}

 protected:
  XmlHandler() = default;
  XmlHandler(const XmlHandler&) = default;
  XmlHandler& operator=(const XmlHandler&) = default;
};

class XmlReader {
 public:
  /// `name` is the document's name in messages; the handler must outlive this.
  XmlReader(std::string name, XmlHandler& handler);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// Reads one piece. @throws BadInput with line and column if it is not XML, declares entities,
  /// nests deeper than 256 levels or has a tag of more than 1 MiB; exceptions of the handler.
  void feed(std::string_view piece);

  /// Ends the document. @throws BadInput if it is not complete.
  void finish();

  /// The place of the current event.
  [[nodiscard]] Place place() const;
  /// The same, in bytes.
  [[nodiscard]] std::size_t offset() const;
  /// @throws BadInput there.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover
