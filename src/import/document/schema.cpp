// SPDX-License-Identifier: Apache-2.0
#include "import/document/schema.h"

#include "import/document/place.h"
#include "import/document/schema_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::json;

std::size_t count_of(const Json& parent, std::string_view name) {
    if (!parent.is_object()) return 0;
    const auto found = parent.find(std::string(name));
    return found != parent.end() && found->is_array() ? found->size() : 0;
}

std::string range_text(const Field& field) {
    const double unlimited = std::numeric_limits<double>::max();
    const bool above_zero = field.min == std::numeric_limits<double>::min();
    if (field.min == -unlimited) return "";
    if (field.max == unlimited) return above_zero ? " above 0" : fmt::format(" of at least {}", field.min);
    return above_zero ? fmt::format(" in (0, {}]", field.max)
                      : fmt::format(" in [{}, {}]", field.min, field.max);
}

class SchemaChecker {
  public:
    SchemaChecker(const SourceFile& file, const Json& root) : file_(file) {
        for (std::size_t list = 0; list < kListNames.size(); ++list)
            counts_[list] = count_of(root, kListNames[list]);
        const Json::json_pointer lights("/extensions/KHR_lights_punctual");
        const bool has_lights = root.contains(lights);
        counts_[static_cast<std::size_t>(List::lights)] =
            has_lights ? count_of(root.at(lights), "lights") : 0;
    }

    void check_object(Json& value, const Schema& schema, const Place& place) const {
        if (!value.is_object()) fail(place, value, "an object");
        for (const Field& field : schema.fields) {
            const auto found = value.find(std::string(field.name));
            if (found != value.end()) {
                check_value(*found, field, place.member(field.name));
            } else if (field.required) {
                file_.fail(place.member(field.name).text(), "missing; it is required here");
            }
        }
    }

  private:
    [[noreturn]] void fail(const Place& place, const Json& value, std::string_view right) const {
        constexpr std::size_t kMaxShown = 40;
        std::string shown = value.is_structured() ? std::string(value.type_name()) : value.dump();
        if (shown.size() > kMaxShown) shown = std::string(value.type_name());
        file_.fail(place.text(), fmt::format("is {}; must be {}", shown, right));
    }

    void check_value(Json& value, const Field& field, const Place& place) const {
        switch (field.kind) {
            case Kind::boolean:
                if (!value.is_boolean()) fail(place, value, "true or false");
                break;
            case Kind::word:
                check_word(value, field, place);
                break;
            case Kind::integer:
                check_integer(value, field, place);
                break;
            case Kind::number:
                check_number(value, field, place);
                break;
            case Kind::numbers:
                check_numbers(value, field, place);
                break;
            case Kind::index:
                check_index(value, field, place);
                break;
            case Kind::index_map:
                check_index_map(value, field, place);
                break;
            case Kind::object:
                check_object(value, *field.schema, place);
                break;
            case Kind::words:
            case Kind::indices:
            case Kind::objects:
            case Kind::index_maps:
                check_elements(value, field, place);
                break;
        }
    }

    void check_elements(Json& value, const Field& field, const Place& place) const {
        if (!value.is_array()) fail(place, value, "an array");
        for (std::size_t i = 0; i < value.size(); ++i) {
            const Place element = place.element(i);
            switch (field.kind) {
                case Kind::words:
                    check_word(value[i], field, element);
                    break;
                case Kind::indices:
                    check_index(value[i], field, element);
                    break;
                case Kind::index_maps:
                    check_index_map(value[i], field, element);
                    break;
                default:
                    check_object(value[i], *field.schema, element);
                    break;
            }
        }
    }

    void check_word(const Json& value, const Field& field, const Place& place) const {
        if (!value.is_string()) fail(place, value, "a string");
        const auto& word = value.get_ref<const std::string&>();
        if (!field.words.empty() &&
            std::find(field.words.begin(), field.words.end(), word) == field.words.end()) {
            fail(place, value, fmt::format("one of {}", fmt::join(field.words, ", ")));
        }
    }

    void make_integer(Json& value, const Place& place, std::string_view right) const {
        constexpr double kExact = 9007199254740992.0;  // 2^53
        if (value.is_number_float()) {
            const double number = value.get<double>();
            if (std::floor(number) != number || std::abs(number) >= kExact) fail(place, value, right);
            value = static_cast<std::int64_t>(number);
        }
        if (!value.is_number_integer()) fail(place, value, right);
    }

    void check_integer(Json& value, const Field& field, const Place& place) const {
        std::string right = fmt::format("an integer{}", range_text(field));
        if (field.multiple != 1) right += fmt::format(" and a multiple of {}", field.multiple);
        if (!field.codes.empty()) right = fmt::format("one of {}", fmt::join(field.codes, ", "));
        make_integer(value, place, right);
        const double number = value.get<double>();
        if (number < field.min || number > field.max || std::fmod(number, field.multiple) != 0.0) {
            fail(place, value, right);
        }
        const auto is_it = [&](int code) { return number == code; };
        if (!field.codes.empty() && std::none_of(field.codes.begin(), field.codes.end(), is_it)) {
            fail(place, value, right);
        }
    }

    void check_number(const Json& value, const Field& field, const Place& place) const {
        const bool ok =
            value.is_number() && value.get<double>() >= field.min && value.get<double>() <= field.max;
        if (!ok) fail(place, value, fmt::format("a number{}", range_text(field)));
    }

    void check_numbers(const Json& value, const Field& field, const Place& place) const {
        if (!value.is_array() || value.size() != field.length) {
            fail(place, value, fmt::format("an array of {} numbers", field.length));
        }
        for (std::size_t i = 0; i < value.size(); ++i)
            check_number(value[i], field, place.element(i));
    }

    void check_index(Json& value, const Field& field, const Place& place) const {
        const auto list = static_cast<std::size_t>(field.list);
        const std::size_t count = counts_[list];
        const std::string right =
            count == 0 ? fmt::format("absent: the file has no {}", kListNames[list])
                       : fmt::format("an index into {}, an integer in [0, {}]", kListNames[list], count - 1);
        make_integer(value, place, right);
        const double number = value.get<double>();
        if (number < 0.0 || number >= static_cast<double>(count)) fail(place, value, right);
    }

    void check_index_map(Json& value, const Field& field, const Place& place) const {
        if (!value.is_object()) fail(place, value, "an object");
        for (auto& [key, index] : value.items())
            check_index(index, field, place.member(key));
    }

    const SourceFile& file_;
    std::array<std::size_t, kListNames.size()> counts_{};
};

}  // namespace

void check_schema(const SourceFile& file, Json& root) {
    SchemaChecker(file, root).check_object(root, root_schema(), Place());
}

}  // namespace utsuri
