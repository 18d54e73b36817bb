// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/descriptor.hpp"

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

/// Throws unless there is an end to what is read there. Sockets are what some programs pass as
/// pipes.
void check_readable(const struct stat& status, const std::string& name) {
    if (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)) return;
    if (S_ISDIR(status.st_mode)) fail_with(name, "cannot be read as a file", EISDIR);
    throw InputError(name + ": is a device, expected a file or a pipe");
}

}  // namespace

Descriptor::~Descriptor() {
    if (value_ >= 0) ::close(value_);
}

bool Descriptor::close() { return ::close(std::exchange(value_, -1)) == 0; }

Descriptor open_to_read(const std::filesystem::path& path, const std::string& name) {
    // Opening a device may already do something: it is looked at first.
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0) check_readable(status, name);
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail_with(name, "cannot be opened", errno);
    return Descriptor(descriptor);
}

std::uint64_t stated_size(int descriptor, const std::string& name) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) fail_with(name, "cannot be read", errno);
    check_readable(status, name);
    return S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
}

std::string read_up_to(int descriptor, std::size_t end, const std::string& name,
                       std::string bytes) {
    std::size_t size = bytes.size();
    bytes.resize(end);
    while (size < end) {
        const ssize_t count = ::read(descriptor, bytes.data() + size, end - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail_with(name, "cannot be read", errno);
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
    }
    bytes.resize(size);
    return bytes;
}

std::string read_all(int descriptor, std::uint64_t max_bytes, const std::string& name,
                     std::string bytes) {
    const std::uint64_t stated = stated_size(descriptor, name);
    refuse_above(max_bytes, stated, name);
    std::size_t end = bytes.size();
    while (bytes.size() == end) {
        // One more than the file states, to meet its end at once.
        end = std::max({static_cast<std::size_t>(stated) + 1, 2 * end, kReadBytes});
        bytes = read_up_to(descriptor, end, name, std::move(bytes));
        refuse_above(max_bytes, bytes.size(), name);
    }
    return bytes;
}

void refuse_above(std::uint64_t max_bytes, std::uint64_t size, const std::string& name) {
    if (size <= max_bytes) return;
    throw InputError(name + ": larger than the " + std::to_string(max_bytes) +
                     " bytes that are read at most");
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

void fail_with(const std::string& name, const std::string& what, int error_number) {
    throw InputError(name + ": " + what + ": " + std::strerror(error_number));
}

}  // namespace quadcut::io
