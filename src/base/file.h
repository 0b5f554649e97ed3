// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace utsuri {

/// The whole file. `operation` names what the reading is for in the message, for example "read scene".
/// @throws InputError if the path is missing, a directory, or unreadable.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::string_view operation);

/// Proves, before work whose result it takes, that a file can be written there. Leaves what is there.
/// @throws InputError telling why not
void check_writable(const std::filesystem::path& path);

/// Lets `write` fill a temporary neighbour of `path` (same extension), then renames it over `path`, so that a
/// failure or a kill never leaves half a file under the final name. The temporary is removed on failure. A
/// link stays, and what it leads to is replaced. What is no file, such as a pipe or a terminal, is written
/// into.
/// @throws InputError where no file can be, and whatever `write` throws
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for a text that is ready.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

/// Creates `folder` and its parents, and proves that a file can be written there.
/// @throws InputError naming the folder otherwise.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace utsuri
