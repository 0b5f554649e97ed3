// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_cache.h"

#include "compare/comparison/comparison_json.h"
#include "compare/page/json_text.h"
#include "compare/trade/trade_json.h"
#include "compare/trade/trade_sweep.h"

#include "base/error.h"
#include "base/file.h"
#include "base/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// FNV-1a, 64 bits. Told apart are scenes that differ by accident, not by design.
class ContentHash {
  public:
    template <typename Record>
    void add(const std::vector<Record>& records) {
        static_assert(std::is_trivially_copyable_v<Record>);
        add_bytes(std::as_bytes(std::span(records)));
    }
    void add_bytes(std::span<const std::byte> bytes) {
        // The size is a part of the content: otherwise records could move from one array to the next.
        const auto size = static_cast<std::uint64_t>(bytes.size());
        mix(std::as_bytes(std::span(&size, 1)));
        mix(bytes);
    }
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

  private:
    void mix(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes) {
            state_ ^= std::to_integer<std::uint64_t>(byte);
            state_ *= 0x100000001b3ull;
        }
    }
    std::uint64_t state_ = 0xcbf29ce484222325ull;
};

/// Of what the device is given.
std::string hash_scene(const SceneData& data) {
    ContentHash hash;
    hash.add(data.bvh.triangles);
    hash.add(data.triangle_infos);
    hash.add(data.normals);
    hash.add(data.texcoords);
    hash.add(data.materials);
    hash.add(data.lights);
    hash.add(data.texels);
    return hash.text();
}

Json vector_to_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json planes_to_json(const Polyhedron& polyhedron) {
    Json planes = Json::array();
    for (const Polyhedron::Plane& plane : polyhedron.planes)
        planes.push_back({plane.normal.x, plane.normal.y, plane.normal.z, plane.distance});
    return planes;
}

/// Null where proxies are fitted.
Json planes_to_json(const std::optional<GivenProxy>& proxy) {
    if (!proxy) return nullptr;
    Json planes = Json::array();
    for (const HalfSpace& plane : proxy->planes)
        planes.push_back({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
    return planes;
}

Json sweep_to_json(const ComparisonSettings& settings) {
    Json sweep = Json::array();
    for (const TradeSetting& setting : swept_settings(settings.methods, settings.maps))
        sweep.push_back(setting.options);
    return sweep;
}

}  // namespace

Json trade_key(const Session& session, const Camera& camera, const ComparisonSettings& settings,
               const std::vector<std::string>& options) {
    Json words = Json::array();
    for (const std::string& option : options)
        words.push_back(valid_utf8(option));
    return {
        {"schema", kTradeSchema},
        {"utsuri", kVersion},
        {"device", device_to_json(session.device())},
        {"scene", hash_scene(session.scene())},
        {"camera",
         {vector_to_json(camera.position), vector_to_json(camera.right), vector_to_json(camera.up),
          vector_to_json(camera.forward), camera.vertical_fov}},
        {"origin", vector_to_json(session.scene().origin)},
        {"width", settings.render.width},
        {"height", settings.render.height},
        {"options", words},
        {"polyhedron", planes_to_json(settings.maps.polyhedron)},
        {"proxy", planes_to_json(settings.maps.proxy)},
        {"light", settings.light->name},
        {"kept_light", settings.render.kept_light},
        {"sweep", sweep_to_json(settings)},
        {"samples", settings.samples},
        {"reference_samples", settings.reference_samples ? Json(*settings.reference_samples) : Json(nullptr)},
        {"reference_seconds", settings.reference_seconds}};
}

std::filesystem::path trade_file(const std::filesystem::path& folder, const Json& key) {
    ContentHash hash;
    const std::string text = json_text(key, -1);
    hash.add_bytes(std::as_bytes(std::span(text)));
    return folder / fmt::format("trade-{}.json", hash.text());
}

std::optional<Trade> read_kept_trade(const std::filesystem::path& file, const Json& key) {
    try {
        const std::vector<std::byte> bytes = read_file(file, "read kept trade");
        const Json json =
            Json::parse(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        if (json.at("key") != key) return std::nullopt;
        return trade_from_json(json.at("trade"));
    } catch (const Error&) {
        return std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

void keep_trade(const std::filesystem::path& file, const Json& key, const Trade& trade) {
    make_output_folder(file.parent_path());
    const Json json = {{"key", key}, {"trade", trade_to_json(trade)}};
    write_text_atomically(file, json_text(json, 1) + "\n");
}

}  // namespace utsuri
