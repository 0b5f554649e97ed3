// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <fmt/format.h>

namespace utsuri {

Error::Error(ExitCode code, std::string_view operation, std::string_view object, std::string_view problem)
    : std::runtime_error(object.empty() ? fmt::format("{}: {}", operation, problem)
                                        : fmt::format("{} {}: {}", operation, object, problem)),
      code_(code) {}

}  // namespace utsuri
