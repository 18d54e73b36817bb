// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace quadcut::io {

/// An open file or folder, closed at the end; negative: none.
class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();

    [[nodiscard]] int value() const { return value_; }
    /// Whether everything that was written has reached the file.
    [[nodiscard]] bool close();

private:
    int value_;
};

// What files and pipes are read with. `name` stands in messages. Errors throw InputError.

/// Refuses what has no end: devices, folders.
[[nodiscard]] Descriptor open_to_read(const std::filesystem::path& path, const std::string& name);

/// What a file says of its own length; 0 for pipes. Refuses as open_to_read().
[[nodiscard]] std::uint64_t stated_size(int descriptor, const std::string& name);

/// `bytes` and what is read after them, `end` bytes in all or up to the file's end.
[[nodiscard]] std::string read_up_to(int descriptor, std::size_t end, const std::string& name,
                                     std::string bytes);

/// `bytes` and all that comes after them; refuses more than `max_bytes`.
[[nodiscard]] std::string read_all(int descriptor, std::uint64_t max_bytes, const std::string& name,
                                   std::string bytes);
void refuse_above(std::uint64_t max_bytes, std::uint64_t size, const std::string& name);

/// Whether all was written; if not, errno says why.
[[nodiscard]] bool write_all(int descriptor, std::string_view bytes);

/// "NAME: WHAT: the reason of `error_number`".
[[noreturn]] void fail_with(const std::string& name, const std::string& what, int error_number);

}  // namespace quadcut::io
