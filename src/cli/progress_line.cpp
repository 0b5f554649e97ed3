// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_line.h"

#include "compare/comparison/comparison_table.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace utsuri {
namespace {

// A signal handler can reach nothing but a variable like this.
volatile std::sig_atomic_t interrupt_requested = 0;

/// The first Ctrl-C asks work to end. Some work does not come to a place where it may for long, such as the
/// build of a BVH or one sample of a large picture, so that the next Ctrl-C kills.
void on_interrupt(int) {
    interrupt_requested = 1;
    std::signal(SIGINT, SIG_DFL);
}

bool is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

constexpr const char* kEraseLine = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine(bool quiet) : visible_(!quiet && is_terminal()) {
    if (interrupt_requested == 0) std::signal(SIGINT, on_interrupt);
}

ProgressLine::~ProgressLine() {
    clear();
    std::signal(SIGINT, SIG_DFL);
}

void ProgressLine::begin(const std::string& stage) {
    stage_ = stage;
    stage_start_ = Clock::now();
    show(stage);
}

void ProgressLine::update(double done, double total) {
    constexpr std::chrono::milliseconds kInterval(200);
    if (Clock::now() - last_shown_ < kInterval && done < total) return;
    const double elapsed = std::chrono::duration<double>(Clock::now() - stage_start_).count();
    const double rate = elapsed > 0.0 ? done / elapsed : 0.0;
    const std::string left = rate > 0.0 ? format_seconds((total - done) / rate) : std::string("?");
    show(fmt::format("{}: {:.0f} %, {:.3g} /s, {} left", stage_, 100.0 * done / total, rate, left));
}

bool ProgressLine::cancelled() const {
    return interrupt_requested != 0;
}

void ProgressLine::clear() {
    if (visible_) std::fputs(kEraseLine, stderr);
}

void ProgressLine::show(const std::string& text) {
    if (!visible_) return;
    last_shown_ = Clock::now();
    fmt::print(stderr, "{}{}", kEraseLine, text);
    std::fflush(stderr);
}

}  // namespace utsuri
