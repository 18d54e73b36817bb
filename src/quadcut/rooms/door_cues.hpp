// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace quadcut {

inline constexpr std::size_t kNumDoorCues = 111;

/// What the number of a cue is; ratios and areas are logarithms.
enum class CueUnit : std::uint8_t { metres, ratio, log_square_metres, plain };

/// A cue of the door model: its name in samples and JSON, and what it is for people.
struct DoorCue {
    std::string_view name;
    std::string_view text;
    CueUnit unit = CueUnit::plain;
};

/// Of what door_cues() measures, in its order. Whoever adds a cue adds its line.
// clang-format off
inline constexpr std::array<DoorCue, kNumDoorCues> kDoorCues{
    {{"half_width_m", "half the width of the opening", CueUnit::metres},
     {"narrower_peak_1.5", "width of the narrower side within 1.5 m, over the opening's", CueUnit::ratio},
     {"narrower_peak_3", "width of the narrower side within 3 m, over the opening's", CueUnit::ratio},
     {"narrower_peak_5", "width of the narrower side within 5 m, over the opening's", CueUnit::ratio},
     {"wider_peak_1.5", "width of the wider side within 1.5 m, over the opening's", CueUnit::ratio},
     {"wider_peak_3", "width of the wider side within 3 m, over the opening's", CueUnit::ratio},
     {"wider_peak_5", "width of the wider side within 5 m, over the opening's", CueUnit::ratio},
     {"narrower_reach", "how deep the narrower side is, over the width of the opening", CueUnit::plain},
     {"wider_reach", "how deep the wider side is, over the width of the opening", CueUnit::plain},
     {"narrower_area_5", "area of the narrower side within 5 m, over the opening's square", CueUnit::ratio},
     {"wider_area_5", "area of the wider side within 5 m, over the opening's square", CueUnit::ratio},
     {"narrower_area_3_m2", "area of the narrower side within 3 m", CueUnit::log_square_metres},
     {"wider_area_3_m2", "area of the wider side within 3 m", CueUnit::log_square_metres},
     {"less_thin_wall_m", "thin wall in line with the opening, at the jamb with less", CueUnit::metres},
     {"more_thin_wall_m", "thin wall in line with the opening, at the jamb with more", CueUnit::metres},
     {"less_flush_wall_m", "wall flush with the opening, on the face with less", CueUnit::metres},
     {"more_flush_wall_m", "wall flush with the opening, on the face with more", CueUnit::metres},
     {"border_ratio", "length of the border over the width of the opening", CueUnit::plain},
     {"widening_1_less_m", "how far the side that widens more widens, at the jamb with less", CueUnit::metres},
     {"widening_1_more_m", "how far the side that widens more widens, at the jamb with more", CueUnit::metres},
     {"widening_2_less_m", "how far the side that widens less widens, at the jamb with less", CueUnit::metres},
     {"widening_2_more_m", "how far the side that widens less widens, at the jamb with more", CueUnit::metres},
     {"jamb_distance_m", "distance of the jambs", CueUnit::metres},
     {"narrower_spread_3", "how far the narrower side spreads sideways within 3 m, over half the opening", CueUnit::ratio},
     {"wider_spread_3", "how far the wider side spreads sideways within 3 m, over half the opening", CueUnit::ratio},
     {"less_spread_3", "sideways spread within 3 m on the side with less, over half the opening", CueUnit::ratio},
     {"more_spread_3", "sideways spread within 3 m on the side with more, over half the opening", CueUnit::ratio},
     {"narrower_spread_5", "how far the narrower side spreads sideways within 5 m, over half the opening", CueUnit::ratio},
     {"wider_spread_5", "how far the wider side spreads sideways within 5 m, over half the opening", CueUnit::ratio},
     {"narrower_region_m2", "area of the narrower side", CueUnit::log_square_metres},
     {"wider_region_m2", "area of the wider side", CueUnit::log_square_metres},
     {"narrower_region_peak", "largest width of the narrower side, over the opening's", CueUnit::ratio},
     {"wider_region_peak", "largest width of the wider side, over the opening's", CueUnit::ratio},
     {"narrower_elongation", "length of the narrower side over its width", CueUnit::ratio},
     {"wider_elongation", "length of the wider side over its width", CueUnit::ratio},
     {"narrower_openings", "number of openings of the narrower side", CueUnit::plain},
     {"wider_openings", "number of openings of the wider side", CueUnit::plain},
     {"less_line_m", "walls in line with the opening, at the jamb with less", CueUnit::metres},
     {"more_line_m", "walls in line with the opening, at the jamb with more", CueUnit::metres},
     {"free_half_width_m", "half the width of the opening, with furniture", CueUnit::metres},
     {"free_narrower_peak_1.5", "width of the narrower side within 1.5 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_narrower_peak_3", "width of the narrower side within 3 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_narrower_peak_5", "width of the narrower side within 5 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_wider_peak_1.5", "width of the wider side within 1.5 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_wider_peak_3", "width of the wider side within 3 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_wider_peak_5", "width of the wider side within 5 m, over the opening's, with furniture", CueUnit::ratio},
     {"free_narrower_reach", "how deep the narrower side is, over the width of the opening, with furniture", CueUnit::plain},
     {"free_wider_reach", "how deep the wider side is, over the width of the opening, with furniture", CueUnit::plain},
     {"free_narrower_area_5", "area of the narrower side within 5 m, over the opening's square, with furniture", CueUnit::ratio},
     {"free_wider_area_5", "area of the wider side within 5 m, over the opening's square, with furniture", CueUnit::ratio},
     {"free_narrower_area_3_m2", "area of the narrower side within 3 m, with furniture", CueUnit::log_square_metres},
     {"free_wider_area_3_m2", "area of the wider side within 3 m, with furniture", CueUnit::log_square_metres},
     {"free_less_thin_wall_m", "thin wall in line with the opening, at the jamb with less, with furniture", CueUnit::metres},
     {"free_more_thin_wall_m", "thin wall in line with the opening, at the jamb with more, with furniture", CueUnit::metres},
     {"free_less_flush_wall_m", "wall flush with the opening, on the face with less, with furniture", CueUnit::metres},
     {"free_more_flush_wall_m", "wall flush with the opening, on the face with more, with furniture", CueUnit::metres},
     {"free_border_ratio", "length of the border over the width of the opening, with furniture", CueUnit::plain},
     {"free_widening_1_less_m", "how far the side that widens more widens, at the jamb with less, with furniture", CueUnit::metres},
     {"free_widening_1_more_m", "how far the side that widens more widens, at the jamb with more, with furniture", CueUnit::metres},
     {"free_widening_2_less_m", "how far the side that widens less widens, at the jamb with less, with furniture", CueUnit::metres},
     {"free_widening_2_more_m", "how far the side that widens less widens, at the jamb with more, with furniture", CueUnit::metres},
     {"free_jamb_distance_m", "distance of the jambs, with furniture", CueUnit::metres},
     {"free_narrower_spread_3", "how far the narrower side spreads sideways within 3 m, over half the opening, with furniture", CueUnit::ratio},
     {"free_wider_spread_3", "how far the wider side spreads sideways within 3 m, over half the opening, with furniture", CueUnit::ratio},
     {"free_less_spread_3", "sideways spread within 3 m on the side with less, over half the opening, with furniture", CueUnit::ratio},
     {"free_more_spread_3", "sideways spread within 3 m on the side with more, over half the opening, with furniture", CueUnit::ratio},
     {"free_narrower_spread_5", "how far the narrower side spreads sideways within 5 m, over half the opening, with furniture", CueUnit::ratio},
     {"free_wider_spread_5", "how far the wider side spreads sideways within 5 m, over half the opening, with furniture", CueUnit::ratio},
     {"free_narrower_region_m2", "area of the narrower side, with furniture", CueUnit::log_square_metres},
     {"free_wider_region_m2", "area of the wider side, with furniture", CueUnit::log_square_metres},
     {"free_narrower_region_peak", "largest width of the narrower side, over the opening's, with furniture", CueUnit::ratio},
     {"free_wider_region_peak", "largest width of the wider side, over the opening's, with furniture", CueUnit::ratio},
     {"free_narrower_elongation", "length of the narrower side over its width, with furniture", CueUnit::ratio},
     {"free_wider_elongation", "length of the wider side over its width, with furniture", CueUnit::ratio},
     {"free_narrower_openings", "number of openings of the narrower side, with furniture", CueUnit::plain},
     {"free_wider_openings", "number of openings of the wider side, with furniture", CueUnit::plain},
     {"free_less_line_m", "walls in line with the opening, at the jamb with less, with furniture", CueUnit::metres},
     {"free_more_line_m", "walls in line with the opening, at the jamb with more, with furniture", CueUnit::metres},
     {"share_in_line", "share of the border in a gap of a wall", CueUnit::plain},
     {"less_wall_m", "wall at the end of that gap with less", CueUnit::metres},
     {"more_wall_m", "wall at the end of that gap with more", CueUnit::metres},
     {"free_share_in_line", "share of the border in a gap of a wall, with furniture", CueUnit::plain},
     {"free_less_wall_m", "wall at the end of that gap with less, with furniture", CueUnit::metres},
     {"free_more_wall_m", "wall at the end of that gap with more, with furniture", CueUnit::metres},
     {"narrow_solidity", "share of its convex hull that the narrower side fills", CueUnit::plain},
     {"narrow_thickness_m", "width of the smallest rectangle around the narrower side", CueUnit::metres},
     {"narrow_aspect", "length of that rectangle around the narrower side over its width", CueUnit::ratio},
     {"narrow_fill", "share of that rectangle that the narrower side fills", CueUnit::plain},
     {"narrow_open_share", "share of the border of the narrower side that is open to the unknown", CueUnit::plain},
     {"narrow_width_m", "mean width of the narrower side", CueUnit::metres},
     {"narrow_free_width_m", "mean width of the narrower side, with furniture", CueUnit::metres},
     {"wide_solidity", "share of its convex hull that the wider side fills", CueUnit::plain},
     {"wide_thickness_m", "width of the smallest rectangle around the wider side", CueUnit::metres},
     {"wide_aspect", "length of that rectangle around the wider side over its width", CueUnit::ratio},
     {"wide_fill", "share of that rectangle that the wider side fills", CueUnit::plain},
     {"wide_open_share", "share of the border of the wider side that is open to the unknown", CueUnit::plain},
     {"wide_width_m", "mean width of the wider side", CueUnit::metres},
     {"wide_free_width_m", "mean width of the wider side, with furniture", CueUnit::metres},
     {"joined_solidity", "share of its convex hull that both sides together fill", CueUnit::plain},
     {"joined_thickness_m", "width of the smallest rectangle around both sides together", CueUnit::metres},
     {"joined_aspect", "length of that rectangle around both sides together over its width", CueUnit::ratio},
     {"joined_fill", "share of that rectangle that both sides together fill", CueUnit::plain},
     {"joined_open_share", "share of the border of both sides together that is open to the unknown", CueUnit::plain},
     {"joined_width_m", "mean width of both sides together", CueUnit::metres},
     {"joined_free_width_m", "mean width of both sides together, with furniture", CueUnit::metres},
     {"width_ratio", "mean width of the narrower side over that of the wider", CueUnit::ratio},
     {"hull_growth", "convex hull of both sides together over the sum of both", CueUnit::ratio},
     {"less_open_line_m", "open floor in line with the opening, at the jamb with less", CueUnit::metres},
     {"more_open_line_m", "open floor in line with the opening, at the jamb with more", CueUnit::metres},
     {"less_free_line_m", "open floor in line with the opening, at the jamb with less, with furniture", CueUnit::metres},
     {"more_free_line_m", "open floor in line with the opening, at the jamb with more, with furniture", CueUnit::metres}}};
// clang-format on

}  // namespace quadcut
