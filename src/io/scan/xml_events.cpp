#include "io/scan/xml_events.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "core/printable.hpp"

namespace changeover {
namespace {

constexpr char name_space_end = '|';
constexpr std::size_t max_xml_depth = 256;
constexpr std::size_t longest_tag = std::size_t{1} << 20;

std::string_view local(std::string_view name) {
  const std::size_t end = name.rfind(name_space_end);
  return end == std::string_view::npos ? name : name.substr(end + 1);
}

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char* const* pair = pairs_; *pair != nullptr; pair += 2) {
    if (local(*pair) == name) {
      return pair[1];
    }
  }
  return std::nullopt;
}

// The parser is C: no exception may pass through it, so the first one is kept and the parser
// stopped.
struct XmlReader::State {
  State(std::string called, XmlHandler& who)
      : name(std::move(called)),
        handler(&who),
        parser(XML_ParserCreateNS(nullptr, name_space_end)) {
    if (parser == nullptr) {
      throw std::bad_alloc();
    }
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const char* tag, const char** attributes) {
          of(self).guarded([&] {
            if (++of(self).depth > max_xml_depth) {
              of(self).fail(fmt::format("nested more than {} deep", max_xml_depth));
            }
            of(self).handler->begin(local(tag), XmlAttributes(attributes));
          });
        },
        [](void* self, const char* tag) {
          of(self).guarded([&] {
            --of(self).depth;
            of(self).handler->end(local(tag));
          });
        });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
      of(self).guarded([&] {
        of(self).handler->text(std::string_view(text, static_cast<std::size_t>(length)));
      });
    });
    XML_SetProcessingInstructionHandler(
        parser, [](void* self, const char* target, const char* words) {
          of(self).guarded([&] { of(self).handler->instruction(target, words); });
        });
    XML_SetEntityDeclHandler(parser, [](void* self, const char*, int, const char*, int, const char*,
                                        const char*, const char*, const char*) {
      of(self).guarded([&] { of(self).fail("an entity is declared; write out its text"); });
    });
    XML_SetSkippedEntityHandler(parser, [](void* self, const char* entity, int) {
      of(self).guarded([&] {
        of(self).fail(
            fmt::format("the entity {} is not declared; write out its text", shown(entity)));
      });
    });
  }
  ~State() { XML_ParserFree(parser); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  static State& of(void* self) { return *static_cast<State*>(self); }

  [[nodiscard]] Place place() const {
#ifdef XML_ATTR_DEPRECATED  // since Expat 2.9, whose older names draw a warning
    return {XML_GetCurrentLineNumber64(parser), XML_GetCurrentColumnNumber64(parser) + 1};
#else
    return {XML_GetCurrentLineNumber(parser), XML_GetCurrentColumnNumber(parser) + 1};
#endif
  }
  // The place of the event in bytes from the beginning; negative if it is not known.
  [[nodiscard]] std::int64_t offset() const {
#ifdef XML_ATTR_DEPRECATED
    return XML_GetCurrentByteIndex64(parser);
#else
    return XML_GetCurrentByteIndex(parser);
#endif
  }
  [[noreturn]] void fail(std::string_view what) const { changeover::fail(name, place(), what); }

  template <typename Work>
  void guarded(Work&& work) {
    if (fault) {
      return;
    }
    try {
      work();
    } catch (...) {
      fault = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }

  void parse(std::string_view piece, bool is_last) {
    constexpr std::size_t at_once = std::size_t{1} << 16;
    do {
      const std::string_view part = piece.substr(0, at_once);
      piece.remove_prefix(part.size());
      const auto status = XML_Parse(parser, part.data(), static_cast<int>(part.size()),
                                    is_last && piece.empty() ? XML_TRUE : XML_FALSE);
      if (fault) {
        std::rethrow_exception(std::exchange(fault, nullptr));
      }
      if (status == XML_STATUS_ERROR) {
        const XML_Error error = XML_GetErrorCode(parser);
        if (error == XML_ERROR_NO_MEMORY) {
          throw std::bad_alloc();
        }
        fail(fmt::format("not XML: {}; correct it", XML_ErrorString(error)));
      }
      fed += part.size();
      // The parser looks at an unfinished tag again with each piece.
      const std::int64_t done = offset();
      if (done >= 0 && fed - static_cast<std::uint64_t>(done) > longest_tag) {
        fail(fmt::format("a tag of more than {} MiB", longest_tag >> 20));
      }
    } while (!piece.empty());
  }

  std::string name;
  XmlHandler* handler;
  XML_Parser parser;
  std::exception_ptr fault;
  std::size_t depth = 0;
  std::uint64_t fed = 0;
};

XmlReader::XmlReader(std::string name, XmlHandler& handler)
    : state_(std::make_unique<State>(std::move(name), handler)) {}

XmlReader::~XmlReader() = default;

void XmlReader::feed(std::string_view piece) {
  if (!piece.empty()) {
    state_->parse(piece, false);
  }
}

void XmlReader::finish() { state_->parse({}, true); }

Place XmlReader::place() const { return state_->place(); }

std::size_t XmlReader::offset() const {
  return static_cast<std::size_t>(std::max<std::int64_t>(0, state_->offset()));
}

void XmlReader::fail(std::string_view what) const { state_->fail(what); }

}  // namespace changeover
