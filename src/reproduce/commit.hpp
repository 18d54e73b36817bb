// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

namespace quadcut::reproduce {

/// The commit that this program was built from, "-dirty" behind it when more than documents
/// differed; "unknown" when it was built without a repository.
[[nodiscard]] std::string built_commit();

}  // namespace quadcut::reproduce
