// Where writers put their bytes: a file (io/output_file.hpp), a string, or something of your own.
//
//     StringSink sink;
//     write_text(design, sink);
//     sink.text();
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace changeover {

/// A place for bytes. Writers hand over large pieces, so a virtual call costs nothing.
class Sink {
 public:
  virtual ~Sink() = default;

  /// Takes all of `bytes`. @throws MissingResource if they cannot be stored.
  virtual void write(std::string_view bytes) = 0;

 protected:
  Sink() = default;
  Sink(const Sink&) = default;
  Sink& operator=(const Sink&) = default;
};

/// A string that grows.
class StringSink final : public Sink {
 public:
  void write(std::string_view bytes) override { text_.append(bytes); }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace changeover
