// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/descriptor.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 18U;
constexpr int kMaxTemporaryNames = 100;

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int error_number) {
    throw InputError(display_name(path) + ": " + what + ": " + std::strerror(error_number));
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// Throws unless there is an end to what is read there. Sockets are what some programs pass as
/// pipes.
void check_readable(const struct stat& status, const std::string& name) {
    if (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)) return;
    if (S_ISDIR(status.st_mode)) {
        throw InputError(name + ": cannot be read as a file: " + std::strerror(EISDIR));
    }
    throw InputError(name + ": is a device, expected a file or a pipe");
}

Descriptor open_to_read(const std::filesystem::path& path) {
    // Opening a device may already do something: it is looked at first.
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0) check_readable(status, display_name(path));
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, "cannot be opened", errno);
    return Descriptor(descriptor);
}

/// What a file says of its own length; 0 for pipes.
std::uint64_t stated_size(int descriptor, const std::string& name) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) fail(name, "cannot be read", errno);
    check_readable(status, name);
    return S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
}

/// `bytes` and what is read after them, `end` bytes in all or up to the file's end.
std::string read_up_to(int descriptor, std::size_t end, const std::string& name,
                       std::string bytes) {
    std::size_t size = bytes.size();
    bytes.resize(end);
    while (size < end) {
        const ssize_t count = ::read(descriptor, bytes.data() + size, end - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(name, "cannot be read", errno);
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
    }
    bytes.resize(size);
    return bytes;
}

/// `file` with the bytes of the descriptor.
InputFile read_all(int descriptor, std::uint64_t max_bytes, const BeginningCheck& check,
                   InputFile file) {
    const auto check_size = [&](std::uint64_t size) {
        if (size <= max_bytes) return;
        throw InputError(file.name + ": larger than the " + std::to_string(max_bytes) +
                         " bytes that are read at most");
    };
    const std::uint64_t stated = stated_size(descriptor, file.name);
    std::size_t end = 0;
    if (check) {
        end = kBeginningBytes;
        file.bytes = read_up_to(descriptor, end, file.name, {});
        check(file);
    }
    check_size(stated);
    while (file.bytes.size() == end) {
        // One more than the file states, to meet its end at once.
        end = std::max({static_cast<std::size_t>(stated) + 1, 2 * end, kReadBytes});
        file.bytes = read_up_to(descriptor, end, file.name, std::move(file.bytes));
        check_size(file.bytes.size());
    }
    return file;
}

/// Descriptors' paths, as of <(...), lie in no folder of the user.
std::filesystem::path folder_of(const std::filesystem::path& path) {
    const std::string folder = path.parent_path().string();
    const bool is_descriptor =
        folder == "/dev" || folder == "/dev/fd" || folder.starts_with("/proc/");
    return is_descriptor ? "" : folder;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const Descriptor descriptor = open_to_read(path);
    return read_all(descriptor.value(), max_bytes, {}, {path, display_name(path), {}, {}}).bytes;
}

InputFile read_input(const std::filesystem::path& path, const BeginningCheck& check) {
    if (path == kStandardInput) {
        const std::string name = "standard input";
        if (::isatty(STDIN_FILENO) != 0) {
            throw InputError(name +
                             ": is a terminal, expected a file or a pipe, as in "
                             "'quadcut segment - -o DIR < map.pgm'");
        }
        return read_all(STDIN_FILENO, kMaxFileBytes, check, {path, name, {}, {}});
    }
    const Descriptor descriptor = open_to_read(path);
    return read_all(descriptor.value(), kMaxFileBytes, check,
                    {path, display_name(path), folder_of(path), {}});
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
    const std::string stem = path.string() + ".tmp" + std::to_string(::getpid()) + "_";
    std::string temporary;
    int descriptor = -1;
    for (int attempt = 0; attempt < kMaxTemporaryNames && descriptor < 0; ++attempt) {
        temporary = stem + std::to_string(attempt);
        constexpr mode_t kReadWriteForAll = 0666;  // The process's umask takes the rest away.
        descriptor =
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadWriteForAll);
        if (descriptor < 0 && errno != EEXIST) break;
    }
    if (descriptor < 0) fail(path, "cannot be written", errno);

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
    fail(path, "cannot be written", error_number);
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
