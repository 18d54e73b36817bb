// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

namespace quadcut::io {

// Numbers as text, the same on every machine and under every locale.

/// Millimetres, when the number is in metres.
inline constexpr int kMillimetreDecimals = 3;

/// Appends `value` rounded to `max_decimals`, without trailing zeros and never as -0: 12.5, 0.001,
/// 3. A number that is not finite becomes null.
void append_rounded(std::string& text, double value, int max_decimals);
[[nodiscard]] std::string rounded(double value, int max_decimals = kMillimetreDecimals);
/// With exactly so many decimals: 2.0. For people; the value is finite.
[[nodiscard]] std::string with_decimals(double value, int decimals);

/// Appends the shortest text that reads back as exactly `value`, always marked as a real number:
/// 0.05, 1.0, 1e-09. A number that is not finite becomes NaN, Infinity or -Infinity.
void append_exact(std::string& text, double value);
[[nodiscard]] std::string exact(double value);

}  // namespace quadcut::io
