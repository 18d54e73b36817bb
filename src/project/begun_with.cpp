// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/begun_with.hpp"

#include <string>
#include <vector>

#include "io/file.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {
namespace {

void require_same_options(const std::string& name, FollowOptions project, FollowOptions given) {
    const std::vector<OptionField> had = option_fields(project);
    const std::vector<OptionField> has = option_fields(given);
    for (std::size_t i = 0; i < had.size(); ++i) {
        const std::string before = io::option_text(had[i]);
        const std::string now = io::option_text(has[i]);
        if (had[i].decides != Decides::result || before == now) continue;
        std::string what = name;
        what.append(": was begun with ").append(had[i].name).append(" = ").append(before);
        throw InputError(what.append(": expected the same for this run, not ").append(now));
    }
}

}  // namespace

void require_begun_with(const ProjectFile& file, const FollowOptions& options,
                        const ScanPosition& source) {
    const std::string name = io::display_name(file.path());
    const std::optional<ScanPosition>& had = file.progress().position;
    if (!had) throw InputError(name + ": follows no log: expected a project of this one");
    if (had->source_hash != source.source_hash) {
        throw InputError(name + ": follows another log, " + had->source +
                         ", or had other poses: expected the same log");
    }
    require_same_options(name, file.options(), options);
}

}  // namespace quadcut::project
