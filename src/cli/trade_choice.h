// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options.h"
#include "compare/comparison/run_comparison.h"
#include "compare/trade/trade_front.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace utsuri {

/// Which run of a trade a user wants.
struct ChoiceOptions {
    std::string within;  ///< duration; empty if not given
    std::optional<double> error;
    std::string metric = "rel_mse";

    [[nodiscard]] bool wanted() const { return !within.empty() || error; }
};

void add_choice_options(CLI::App& command, ChoiceOptions& options);

/// How far a trade goes if the user does not say: the office at 512 x 384 takes some minutes on two cores.
inline constexpr std::uint32_t kTradeSamples = 64;

/// What to sweep, around the settings of the picture.
ComparisonSettings trade_settings(const PictureOptions& picture, const std::vector<Method>& methods,
                                  const LightMethod& light);

/// Words that give the picture options of `command` as its user did, but for those that a sweep sets.
std::vector<std::string> given_picture_options(const CLI::App& command);

/// The point of the run that is wanted, by the time of a frame.
/// @throws UsageError if there is none, with what there is
TradePoint choose_run(const Trade& trade, const ChoiceOptions& options);

/// One line that tells which run was chosen, with its time and error.
std::string choice_text(const Trade& trade, const TradePoint& point, const ChoiceOptions& options);
nlohmann::ordered_json choice_to_json(const Trade& trade, const TradePoint& point,
                                      const ChoiceOptions& options);

/// Keeps a trade for `utsuri render`; says so on standard error if that fails.
/// @param options words that all runs share
void keep_for_later(const Session& session, const Camera& camera, const ComparisonSettings& settings,
                    const std::vector<std::string>& options, const Trade& trade);

/// A trade that was kept before, else measured now and kept, which standard error says.
/// @throws Interrupted if progress says so
Trade kept_or_measured(Session& session, const Camera& camera, const ComparisonSettings& settings,
                       const std::vector<std::string>& options, const CommonOptions& common,
                       Progress& progress);

}  // namespace utsuri
