// SPDX-License-Identifier: Apache-2.0
#include "cli/output.h"

#include "compare/page/json_text.h"

#include "base/file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace utsuri {

void check_json(const CommonOptions& options) {
    if (!options.json.empty() && options.json != "-") check_writable(options.json);
}

void write_json(const CommonOptions& options, const nlohmann::ordered_json& json) {
    if (options.json.empty()) return;
    const std::string text = json_text(json, 2) + "\n";
    if (options.json == "-") {
        std::fputs(text.c_str(), stdout);
    } else {
        write_text_atomically(options.json, text);
    }
}

void print_text(const CommonOptions& options, const std::string& text) {
    if (!options.quiet && options.json != "-") std::fputs(text.c_str(), stdout);
}

void print_notes(const CommonOptions& options, const Notes& notes) {
    if (options.quiet) return;
    constexpr std::size_t kScreenful = 20;
    for (std::size_t i = 0; i < notes.size() && i < kScreenful; ++i)
        fmt::print(stderr, "note: {}\n", notes[i]);
    if (notes.size() > kScreenful) {
        fmt::print(stderr, "note: and {} more; 'utsuri info' lists all\n", notes.size() - kScreenful);
    }
}

}  // namespace utsuri
