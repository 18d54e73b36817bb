// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/format.hpp"

namespace quadcut::formats {

Format updates_format() {
    return {"updates",
            "what each scan changed, a line of JSON each",
            Part::updates,
            {"updates.jsonl"},
            [](const Result& result) { return contents(std::string(result.updates())); }};
}

}  // namespace quadcut::formats
