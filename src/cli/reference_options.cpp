// SPDX-License-Identifier: Apache-2.0
#include "cli/reference_options.h"

#include "cli/options.h"

namespace utsuri {

void add_reference_options(CLI::App& command, ReferenceOptions& options) {
    auto* const samples =
        command
            .add_option(
                "--reference-spp", options.samples,
                "Samples per pixel of the reference, made even [as many as make its mean squared error "
                "a tenth of the least that is told]")
            ->check(CLI::Range(2u, 1u << 24));
    command
        .add_option("--reference-time", options.time,
                    "About the longest time for the reference's samples, such as 30s or 5min")
        ->type_name("TIME")
        ->capture_default_str()
        ->excludes(samples);
}

void apply(const ReferenceOptions& options, ComparisonSettings& settings) {
    settings.reference_seconds = parse_duration(options.time);
    settings.reference_samples = options.samples;
    if (options.samples) settings.reference_samples = *options.samples + *options.samples % 2;
}

}  // namespace utsuri
