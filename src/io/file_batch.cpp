// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_batch.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
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

/// Whether a file is what a program left that was killed while it wrote one of this name.
bool is_left_behind(const std::string& file, const std::string& name) {
    if (file.compare(0, name.size(), name) != 0) return false;
    std::string_view end = std::string_view(file).substr(name.size());
    if (end.substr(0, kTemporary.size()) != kTemporary) return false;
    end.remove_prefix(kTemporary.size());
    ::pid_t process = 0;
    const auto [after, error] = std::from_chars(end.data(), end.data() + end.size(), process);
    // What follows the number is of a file that was not even whole.
    const std::string_view rest = end.substr(static_cast<std::size_t>(after - end.data()));
    if (error != std::errc{} || process <= 0) return false;
    if (!rest.empty() && rest.substr(0, 4) != ".tmp") return false;
    return ::kill(process, 0) != 0 && errno == ESRCH;
}

void remove_left_behind(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    for (const auto& file : std::filesystem::directory_iterator(folder, error)) {
        if (!is_left_behind(file.path().filename().string(), path.filename().string())) continue;
        std::error_code ignored;
        std::filesystem::remove(file.path(), ignored);
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
    for (const Entry& entry : entries_) {
        std::filesystem::remove(entry.temporary, ignored);
        remove_left_behind(entry.path);
    }
    entries_.clear();
    new_folders_.clear();
}

}  // namespace quadcut::io
