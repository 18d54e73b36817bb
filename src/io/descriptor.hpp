// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

namespace quadcut::io {

/// An open file or folder, closed at the end; negative: none.
class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();

    [[nodiscard]] int value() const { return value_; }
    /// Whether everything that was written has reached the file.
    [[nodiscard]] bool close();

private:
    int value_;
};

}  // namespace quadcut::io
