// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade.h"

#include "base/command_line.h"

#include <fmt/format.h>

namespace utsuri {
namespace {

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
}

}  // namespace

std::vector<std::string> Trade::render_command(const TradeRun& run) const {
    std::vector<std::string> words = {"utsuri", "render"};
    append(words, scene_options);
    append(words, run.options);
    append(words, {"--spp", fmt::format("{}", run.result.samples)});
    return words;
}

std::string settings_text(const TradeRun& run) {
    // The first option is the method.
    std::vector<std::string> words(run.options.begin() + 2, run.options.end());
    append(words, {"--spp", fmt::format("{}", run.result.samples)});
    return shell_command(words);
}

}  // namespace utsuri
