// A file that appears whole or not at all.
//
//     OutputFile file("mine.json");          // "" or "-": standard output
//     write_json(design, file);
//     file.commit();                         // only now does mine.json change
//
// The bytes go to a temporary file beside the target, which is renamed onto it by commit(); without
// commit() the destructor removes the temporary and an old file stays as it was. A new file gets
// the usual permissions, a replaced one keeps those it had; a symbolic link keeps pointing to its
// target, and the target is replaced. Anything but a regular file (/dev/null, a FIFO, standard
// output) is written directly, so bytes that left the buffer stay written.
//
// A process that is killed cannot run destructors: call remove_unfinished_outputs() in your own
// handler, or remove_unfinished_outputs_on_signals() once in main().
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace changeover {

// A Sink takes the bytes of writers: a file (above), a string, or a class of your own.
//
//     StringSink sink;
//     write_text(design, sink);
//     sink.text();

/// A place for bytes. Writers pass large pieces, so the virtual calls cost nothing.
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

/// A buffered output file; not copyable, not shared between threads.
class OutputFile final : public Sink {
 public:
  /// Opens `path` for writing; "" and "-" are standard output.
  /// @throws MissingResource with one line: the path, the system's error, how to correct it.
  explicit OutputFile(const std::string& path);
  ~OutputFile() override;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws MissingResource if the disk is full, …; its subclass ReaderGone if a pipe is closed
  /// and the process ignores SIGPIPE.
  void write(std::string_view bytes) override;

  /// Passes the buffer to the system. A regular file stays invisible until commit().
  void flush();

  /// Flushes, makes the bytes and the name durable and puts the file in place; nothing may be
  /// written afterwards.
  /// @throws MissingResource as write(), and again if a write() or flush() before failed: a file
  /// that is not whole is never put in place. The old file is then intact.
  void commit();

  /// The file that holds the bytes until commit(), for reading it back after flush() or for handing
  /// it to a library that writes files itself; the target if that is written directly, empty for
  /// standard output.
  [[nodiscard]] std::string path_until_commit() const;

  /// Whether the bytes go to standard output.
  [[nodiscard]] bool is_standard_output() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Removes the temporaries of all OutputFiles that are open. Async-signal-safe.
void remove_unfinished_outputs() noexcept;

/// Makes SIGINT, SIGTERM and SIGHUP remove the temporaries and then end the process as they would
/// have. A signal that is ignored or already handled is left alone.
void remove_unfinished_outputs_on_signals();

}  // namespace changeover
