// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/numbers.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "quadcut/base/error.hpp"

namespace quadcut {

double number_of(const std::string& word, const std::string& what) {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || read != end || !std::isfinite(value)) {
        throw InputError(what + ": '" + word + "': expected a number of metres");
    }
    return value;
}

Point point_of(const std::string& x, const std::string& y) {
    return {number_of(x, "X"), number_of(y, "Y")};
}

}  // namespace quadcut
