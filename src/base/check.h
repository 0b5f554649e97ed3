// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace utsuri {

/// A broken invariant: a bug in this program, never bad input.
class CheckFailure : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

[[noreturn]] inline void fail_check(const char* file, int line, const std::string& text) {
    throw CheckFailure(fmt::format("{}:{}: check failed: {}", file, line, text));
}

}  // namespace utsuri

/// Checks that stay in release builds; both operands are printed.
#define UTSURI_CHECK_OP(a, op, b)                                                                 \
    do {                                                                                          \
        const auto& utsuri_check_a = (a);                                                         \
        const auto& utsuri_check_b = (b);                                                         \
        if (!(utsuri_check_a op utsuri_check_b)) {                                                \
            ::utsuri::fail_check(                                                                 \
                __FILE__, __LINE__,                                                               \
                fmt::format("{} {} {} ({} vs {})", #a, #op, #b, utsuri_check_a, utsuri_check_b)); \
        }                                                                                         \
    } while (false)
#define UTSURI_CHECK_EQ(a, b) UTSURI_CHECK_OP(a, ==, b)
#define UTSURI_CHECK_LT(a, b) UTSURI_CHECK_OP(a, <, b)
#define UTSURI_CHECK_LE(a, b) UTSURI_CHECK_OP(a, <=, b)
#define UTSURI_CHECK(condition)                                                 \
    do {                                                                        \
        if (!(condition)) ::utsuri::fail_check(__FILE__, __LINE__, #condition); \
    } while (false)
