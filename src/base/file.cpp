// SPDX-License-Identifier: Apache-2.0
#include "base/file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <fstream>
#include <random>
#include <system_error>

namespace utsuri {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A name that no other run uses.
std::string unused_name(std::string_view stem, std::string_view extension) {
    std::random_device random;
    return fmt::format("{}-{:08x}{}", stem, random(), extension);
}

[[noreturn]] void refuse(const fs::path& path, const std::string& problem) {
    throw InputError("write", fmt::format("'{}'", path.string()), problem);
}

/// Whether it is there and no file: a pipe, say, or a terminal.
bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

bool can_write_in(const fs::path& folder) {
    const fs::path probe = folder / unused_name(".utsuri-write-probe", "");
    if (!std::ofstream(probe)) return false;
    std::error_code error;
    fs::remove(probe, error);
    return true;
}

/// @throws InputError where no file can be, whatever the folder allows
void refuse_bad_place(const fs::path& path) {
    const fs::path folder = folder_of(path);
    std::error_code error;
    if (!fs::exists(folder, error))
        refuse(path,
               fmt::format("the folder '{}' does not exist; create it or choose another", folder.string()));
    if (!fs::is_directory(folder, error)) refuse(path, fmt::format("'{}' is not a folder", folder.string()));
    if (fs::is_directory(path, error)) refuse(path, "is a folder, expected a file name");
    // Opened at its end, a file stays as it is.
    if (fs::is_regular_file(path, error) && !std::ofstream(path, std::ios::app))
        refuse(path, "is there and may not be changed");
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::string_view operation) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw InputError(operation, fmt::format("'{}'", path.string()), "no such file");
    }
    if (fs::is_directory(status)) {
        throw InputError(operation, fmt::format("'{}'", path.string()), "is a folder, expected a file");
    }
    std::ifstream stream(path, std::ios::binary);
    const auto size = fs::file_size(path, error);
    if (!stream || error) {
        throw InputError(operation, fmt::format("'{}'", path.string()), "cannot be opened for reading");
    }
    std::vector<std::byte> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) {
        throw InputError(operation, fmt::format("'{}'", path.string()),
                         fmt::format("reading stopped after {} of {} bytes", stream.gcount(), size));
    }
    return bytes;
}

void check_writable(const fs::path& path) {
    refuse_bad_place(path);
    const fs::path folder = folder_of(path);
    if (!is_special(path) && !can_write_in(folder))
        refuse(path, fmt::format("permission denied: nothing can be written in '{}'", folder.string()));
}

void write_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    refuse_bad_place(path);
    if (is_special(path)) return write(path);
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::path temporary =
        folder_of(target) / unused_name(target.stem().string() + ".partial", target.extension().string());
    try {
        write(temporary);
        fs::rename(temporary, target, error);
        if (error) refuse(path, error.message());
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
}

void write_text_atomically(const fs::path& path, std::string_view text) {
    write_file_atomically(path, [&](const fs::path& temporary) {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) {
            throw InputError("write", fmt::format("'{}'", path.string()),
                             "cannot be written: is the folder writable, is the disk full?");
        }
    });
}

void make_output_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder)) {
        throw InputError("create output folder", fmt::format("'{}'", folder.string()),
                         fmt::format("{}; choose a folder that can be made, with -o",
                                     error ? error.message() : "a file of that name is in the way"));
    }
    if (!can_write_in(folder)) {
        throw InputError("write into output folder", fmt::format("'{}'", folder.string()),
                         "permission denied; choose a folder that can be written, with -o");
    }
}

}  // namespace utsuri
