// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/base/run_options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

void add_fields(RunOptions& options, std::vector<OptionField>& fields) {
    fields.push_back({"threads", "", 1, 256, "threads; the result does not depend on it", "",
                      &options.num_threads, Decides::run});
}

}  // namespace quadcut
