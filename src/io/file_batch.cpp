// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_batch.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "io/authorship.hpp"
#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

/// How a file was put in its place.
enum class Placed : std::uint8_t { new_name, exchanged, replaced };

/// Gives `from` the name `to`. What had it is then called `from`, where the file system can do
/// that: so it can be put back.
Placed put_in_place(const std::filesystem::path& from, const std::filesystem::path& to,
                    std::error_code& error) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) {
        return Placed::exchanged;
    }
    const Placed placed = errno == ENOENT ? Placed::new_name : Placed::replaced;
    std::filesystem::rename(from, to, error);
    return placed;
}

/// Between a file's name and the number of the process that writes it.
constexpr std::string_view kTemporary = ".new";

/// The file that a program was writing when it was killed, if that is what it left under this name;
/// otherwise nothing. Who calls a file of his own so keeps it: it must be a work of quadcut, or one
/// that was not even whole, whose name has the process twice.
std::filesystem::path left_behind_of(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::size_t end = name.rfind(kTemporary);
    if (end == std::string::npos) return {};
    ::pid_t process = 0;
    const char* const last = name.data() + name.size();
    const auto [after, error] =
        std::from_chars(name.data() + end + kTemporary.size(), last, process);
    if (error != std::errc{} || process <= 0) return {};
    const std::string_view rest(after, static_cast<std::size_t>(last - after));
    const bool is_part = rest.rfind(".tmp" + std::to_string(process) + "_", 0) == 0;
    if (!is_part && (!rest.empty() || !is_own_file(file))) return {};
    const bool is_alive = ::kill(process, 0) == 0 || errno != ESRCH;
    return is_alive ? std::filesystem::path{} : std::filesystem::path(name.substr(0, end));
}

/// Takes away what killed programs left of these files. O(files in their folders).
void remove_left_behind(const std::set<std::filesystem::path>& written) {
    std::set<std::filesystem::path> folders;
    for (const std::filesystem::path& path : written) folders.insert(path.parent_path());
    for (const std::filesystem::path& folder : folders) {
        std::error_code error;
        std::filesystem::directory_iterator file(folder.empty() ? "." : folder, error);
        for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
            const std::filesystem::path path = folder / file->path().filename();
            if (written.count(left_behind_of(path)) == 0) continue;
            std::error_code ignored;
            std::filesystem::remove(path, ignored);
        }
    }
}

/// By any of their names; also of a file that is yet to be made, as a project is.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    if (std::filesystem::exists(a, error)) return false;
    const auto place = [&error](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
    };
    return !b.empty() && place(a) == place(b) && !error;
}

/// What is there of the folders of a file that is not must be folders.
void require_folder_of(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path folder = path.parent_path();
    while (!folder.empty() && folder != folder.parent_path() &&
           !std::filesystem::exists(std::filesystem::symlink_status(folder, error))) {
        folder = folder.parent_path();
    }
    if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
    throw InputError(display_name(folder) + ": is no folder: expected one for " +
                     path.filename().string());
}

}  // namespace

FileBatch::FileBatch(std::filesystem::path folder, Protected keep)
    : folder_(std::move(folder)), keep_(std::move(keep)) {}

FileBatch::~FileBatch() {
    std::error_code ignored;
    for (const Entry& entry : entries_) std::filesystem::remove(entry.temporary, ignored);
    // Only those that are empty go.
    for (; !new_folders_.empty(); new_folders_.pop_back()) {
        std::filesystem::remove(new_folders_.back(), ignored);
    }
}

void FileBatch::require_free(std::span<const std::string> names) const {
    for (const std::string& name : names) require_free(folder_ / name);
}

void FileBatch::require_free(const std::filesystem::path& path) const {
    std::error_code error;
    for (const std::filesystem::path& input : keep_.inputs) {
        if (!is_same_file(path, input)) continue;
        throw InputError(display_name(path) +
                         ": is read by this run, and would be written over by its results: choose "
                         "another folder with -o");
    }
    const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) return require_folder_of(path);
    if (!std::filesystem::exists(status)) {
        throw InputError(display_name(path) + ": cannot be written: " + error.message());
    }
    if (std::filesystem::is_directory(path, error)) {
        throw InputError(display_name(path) + ": cannot be written: it is a folder");
    }
    if (keep_.foreign == ForeignFiles::replace || is_own_file(path)) return;
    throw InputError(display_name(path) +
                     ": is there, and not written by quadcut: choose another folder with -o, or "
                     "write over it with --force");
}

void FileBatch::make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
    make_folder(folder.parent_path());
    if (std::filesystem::create_directory(folder, error)) new_folders_.push_back(folder);
    // A path that ends in a slash was made with its parent; what another program made is as good.
    std::error_code ignored;
    if (error && !std::filesystem::is_directory(folder, ignored)) {
        throw InputError(display_name(folder) + ": the folder cannot be made: " + error.message());
    }
}

void FileBatch::add(const std::string& name, std::string_view bytes) {
    Entry entry;
    entry.name = name;
    entry.path = folder_ / name;
    entry.temporary = entry.path.string() + std::string(kTemporary) + std::to_string(::getpid());
    require_free(entry.path);
    make_folder(entry.path.parent_path());
    try {
        write_file_atomically(entry.temporary, bytes);
    } catch (const InputError& error) {
        // The reason, but not the temporary name, which would tell nobody anything.
        const std::string reason = error.what();
        const std::size_t name_length = display_name(entry.temporary).size();
        throw InputError(display_name(entry.path) +
                         (reason.size() > name_length ? reason.substr(name_length) : reason));
    }
    entries_.push_back(std::move(entry));
}

std::vector<std::string> FileBatch::names() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_) names.push_back(entry.name);
    return names;
}

void FileBatch::commit() {
    std::vector<Placed> placed;
    for (const Entry& entry : entries_) {
        std::error_code error;
        placed.push_back(put_in_place(entry.temporary, entry.path, error));
        if (!error) continue;
        std::error_code ignored;
        for (std::size_t i = 0; i + 1 < placed.size(); ++i) {
            if (placed[i] == Placed::new_name) std::filesystem::remove(entries_[i].path, ignored);
            if (placed[i] == Placed::exchanged) {
                std::filesystem::rename(entries_[i].temporary, entries_[i].path, ignored);
            }
        }
        throw InputError(display_name(entry.path) + ": cannot be replaced: " + error.message());
    }
    std::error_code ignored;
    std::set<std::filesystem::path> written;
    for (const Entry& entry : entries_) {
        std::filesystem::remove(entry.temporary, ignored);
        written.insert(entry.path);
    }
    remove_left_behind(written);
    entries_.clear();
    new_folders_.clear();
}

}  // namespace quadcut::io
