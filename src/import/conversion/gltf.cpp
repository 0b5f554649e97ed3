// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/gltf.h"

#include "import/conversion/cameras.h"
#include "import/conversion/context.h"
#include "import/conversion/instances.h"
#include "import/conversion/lights.h"
#include "import/conversion/near_planes.h"
#include "import/conversion/nodes.h"
#include "import/document/extensions.h"

#include <string>
#include <utility>

namespace utsuri {
namespace {

void note_animations(const nlohmann::json& root, FeatureNotes& ignored) {
    if (!root.contains("animations")) return;
    for (std::size_t i = 0; i < root["animations"].size(); ++i) {
        ignored.add("animations are not played, the scene is drawn at rest",
                    fmt::format("animations[{}]", i));
    }
}

void note_zero_strides(const nlohmann::json& root, FeatureNotes& ignored) {
    const nlohmann::json views = root.value("bufferViews", nlohmann::json::array());
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (views[i].value("byteStride", 1) == 0)
            ignored.add("a byteStride of 0 is read as none, elements are packed",
                        fmt::format("bufferViews[{}]", i));
    }
}

}  // namespace

ImportResult import_gltf(const std::filesystem::path& path) {
    const Document document = load_document(path);
    ImportContext context(document);
    const std::string name = scene_name(document);
    context.result.scene.name = name.empty() ? path.stem().string() : name;
    note_unused_extensions(document.json, context.ignored);
    note_animations(document.json, context.ignored);
    note_zero_strides(document.json, context.ignored);
    InstanceImporter instances(context);
    for (const PlacedNode& placed : place_nodes(document)) {
        instances.import_node(placed);
        import_light(context, placed);
        import_camera(context, placed);
    }
    if (context.result.scene.instances.empty()) {
        context.result.added.emplace_back("no triangle in the file: the scene is empty");
    }
    add_default_light(context);
    note_near_planes(context);
    add_default_camera(context);
    context.result.ignored = context.ignored.lines();
    const Notes added = context.added.lines();
    context.result.added.insert(context.result.added.begin(), added.begin(), added.end());
    return std::move(context.result);
}

}  // namespace utsuri
