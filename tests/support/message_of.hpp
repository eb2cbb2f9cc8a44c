// What a call complains of.
#pragma once

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
