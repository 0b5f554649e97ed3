// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"
#include "cli/output.h"
#include "cli/scene_session.h"
#include "compare/comparison/comparison_json.h"
#include "compare/comparison/comparison_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace utsuri {
namespace {

std::string describe(const DeviceSummary& device) {
    return fmt::format(
        "{}: {} ({})\n"
        "   {}, Vulkan {}\n"
        "   {} of memory, {} in one buffer, subgroups of {}\n"
        "   {}\n",
        device.index, device.name, device.kind, device.driver, device.api, format_bytes(device.memory_bytes),
        format_bytes(device.storage_range_bytes), device.subgroup_size,
        device.usable() ? std::string("usable")
                        : fmt::format("not usable: lacks {}", fmt::join(device.missing, ", ")));
}

nlohmann::ordered_json to_json(const DeviceSummary& device) {
    nlohmann::ordered_json json = device_to_json(device);
    json["index"] = device.index;
    json["kind"] = device.kind;
    json["memory_bytes"] = device.memory_bytes;
    json["storage_range_bytes"] = device.storage_range_bytes;
    json["subgroup_size"] = device.subgroup_size;
    json["missing"] = device.missing;
    return json;
}

ExitCode devices(const CommonOptions& options) {
    const VulkanInstance instance(wanted_validation());
    const std::vector<DeviceSummary> found = list_devices(instance);
    const std::size_t chosen = choose_device(instance, options.device).index;
    std::string text;
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const DeviceSummary& device : found) {
        text += describe(device);
        json.push_back(to_json(device));
    }
    print_text(
        options,
        text + fmt::format("device {} is used unless --device or UTSURI_DEVICE says otherwise\n", chosen));
    write_json(options, {{"devices", json}, {"chosen", chosen}});
    return ExitCode::success;
}

}  // namespace

void add_devices_command(CLI::App& app, Action& action) {
    auto options = std::make_shared<CommonOptions>();
    CLI::App* command = app.add_subcommand("devices", "List the Vulkan devices and whether they can be used");
    add_common_options(*command, *options);
    command->callback([=, &action] { action = [=] { return devices(*options); }; });
}

}  // namespace utsuri
