#include "changeover/loadorder/all_pairs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {

struct FileItems::State {
  std::string path;
  std::uint64_t item_bytes = 0;
  std::uint64_t header_bytes = 0;
  std::uint64_t file_bytes = 0;
  bool bypass = false;
  int file = -1;    // ordinary
  int direct = -1;  // without the page cache, if the file system supports it
  std::atomic<bool> direct_works{false};

  ~State() {
    for (const int descriptor : {file, direct}) {
      if (descriptor >= 0) {
        ::close(descriptor);
      }
    }
  }

  [[nodiscard]] std::uint64_t data_bytes() const { return file_bytes - header_bytes; }

  // Reads until `wanted` bytes are read, the file ends, or the system refuses; errno then has the
  // reason.
  static std::optional<std::size_t> read_at(int descriptor, std::byte* to, std::size_t wanted,
                                            std::uint64_t offset) {
    std::size_t done = 0;
    while (done < wanted) {
      const ssize_t got =
          ::pread(descriptor, to + done, wanted - done, static_cast<off_t>(offset + done));
      if (got < 0 && errno == EINTR) {
        continue;
      }
      if (got < 0) {
        return std::nullopt;
      }
      if (got == 0) {
        break;
      }
      done += static_cast<std::size_t>(got);
      if (done % buffer_alignment != 0 && done < wanted) {
        break;  // a direct read that reached the end of the file
      }
    }
    return done;
  }
};

FileItems::FileItems(const std::string& path, std::uint64_t item_bytes,
                     const FileItemsOptions& options)
    : state_(std::make_unique<State>()) {
  if (item_bytes == 0) {
    throw BadInput(fmt::format("{}: items of 0 bytes; give at least 1", path));
  }
  State& s = *state_;
  s.path = path;
  s.item_bytes = item_bytes;
  s.header_bytes = options.header_bytes;
  s.bypass = options.bypass_cache;
  s.file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (s.file < 0 || ::fstat(s.file, &status) != 0) {
    throw MissingResource(
        fmt::format("{}: cannot be opened: {}; check the path and the permissions", path,
                    std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) {
    throw BadInput(fmt::format(
        "{}: is not a regular file, so items cannot be found in it; name another", path));
  }
  s.file_bytes = static_cast<std::uint64_t>(status.st_size);
  if (s.file_bytes <= s.header_bytes) {
    throw BadInput(
        s.header_bytes == 0
            ? fmt::format("{}: has {} bytes and holds no item; name another file", path,
                          s.file_bytes)
            : fmt::format("{}: has {} bytes, and its header of {} leaves no item; give a shorter "
                          "header, or name another file",
                          path, s.file_bytes, s.header_bytes));
  }
  if (const std::uint64_t last = s.data_bytes() % item_bytes; options.whole_items && last != 0) {
    throw BadInput(fmt::format(
        "{}: its {} bytes are not whole items of {}: the last one would have {}; correct the size "
        "of an item, or allow a short last one",
        path, s.data_bytes(), item_bytes, last));
  }
  if (s.bypass) {
    s.direct = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECT);
    s.direct_works = s.direct >= 0;
  }
}

FileItems::~FileItems() = default;

std::uint64_t FileItems::item_count() const {
  return ceil_div(state_->data_bytes(), state_->item_bytes);
}

std::size_t FileItems::buffer_bytes() const {
  const std::uint64_t largest = std::min(state_->item_bytes, state_->data_bytes());
  // Direct reads begin and end at multiples of the alignment.
  const bool aligned =
      state_->item_bytes % buffer_alignment == 0 && state_->header_bytes % buffer_alignment == 0;
  const std::uint64_t slack = state_->bypass && !aligned ? 2 * buffer_alignment : 0;
  return static_cast<std::size_t>(ceil_div(largest + slack, buffer_alignment) * buffer_alignment);
}

std::string FileItems::describe() const {
  return fmt::format("{} ({} bytes, items of {})", state_->path, state_->file_bytes,
                     state_->item_bytes);
}

std::string FileItems::fingerprint() const {
  constexpr std::uint64_t page = 4096;
  constexpr std::uint64_t most_pages = 64;
  const State& s = *state_;
  struct stat status {};
  if (::fstat(s.file, &status) != 0) {
    throw MissingResource(fmt::format("{}: cannot be read: {}; check the file and its disk", s.path,
                                      std::strerror(errno)));
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::uint64_t pages = ceil_div(size, page);
  Sha256 hash;
  std::array<std::byte, page> bytes;
  // The first and the last page, and one random page of each of several stretches between them.
  std::uint64_t state = size;
  for (std::uint64_t i = 0; i < std::min(pages, most_pages); ++i) {
    std::uint64_t number = i;
    if (pages > most_pages && i > 0) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      const std::uint64_t stretch = (pages - 2) / (most_pages - 2);
      number = i == most_pages - 1 ? pages - 1 : 1 + (i - 1) * stretch + (state >> 33) % stretch;
    }
    const auto got = State::read_at(s.file, bytes.data(), bytes.size(), number * page);
    if (!got) {
      throw MissingResource(fmt::format("{}: cannot be read: {}; check the file and its disk",
                                        s.path, std::strerror(errno)));
    }
    hash.add(bytes.data(), *got);
  }
  return fmt::format("{} bytes, changed {}.{:09} and {}.{:09}, sample {}", size,
                     status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ctim.tv_sec,
                     status.st_ctim.tv_nsec, to_hex(hash.finish()));
}

std::uint64_t FileItems::data_bytes() const { return state_->data_bytes(); }

std::string FileItems::access() const {
  return !state_->bypass ? "cached" : state_->direct_works ? "direct" : "dropped";
}

std::span<const std::byte> FileItems::read(Element item, std::span<std::byte> buffer) {
  State& s = *state_;
  if (item >= item_count()) {
    throw BadInput(fmt::format("{}: there is no item {}, only {}; plan for these", s.path, item,
                               item_count()));
  }
  const std::uint64_t start = s.header_bytes + item * s.item_bytes;
  const auto bytes =
      static_cast<std::size_t>(std::min<std::uint64_t>(s.item_bytes, s.file_bytes - start));
  std::size_t skip = 0;
  std::optional<std::size_t> got;
  if (s.direct_works) {
    skip = static_cast<std::size_t>(start % buffer_alignment);
    const std::size_t span =
        static_cast<std::size_t>(ceil_div(skip + bytes, buffer_alignment) * buffer_alignment);
    got = State::read_at(s.direct, buffer.data(), span, start - skip);
    if (got) {
      got = *got > skip ? std::min(*got - skip, bytes) : 0;
    } else if (errno == EINVAL) {
      s.direct_works = false;  // the file system does not support direct reads after all
    }
  }
  if (!got && !s.direct_works) {
    skip = 0;
    got = State::read_at(s.file, buffer.data(), bytes, start);
    if (s.bypass && got) {
      // Advice only: if the system ignores it, the pages stay for a while.
      static_cast<void>(::posix_fadvise(s.file, static_cast<off_t>(start),
                                        static_cast<off_t>(bytes), POSIX_FADV_DONTNEED));
    }
  }
  if (!got) {
    throw MissingResource(fmt::format("{}: item {} cannot be read: {}; check the file and its disk",
                                      s.path, item, std::strerror(errno)));
  }
  if (*got < bytes) {
    throw BadInput(fmt::format(
        "{}: item {} ends after {} of {} bytes: the file has become shorter; start again", s.path,
        item, *got, bytes));
  }
  return buffer.subspan(skip, bytes);
}

CallbackItems::CallbackItems(std::uint64_t items, std::size_t bytes_per_item, Read read,
                             std::string description, std::string fingerprint)
    : items_(items),
      bytes_(bytes_per_item),
      read_(std::move(read)),
      description_(std::move(description)),
      fingerprint_(std::move(fingerprint)) {}

std::span<const std::byte> CallbackItems::read(Element item, std::span<std::byte> buffer) {
  const std::size_t bytes = read_(item, buffer);
  if (bytes > buffer.size()) {
    throw BadInput(
        fmt::format("{}: item {} has {} bytes, but {} were promised to be enough; promise more",
                    description_, item, bytes, buffer.size()));
  }
  return buffer.first(bytes);
}

std::uint64_t room_for(const ItemSource& source, std::uint64_t memory_bytes) {
  const std::uint64_t room = memory_bytes / std::max<std::uint64_t>(1, source.buffer_bytes());
  if (room < 2) {
    throw BadInput(
        fmt::format("{} bytes of memory do not hold two items of {} bytes; allow more, "
                    "or make items smaller",
                    memory_bytes, source.buffer_bytes()));
  }
  return room;
}

}  // namespace changeover
