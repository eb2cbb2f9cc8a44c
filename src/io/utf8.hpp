// UTF-8 by its short name in this room.
#pragma once

#include "changeover/core/utf8.hpp"

namespace changeover::io_detail {

using changeover::CodePoint;
using changeover::first_code_point;

}  // namespace changeover::io_detail
