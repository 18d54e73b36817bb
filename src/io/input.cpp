// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/input.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 17U;
/// What comes from a pipe and is no longer needs no temporary file.
constexpr std::size_t kSmallBytes = std::size_t{1} << 22U;

/// Descriptors' paths, as of <(...), lie in no folder of the user.
std::filesystem::path folder_of(const std::filesystem::path& path) {
    const std::string folder = path.parent_path().string();
    const bool is_descriptor =
        folder == "/dev" || folder == "/dev/fd" || folder.starts_with("/proc/");
    return is_descriptor ? "" : folder;
}

struct stat status_of(int descriptor, const std::string& name) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) fail_with(name, "cannot be read", errno);
    return status;
}

/// A file that is read from its beginning to the end again and again.
class StillFile {
public:
    StillFile(Descriptor file, std::string name, std::uint64_t begin)
        : file_(std::move(file)),
          name_(std::move(name)),
          begin_(begin),
          status_(status_of(file_.value(), name_)) {}

    /// Into `piece`, from `offset` on.
    [[nodiscard]] std::string_view read(std::uint64_t offset, std::string& piece) const {
        const struct stat now = status_of(file_.value(), name_);
        if (now.st_size != status_.st_size || now.st_mtim.tv_sec != status_.st_mtim.tv_sec ||
            now.st_mtim.tv_nsec != status_.st_mtim.tv_nsec) {
            throw InputError(name_ +
                             ": has changed while it was read: expected a file that nobody "
                             "writes to; read a copy of it");
        }
        piece.resize(kPieceBytes);
        ssize_t count = 0;
        do {
            count = ::pread(file_.value(), piece.data(), piece.size(),
                            static_cast<off_t>(begin_ + offset));
        } while (count < 0 && errno == EINTR);
        if (count < 0) fail_with(name_, "cannot be read", errno);
        return std::string_view(piece).substr(0, static_cast<std::size_t>(count));
    }

private:
    Descriptor file_;
    std::string name_;
    /// Standard input may have been read in part by whoever passed it.
    std::uint64_t begin_;
    struct stat status_;
};

OpenPieces pieces_of_file(Descriptor file, const std::string& name, std::uint64_t begin) {
    const auto still = std::make_shared<const StillFile>(std::move(file), name, begin);
    return [still]() -> Pieces {
        return [still, offset = std::uint64_t{0}, piece = std::string()]() mutable {
            const std::string_view read = still->read(offset, piece);
            offset += read.size();
            return read;
        };
    };
}

OpenPieces pieces_of_memory(std::string bytes) {
    return [kept = std::make_shared<const std::string>(std::move(bytes))]() -> Pieces {
        return [kept, pieces = pieces_of(*kept)] { return pieces(); };
    };
}

/// A new file that goes when it is closed.
Descriptor temporary_file(const std::string& name) {
    std::error_code error;
    std::string path = (std::filesystem::temp_directory_path(error) / "quadcut_XXXXXX").string();
    const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
    if (descriptor < 0) fail_with(name, "cannot be kept in a temporary file, " + path, errno);
    ::unlink(path.c_str());
    return Descriptor(descriptor);
}

/// Copies all that comes from a pipe after `bytes`.
Descriptor copy_of_pipe(int pipe, const std::string& name, std::string bytes) {
    Descriptor copy = temporary_file(name);
    for (std::uint64_t size = 0; !bytes.empty();) {
        size += bytes.size();
        refuse_above(kMaxFileBytes, size, name);
        if (!write_all(copy.value(), bytes)) {
            fail_with(name, "cannot be kept in a temporary file", errno);
        }
        bytes = read_up_to(pipe, kPieceBytes, name, {});
    }
    return copy;
}

Descriptor open_input(const std::filesystem::path& path, const std::string& name) {
    if (path != kStandardInput) return open_to_read(path, name);
    if (::isatty(STDIN_FILENO) != 0) {
        throw InputError(name +
                         ": is a terminal, expected a file or a pipe, as in "
                         "'quadcut segment - -o DIR < map.pgm'");
    }
    return Descriptor(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0));
}

}  // namespace

Input::Input(const std::filesystem::path& path)
    : beginning_{path,
                 path == kStandardInput ? "standard input" : display_name(path),
                 path == kStandardInput ? "" : folder_of(path),
                 {}},
      rest_(open_input(path, beginning_.name)) {
    const std::string& name = beginning_.name;
    static_cast<void>(stated_size(rest_.value(), name));
    beginning_.bytes = read_up_to(rest_.value(), kBeginningBytes, name, {});
}

InputFile Input::read_all() && {
    if (rest_.value() < 0) return std::move(beginning_);
    const std::string& name = beginning_.name;
    refuse_above(kMaxFileBytes, stated_size(rest_.value(), name), name);
    if (beginning_.bytes.size() == kBeginningBytes) {
        beginning_.bytes =
            io::read_all(rest_.value(), kMaxFileBytes, name, std::move(beginning_.bytes));
    }
    return std::move(beginning_);
}

OpenPieces Input::open_pieces() && {
    const std::string& name = beginning_.name;
    if (rest_.value() < 0) return pieces_of_memory(std::move(beginning_.bytes));
    const std::uint64_t stated = stated_size(rest_.value(), name);
    refuse_above(kMaxFileBytes, stated, name);
    const off_t place = stated > 0 ? ::lseek(rest_.value(), 0, SEEK_CUR) : -1;
    if (place >= 0) {
        const auto begin = static_cast<std::uint64_t>(place) - beginning_.bytes.size();
        return pieces_of_file(std::move(rest_), name, begin);
    }
    std::string bytes = std::move(beginning_.bytes);
    if (bytes.size() == kBeginningBytes) {
        bytes = read_up_to(rest_.value(), kSmallBytes, name, std::move(bytes));
    }
    if (bytes.size() < kSmallBytes) return pieces_of_memory(std::move(bytes));
    return pieces_of_file(copy_of_pipe(rest_.value(), name, std::move(bytes)), name, 0);
}

InputFile read_input(const std::filesystem::path& path, const BeginningCheck& check) {
    Input input(path);
    if (check) check(input.beginning());
    return std::move(input).read_all();
}

}  // namespace quadcut::io
