#include "changeover/core/sha256.hpp"

#include <gtest/gtest.h>

#include <string>

namespace changeover::test::sha256_test {
namespace {

TEST(Checksum, IsThatOfThePublishedExamples) {
  EXPECT_EQ(to_hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(to_hex(sha256("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(to_hex(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(to_hex(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmno"
                          "ijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu")),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(to_hex(sha256(std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Checksum, DoesNotDependOnHowTheBytesArrive) {
  const std::string text(300, 'x');
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::string_view all = std::string_view(text).substr(0, length);
    for (const std::size_t piece : {1U, 7U, 63U, 64U, 65U}) {
      Sha256 hash;
      for (std::size_t at = 0; at < length; at += piece) {
        hash.add(all.substr(at, piece));
      }
      ASSERT_EQ(hash.finish(), sha256(all)) << length << ' ' << piece;
    }
  }
}

TEST(Checksum, IsReadBackFromItsDigitsAndFromNothingElse) {
  const Checksum checksum = sha256("abc");
  const std::string digits = to_hex(checksum);
  EXPECT_EQ(checksum_from_hex(digits), checksum);
  EXPECT_FALSE(checksum_from_hex(""));
  EXPECT_FALSE(checksum_from_hex(digits.substr(1)));
  EXPECT_FALSE(checksum_from_hex(digits + "0"));
  EXPECT_FALSE(checksum_from_hex("BA" + digits.substr(2)));
  EXPECT_FALSE(checksum_from_hex("g" + digits.substr(1)));
}

}  // namespace
}  // namespace changeover::test::sha256_test
