// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <mutex>

namespace quadcut::project {

/// Values of which more and more come, and none is changed: who notes how many there are reads just
/// these later, beside whoever adds.
template <typename Values>
class Growing {
public:
    void append(const Values& more) {
        const std::lock_guard lock(mutex_);
        values_.insert(values_.end(), more.begin(), more.end());
    }
    [[nodiscard]] std::size_t size() const {
        const std::lock_guard lock(mutex_);
        return values_.size();
    }
    /// Those from `first` on, up to `last`. @pre first <= last <= size()
    [[nodiscard]] Values between(std::size_t first, std::size_t last) const {
        const std::lock_guard lock(mutex_);
        return {values_.begin() + static_cast<std::ptrdiff_t>(first),
                values_.begin() + static_cast<std::ptrdiff_t>(last)};
    }

private:
    mutable std::mutex mutex_;
    Values values_;
};

}  // namespace quadcut::project
