// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file.hpp"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "io/descriptor.hpp"

namespace quadcut::io {

std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const std::string name = display_name(path);
    return read_all(open_to_read(path, name).value(), max_bytes, name, {});
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
    const std::string stem = path.string() + ".tmp" + std::to_string(::getpid()) + "_";
    constexpr int kMaxTemporaryNames = 100;
    std::string temporary;
    int descriptor = -1;
    for (int attempt = 0; attempt < kMaxTemporaryNames && descriptor < 0; ++attempt) {
        temporary = stem + std::to_string(attempt);
        constexpr mode_t kReadWriteForAll = 0666;  // The process's umask takes the rest away.
        descriptor =
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadWriteForAll);
        if (descriptor < 0 && errno != EEXIST) break;
    }
    if (descriptor < 0) fail_with(display_name(path), "cannot be written", errno);

    Descriptor file(descriptor);
    bool done = write_all(file.value(), bytes);
    int error_number = errno;
    if (!file.close() && done) {
        done = false;
        error_number = errno;
    }
    if (done && ::rename(temporary.c_str(), path.c_str()) != 0) {
        done = false;
        error_number = errno;
    }
    if (done) return;
    ::unlink(temporary.c_str());
    fail_with(display_name(path), "cannot be written", error_number);
}

std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed) {
    constexpr std::uint64_t kPrime = 0x100000001B3ULL;
    std::uint64_t hash = seed;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * kPrime;
    return hash;
}

std::string display_name(const std::filesystem::path& path) {
    return path.empty() ? "(no file name)" : path.string();
}

}  // namespace quadcut::io
