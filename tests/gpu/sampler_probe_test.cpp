// SPDX-License-Identifier: Apache-2.0
#include "kernels/sampler_probe.h"

#include "support/test_device.h"

#include "base/sampler.h"
#include "gpu/probe.h"

namespace utsuri {
namespace {

using SamplerProbe = DeviceTest;

TEST_F(SamplerProbe, EqualsTheHostBitForBit) {
    std::vector<interop::SamplerQuery> queries;
    for (std::uint32_t i = 0; i < 100000; ++i) {
        queries.push_back(
            {{hash(i) >> 18, hash(i + 1) >> 18}, hash(i + 2), i & 1u, i < 50000 ? i : hash(i), i & 31u});
    }
    const auto answers =
        test::ask<interop::SamplerAnswer>(device(), "sampler_probe", kernels::sampler_probe, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const interop::SamplerQuery& query = queries[i];
        const std::uint32_t key = sampler_key(query.pixel, query.seed, query.estimate);
        ASSERT_EQ(answers[i].key, key) << i;
        ASSERT_EQ(answers[i].scrambled, owen_scramble(query.index, query.seed)) << i;
        ASSERT_EQ(answers[i].sobol, sobol_2d(query.index)) << i;
        ASSERT_EQ(answers[i].point, sample_2d(key, query.index, query.dimension_pair)) << i;
    }
}

}  // namespace
}  // namespace utsuri
