// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/poses.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "io/fields.hpp"
#include "io/file_kind.hpp"
#include "io/input.hpp"
#include "io/line_reader.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

enum class PoseFormat { tum, g2o };

[[noreturn]] void fail(const Line& line, const std::string& name, const std::string& what) {
    throw InputError(name + ": line " + std::to_string(line.number) + ": " + what + ", found " +
                     quote(line.text));
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The next `Count` fields as finite numbers; nothing when one is anything else.
template <std::size_t Count>
std::optional<std::array<double, Count>> next_numbers(Fields& fields) {
    std::array<double, Count> numbers{};
    for (double& number : numbers) {
        const std::optional<double> value = fields.next_number();
        if (!value || !std::isfinite(*value)) return std::nullopt;
        number = *value;
    }
    return numbers;
}

/// The turn about z of a quaternion of any length; nothing when it has none.
std::optional<double> yaw_of(double x, double y, double z, double w) {
    const double length = std::hypot(std::hypot(x, y), std::hypot(z, w));
    constexpr double kMinLength = 1e-6;
    if (!(length > kMinLength) || !std::isfinite(length)) return std::nullopt;
    x /= length;
    y /= length;
    z /= length;
    w /= length;
    return std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
}

/// "time x y z qx qy qz qw", as a line of TUM and the rest of a VERTEX_SE3:QUAT have it.
TimedPose parse_spatial(Fields& fields, const Line& line, const std::string& name) {
    const auto numbers = next_numbers<8>(fields);
    if (!numbers) fail(line, name, "expected eight finite numbers t x y z qx qy qz qw");
    const auto& [time, x, y, z, qx, qy, qz, qw] = *numbers;
    const std::optional<double> yaw = yaw_of(qx, qy, qz, qw);
    if (!yaw) fail(line, name, "expected a quaternion that is not zero");
    return {time, {x, y, *yaw}};
}

TimedPose parse_planar(Fields& fields, const Line& line, const std::string& name) {
    const auto numbers = next_numbers<4>(fields);
    if (!numbers) fail(line, name, "expected four finite numbers id x y yaw after VERTEX_SE2");
    const auto& [id, x, y, yaw] = *numbers;
    return {id, {x, y, yaw}};
}

}  // namespace

std::vector<TimedPose> parse_poses(std::string_view bytes, const std::string& name) {
    if (bytes.empty()) throw InputError(name + ": the file is empty, expected poses (TUM or g2o)");
    std::vector<TimedPose> poses;
    std::optional<PoseFormat> format;
    LineReader lines(bytes, name);
    while (const std::optional<Line> line = lines.next()) {
        Fields fields(line->text);
        Fields tagged_fields = fields;
        const std::string_view tag = tagged_fields.next();
        if (tag.empty() || tag.starts_with('#')) continue;
        if (line->too_long) fail(*line, name, "expected a shorter line");
        if (!format) format = is_letter(tag[0]) ? PoseFormat::g2o : PoseFormat::tum;
        if (*format == PoseFormat::tum) {
            poses.push_back(parse_spatial(fields, *line, name));
        } else if (tag == "VERTEX_SE2") {
            poses.push_back(parse_planar(tagged_fields, *line, name));
        } else if (tag == "VERTEX_SE3:QUAT") {
            poses.push_back(parse_spatial(tagged_fields, *line, name));
        } else if (!is_letter(tag[0])) {
            fail(*line, name, "expected an entry of a g2o file");
        }
    }
    if (poses.empty()) {
        throw InputError(name + ": no pose in it, expected TUM lines or g2o's VERTEX_SE2");
    }
    return poses;
}

std::vector<TimedPose> read_poses(const std::filesystem::path& path) {
    const InputFile file = read_input(path, [](const InputFile& beginning) {
        // By content only: whatever its name, a file may hold poses.
        const FileNature nature = find_file_nature(beginning.bytes, "");
        if (nature.what.empty() || nature.kind == FileKind::poses) return;
        throw InputError(describe_refusal(beginning.bytes, beginning.name, "poses (TUM or g2o)"));
    });
    return parse_poses(file.bytes, file.name);
}

}  // namespace quadcut::io
