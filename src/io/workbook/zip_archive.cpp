#include "io/workbook/zip_archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

struct ZipArchive::State {
  std::string bytes;
  std::string name;
  zip_t* archive = nullptr;

  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(fmt::format("{}: {}", name, what));
  }
};

struct ZipArchive::Member::State {
  std::string file;
  std::string member;
  std::uint64_t limit = 0;
  std::uint64_t read = 0;
  zip_file_t* handle = nullptr;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (handle != nullptr) {
      zip_fclose(handle);
    }
  }
};

ZipArchive::ZipArchive(std::string bytes, std::string name)
    : state_(std::make_unique<State>(State{std::move(bytes), std::move(name)})) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source =
      zip_source_buffer_create(state_->bytes.data(), state_->bytes.size(), 0, &error);
  if (source != nullptr) {
    state_->archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (state_->archive == nullptr) {
      zip_source_free(source);
    }
  }
  const std::string what = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (state_->archive == nullptr) {
    state_->fail(
        fmt::format("looks like a zip archive, but cannot be read: {}; it may be cut off, save or "
                    "copy it again",
                    what));
  }
}

ZipArchive::~ZipArchive() {
  if (state_->archive != nullptr) {
    zip_discard(state_->archive);
  }
}

bool ZipArchive::has(const std::string& member) const {
  return zip_name_locate(state_->archive, member.c_str(), ZIP_FL_NOCASE) >= 0;
}

std::optional<ZipArchive::Member> ZipArchive::open(const std::string& member,
                                                   std::uint64_t limit) const {
  const zip_int64_t index = zip_name_locate(state_->archive, member.c_str(), ZIP_FL_NOCASE);
  if (index < 0) {
    return std::nullopt;
  }
  auto opened = std::make_unique<Member::State>();
  opened->file = state_->name;
  opened->member = member;
  opened->limit = limit;
  opened->handle = zip_fopen_index(state_->archive, static_cast<zip_uint64_t>(index), 0);
  if (opened->handle == nullptr) {
    const int code = zip_error_code_zip(zip_get_error(state_->archive));
    state_->fail(code == ZIP_ER_NOPASSWD || code == ZIP_ER_WRONGPASSWD
                     ? "its members need a password; save it without one"
                     : fmt::format("cannot unpack {}: {}; save it again", member,
                                   zip_strerror(state_->archive)));
  }
  return Member(std::move(opened));
}

ZipArchive::Member::Member(std::unique_ptr<State> state) : state_(std::move(state)) {}
ZipArchive::Member::Member(Member&&) noexcept = default;
ZipArchive::Member& ZipArchive::Member::operator=(Member&&) noexcept = default;
ZipArchive::Member::~Member() = default;

std::string ZipArchive::Member::next() {
  stop_if_asked();
  constexpr std::size_t piece = std::size_t{1} << 14;
  std::string bytes(piece, '\0');
  const zip_int64_t count = zip_fread(state_->handle, bytes.data(), bytes.size());
  if (count < 0) {
    throw BadInput(fmt::format("{}: {} is damaged: {}; copy or save it again", state_->file,
                               state_->member, zip_file_strerror(state_->handle)));
  }
  bytes.resize(static_cast<std::size_t>(count));
  state_->read += bytes.size();
  if (state_->read > state_->limit) {
    throw BadInput(
        fmt::format("{}: {} has more than {} MiB when it is unpacked; this is not a list",
                    state_->file, state_->member, state_->limit >> 20));
  }
  return bytes;
}

}  // namespace changeover
