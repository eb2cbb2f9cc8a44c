// What a call complains of.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "changeover/core/error.hpp"

namespace changeover {

/// What `action` throws says; "" if nothing is thrown.
template <typename Fault = BadInput, typename Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Fault& fault) {
    return fault.what();
  }
  return "";
}

}  // namespace changeover

/// Is that thrown, and does its message hold these words?
#define EXPECT_REFUSAL(statement, Exception, words) \
  EXPECT_THAT([&] { statement; }, ::testing::ThrowsMessage<Exception>(::testing::HasSubstr(words)))
