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

/// A name beside `path` that no other run uses.
fs::path unused_neighbour(const fs::path& path, std::string_view purpose) {
    std::random_device random;
    return path.parent_path() /
           fmt::format("{}.{}-{:08x}{}", path.stem().string(), purpose, random(), path.extension().string());
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
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const auto refuse = [&](const std::string& problem) {
        throw InputError("write", fmt::format("'{}'", path.string()), problem);
    };
    std::error_code error;
    if (!fs::exists(folder, error))
        refuse(fmt::format("the folder '{}' does not exist; create it or choose another", folder.string()));
    if (!fs::is_directory(folder)) refuse(fmt::format("'{}' is not a folder", folder.string()));
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) refuse("is a folder, expected a file name");
    if (fs::is_regular_file(status)) {
        // Opened at its end, a file stays as it is.
        if (!std::ofstream(path, std::ios::app)) refuse("is there and may not be changed");
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) return;
    const fs::path probe = unused_neighbour(path, "write-probe");
    if (!std::ofstream(probe))
        refuse(fmt::format("permission denied: nothing can be written in '{}'", folder.string()));
    fs::remove(probe, error);
}

void write_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    check_writable(path);
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write(path);
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::path temporary = unused_neighbour(target, "partial");
    try {
        write(temporary);
        fs::rename(temporary, target, error);
        if (error) throw InputError("write", fmt::format("'{}'", path.string()), error.message());
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
    const fs::path probe = folder / ".utsuri-write-probe";
    std::ofstream stream(probe);
    if (!stream) {
        throw InputError("write into output folder", fmt::format("'{}'", folder.string()),
                         "permission denied; choose a folder that can be written, with -o");
    }
    stream.close();
    fs::remove(probe, error);
}

}  // namespace utsuri
