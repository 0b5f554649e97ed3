// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace utsuri {

/// What the process returns to its caller. The same on every subcommand.
enum class ExitCode : int {
    success = 0,
    difference = 1,    ///< images differ beyond the threshold that was asked for
    usage = 2,         ///< the command line is wrong
    input = 3,         ///< a file is missing, damaged or unsupported, or cannot be written
    device = 4,        ///< no usable Vulkan device, or the device failed
    interrupted = 130  ///< stopped by the user
};

/// A failure that is nobody's bug: bad input or a failing device. The text reads "operation object: problem",
/// where the problem also says what would be right. Caught in main(), and where a comparison goes on without
/// a method.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, std::string_view operation, std::string_view object, std::string_view problem);
    [[nodiscard]] ExitCode exit_code() const noexcept { return code_; }

  private:
    ExitCode code_;
};

/// An option or a combination of options that cannot be used.
class UsageError : public Error {
  public:
    UsageError(std::string_view operation, std::string_view object, std::string_view problem)
        : Error(ExitCode::usage, operation, object, problem) {}
};

/// A file or its contents or a scene cannot be used, or an output cannot be written.
class InputError : public Error {
  public:
    InputError(std::string_view operation, std::string_view object, std::string_view problem)
        : Error(ExitCode::input, operation, object, problem) {}
};

/// No usable Vulkan device, or a Vulkan call failed.
class DeviceError : public Error {
  public:
    DeviceError(std::string_view operation, std::string_view object, std::string_view problem)
        : Error(ExitCode::device, operation, object, problem) {}
};

}  // namespace utsuri
