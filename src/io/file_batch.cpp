// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_batch.hpp"

#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {

FileBatch::FileBatch(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) {
        throw InputError(display_name(folder_) + ": the folder cannot be made: " + error.message());
    }
}

FileBatch::~FileBatch() {
    std::error_code ignored;
    for (const Entry& entry : entries_) std::filesystem::remove(entry.temporary, ignored);
}

void FileBatch::add(const std::string& name, std::string_view bytes) {
    Entry entry;
    entry.path = folder_ / name;
    entry.temporary = folder_ / (name + ".new" + std::to_string(::getpid()));
    std::error_code ignored;
    if (std::filesystem::is_directory(entry.path, ignored)) {
        throw InputError(display_name(entry.path) + ": cannot be written: it is a folder");
    }
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

void FileBatch::commit() {
    for (const Entry& entry : entries_) {
        std::error_code error;
        std::filesystem::rename(entry.temporary, entry.path, error);
        if (error) {
            throw InputError(display_name(entry.path) + ": cannot be replaced: " + error.message());
        }
    }
    entries_.clear();
}

}  // namespace quadcut::io
