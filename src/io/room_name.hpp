// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

namespace quadcut::io {

/// A name as it is kept: without the spaces at its ends. Throws InputError unless it is UTF-8 of 1
/// to 200 characters, none of which controls the text around it.
[[nodiscard]] std::string trimmed_room_name(std::string_view name);

}  // namespace quadcut::io
