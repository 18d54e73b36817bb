// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadcut::io {

/// What a batch does with files that are there and that quadcut has not written.
enum class ForeignFiles : std::uint8_t { refuse, replace };

/// What a batch must not take the place of.
struct Protected {
    /// Files that the run reads, by any of their names, be they there or yet to be made.
    std::vector<std::filesystem::path> inputs;
    ForeignFiles foreign = ForeignFiles::refuse;
};

/// Files of one folder that appear together: each is written under a temporary name, and commit()
/// gives all of them their own, or none. Whatever happens, no file is half-written, and a batch
/// that is not committed leaves files and folders as they were, and nothing of its own; what a
/// program leaves that is killed while it writes goes when the same files are next written.
class FileBatch {
public:
    explicit FileBatch(std::filesystem::path folder, Protected keep = {});
    FileBatch(FileBatch&&) = default;
    FileBatch& operator=(FileBatch&&) = delete;
    FileBatch(const FileBatch&) = delete;
    FileBatch& operator=(const FileBatch&) = delete;
    ~FileBatch();

    /// One more file that the run reads.
    void protect(std::filesystem::path input) { keep_.inputs.push_back(std::move(input)); }

    /// Says which files the run is going to add, so that it ends before its work is done and not
    /// after. Throws InputError that names the file when there is one that this batch must not take
    /// the place of (see Protected; is_own_file() says what is foreign), or a folder. Also done by
    /// add().
    void require_free(std::span<const std::string> names) const;

    /// A file, `name` relative to the folder, which is made if need be, with those above. Throws
    /// InputError that names the file when it cannot be written, or as above.
    void add(const std::string& name, std::string_view bytes);

    /// The names of what was added since the last commit, in order.
    [[nodiscard]] std::vector<std::string> names() const;

    /// Throws InputError that names the file that cannot be put in its place; those before it are
    /// as they were then.
    void commit();

private:
    struct Entry {
        std::string name;
        std::filesystem::path temporary;
        std::filesystem::path path;
    };

    void require_free(const std::filesystem::path& path) const;
    void make_folder(const std::filesystem::path& folder);

    std::filesystem::path folder_;
    Protected keep_;
    std::vector<Entry> entries_;
    /// Folders that were not there before, in the order they were made.
    std::vector<std::filesystem::path> new_folders_;
};

}  // namespace quadcut::io
