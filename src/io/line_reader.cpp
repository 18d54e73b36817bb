// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/line_reader.hpp"

#include <algorithm>
#include <utility>

namespace quadcut::io {
namespace {

/// What editors of Windows put before UTF-8.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

LineReader::LineReader(Pieces pieces, std::string name, LineLimits limits)
    : limits_(limits), pieces_(std::move(pieces)), pending_(pieces_()) {
    if (!is_gzip(pending_)) return;
    inflater_.emplace(pending_, std::move(name), limits.max_total_bytes, std::move(pieces_));
    pending_ = {};
}

bool LineReader::refill() {
    pending_ = inflater_ ? inflater_->next() : pieces_();
    return !pending_.empty();
}

std::optional<Line> LineReader::next() {
    carried_.clear();
    bool spans_pieces = false;
    Line line;
    while (true) {
        if (pending_.empty() && !refill()) {
            if (!spans_pieces) return std::nullopt;
            line.ended = false;
            break;
        }
        const std::size_t length = pending_.find('\n');
        line.ended = length != std::string_view::npos;
        const std::string_view part = pending_.substr(0, length);
        pending_.remove_prefix(part.size() + (line.ended ? 1 : 0));
        if (line.ended && !spans_pieces) {
            line.text = part;
            break;
        }
        spans_pieces = true;
        // One byte over the limit is enough to know that it was passed.
        carried_.append(part.substr(0, limits_.max_line_bytes + 1 - carried_.size()));
        if (line.ended) break;
    }
    if (spans_pieces) line.text = carried_;
    line.number = ++line_number_;
    if (line.number == 1 && line.text.starts_with(kByteOrderMark)) {
        line.text.remove_prefix(kByteOrderMark.size());
    }
    line.too_long = line.text.size() > limits_.max_line_bytes;
    line.text = line.text.substr(0, limits_.max_line_bytes);
    if (!line.too_long && line.text.ends_with('\r')) line.text.remove_suffix(1);
    return line;
}

}  // namespace quadcut::io
