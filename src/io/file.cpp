// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 18U;
constexpr int kMaxTemporaryNames = 100;

class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }

    [[nodiscard]] int value() const { return value_; }
    /// Whether everything that was written has reached the file.
    [[nodiscard]] bool close() {
        const int descriptor = value_;
        value_ = -1;
        return ::close(descriptor) == 0;
    }

private:
    int value_;
};

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

/// What a file says of its own length; 0 for pipes and devices.
std::uint64_t stated_size(int descriptor, const std::filesystem::path& path) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) fail(path, "cannot be read", errno);
    if (S_ISDIR(status.st_mode)) fail(path, "cannot be read as a file", EISDIR);
    return S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.value() < 0) fail(path, "cannot be opened", errno);

    const std::uint64_t expected = stated_size(file.value(), path);
    const auto too_large = [&] {
        return InputError(display_name(path) + ": larger than the " + std::to_string(max_bytes) +
                          " bytes that are read at most");
    };
    if (expected > max_bytes) throw too_large();

    std::string bytes;
    std::size_t size = 0;
    bytes.resize(static_cast<std::size_t>(expected) + 1);  // One more, to meet the end at once.
    while (true) {
        if (size == bytes.size()) bytes.resize(bytes.size() + std::max(bytes.size(), kReadBytes));
        const ssize_t count = ::read(file.value(), bytes.data() + size, bytes.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, "cannot be read", errno);
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
        if (size > max_bytes) throw too_large();
    }
    bytes.resize(size);
    return bytes;
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
