// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace utsuri {

/// Words as one line that a POSIX shell takes apart into the same words.
std::string shell_command(std::span<const std::string> words);

}  // namespace utsuri
