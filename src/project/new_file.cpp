// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/new_file.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "io/descriptor.hpp"
#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {
namespace {

constexpr int kPatienceMs = 2000;
constexpr mode_t kReadWriteForAll = 0666;  // The process's umask takes the rest away.

using io::Descriptor;

[[noreturn]] void fail(const std::filesystem::path& path, int error_number) {
    throw InputError(io::display_name(path) +
                     ": cannot be written: " + std::strerror(error_number));
}

[[noreturn]] void fail_in_use(const std::filesystem::path& path) {
    throw InputError(io::display_name(path) +
                     ": is in use: another program is making it; try again when that has ended");
}

/// Locks the folder for the making of databases, as long as the descriptor is open.
void lock_folder(const Descriptor& folder, const std::filesystem::path& path) {
    const auto start = std::chrono::steady_clock::now();
    while (::flock(folder.value(), LOCK_EX | LOCK_NB) != 0) {
        // Where folders cannot be locked, no two programs begin the same project in one moment.
        if (errno != EWOULDBLOCK && errno != EINTR) return;
        if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(kPatienceMs)) {
            fail_in_use(path);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

void write_all(int file, std::string_view bytes, const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    if (::fsync(file) != 0 && errno != EINVAL) fail(path, errno);
}

void write_and_link(const Descriptor& file, const std::string& name, std::string_view bytes,
                    const std::filesystem::path& path) {
    if (file.value() < 0) fail(path, errno);
    write_all(file.value(), bytes, path);
    const int flags = AT_SYMLINK_FOLLOW;
    if (::linkat(AT_FDCWD, name.c_str(), AT_FDCWD, path.c_str(), flags) != 0) fail(path, errno);
}

/// By a file that has no name until it is whole. False where there are none.
bool make_of_nameless(const std::filesystem::path& folder, const std::filesystem::path& path,
                      std::string_view bytes) {
    constexpr int kFlags = O_TMPFILE | O_RDWR | O_CLOEXEC;
    const Descriptor file(::open(folder.c_str(), kFlags, kReadWriteForAll));
    const std::string name = "/proc/self/fd/" + std::to_string(file.value());
    const bool is_there = file.value() >= 0 && ::access(name.c_str(), F_OK) == 0;
    if (is_there) write_and_link(file, name, bytes, path);
    return is_there;
}

/// By one whose name is always the same: what a killed program has left is written over.
void make_of_named(const std::filesystem::path& path, std::string_view bytes) {
    struct Temporary {
        std::string name;
        ~Temporary() { ::unlink(name.c_str()); }
    };
    const Temporary temporary{path.string() + ".new"};
    ::unlink(temporary.name.c_str());
    constexpr int kFlags = O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC;
    const Descriptor file(::open(temporary.name.c_str(), kFlags, kReadWriteForAll));
    write_and_link(file, temporary.name, bytes, path);
}

}  // namespace

void make_database_file(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const Descriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock.value() < 0) fail(path, errno);
    lock_folder(lock, path);
    std::error_code error;
    if (std::filesystem::exists(path, error)) fail_in_use(path);
    // SQLite would take them for this file's. Nobody has them open: whoever makes a file of this
    // name waits for the folder.
    for (const char* end : {"-wal", "-shm", "-journal"}) {
        std::filesystem::remove(path.string() + end, error);
    }
    if (!make_of_nameless(folder, path, bytes)) make_of_named(path, bytes);
}

}  // namespace quadcut::project
