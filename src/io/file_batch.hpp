// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quadcut::io {

/// Files of one folder that appear together: each is written under a temporary name, and commit()
/// gives them their own. Whatever happens, no file is half-written, and a batch that is not
/// committed leaves the files that were there as they were, and nothing of its own.
class FileBatch {
public:
    /// Makes the folder, and those above it, if need be. Throws InputError that names it when that
    /// fails, or when it is a file.
    explicit FileBatch(std::filesystem::path folder);
    FileBatch(const FileBatch&) = delete;
    FileBatch& operator=(const FileBatch&) = delete;
    ~FileBatch();

    /// Throws InputError that names the file when it cannot be written.
    void add(const std::string& name, std::string_view bytes);

    /// Throws InputError that names the file when it cannot be put in its place; those before it
    /// have been then.
    void commit();

private:
    struct Entry {
        std::filesystem::path temporary;
        std::filesystem::path path;
    };

    std::filesystem::path folder_;
    std::vector<Entry> entries_;
};

}  // namespace quadcut::io
