// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"

#include <chrono>
#include <string>

namespace utsuri {

/// One line on standard error, if that is a terminal, that tells the stage, how much is done and the time
/// left. While one of these lives, the first Ctrl-C cancels instead of killing.
class ProgressLine : public Progress {
  public:
    explicit ProgressLine(bool quiet);
    ~ProgressLine() override;

    void begin(const std::string& stage) override;
    void update(double done, double total) override;
    [[nodiscard]] bool cancelled() const override;

    /// Removes the line, so that other text can be printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void show(const std::string& text);

    bool visible_;
    std::string stage_;
    Clock::time_point stage_start_ = Clock::now();
    Clock::time_point last_shown_{};
};

}  // namespace utsuri
