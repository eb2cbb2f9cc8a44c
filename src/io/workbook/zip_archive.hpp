// A zip archive in memory, its members read a piece at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace changeover {

class ZipArchive {
 public:
  /// Takes the bytes of the archive; messages call it `name`. @throws BadInput if they are none.
  ZipArchive(std::string bytes, std::string name);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  [[nodiscard]] bool has(const std::string& member) const;

  /// One member while it is read.
  class Member {
   public:
    Member(Member&&) noexcept;
    Member& operator=(Member&&) noexcept;
    ~Member();

    /// Some more bytes; empty at the end. @throws BadInput if they are damaged, or more than the
    /// limit.
    [[nodiscard]] std::string next();

   private:
    friend class ZipArchive;
    struct State;
    explicit Member(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
  };

  /// Opens a member, whose name is compared without regard to case; nothing if there is none. No
  /// more than `limit` bytes are unpacked. @throws BadInput if it cannot be read, for a password
  /// for instance.
  [[nodiscard]] std::optional<Member> open(const std::string& member, std::uint64_t limit) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover
